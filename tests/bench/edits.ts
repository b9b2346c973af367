/** One of 100 parts of a union moved: what it costs against the whole. */
import type { FieldNode } from '../../src/field/node.ts';
import { measured } from './polygonizing.ts';
import { sceneNode } from './scenes/index.ts';
import { rounded } from './timing.ts';

const ROWS = 10;
const APART = 1.2;
const CELLS = process.env.ROTUND_FULL === undefined ? [128] : [128, 256];

/** Ten rows of small trees, the one in the middle moved by `by` mm. */
function garden(by: number): FieldNode {
  const tree = sceneNode('tree16');
  const parts = Array.from({ length: ROWS * ROWS }, (_, i): FieldNode => {
    const x = APART * (i % ROWS) + (i === 45 ? by : 0);
    return {
      type: 'affine',
      matrix: [1, 0, 0, x, 0, 1, 0, 0, 0, 0, 1, APART * Math.floor(i / ROWS)],
      node: tree,
    };
  });
  return { type: 'union', form: 'hard', parts };
}

/** Nothing is kept from one mesh to the next yet: the edit is the whole. */
const edited = (_before: FieldNode, after: FieldNode, cells: number) => measured(after, cells);

export function timeEdits(): void {
  const rows = CELLS.map((cells) => {
    const whole = measured(garden(0), cells);
    const edit = edited(garden(0), garden(0.05), cells);
    return {
      cells,
      'whole, M': rounded(whole.work / 1e6, 2),
      'edit, M': rounded(edit.work / 1e6, 2),
      share: rounded(edit.work / whole.work, 3),
      'whole, ms': rounded(whole.milliseconds),
      'edit, ms': rounded(edit.milliseconds),
    };
  });
  console.log('\nOne of 100 parts moved');
  console.table(rows);
}
