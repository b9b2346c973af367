/** One of 100 parts of a union moved: what it costs against the whole. */

import { type LiveMade, LiveMesh } from '../../src/field/liveMesh.ts';
import type { FieldNode } from '../../src/field/node.ts';
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

export function timeEdits(): void {
  const rows = CELLS.map((cells) => {
    const live = new LiveMesh(cells);
    const first = timed(() => live.make(garden(0)));
    const edit = timed(() => live.make(garden(0.05)));
    return {
      cells,
      'whole, M': rounded(first.made.evaluations / 1e6, 2),
      'edit, M': rounded(edit.made.evaluations / 1e6, 2),
      share: rounded(edit.made.evaluations / first.made.evaluations, 3),
      bricks: edit.made.bricks.active.length,
      'of them renewed': edit.made.renewed,
      'whole, ms': rounded(first.milliseconds),
      'edit, ms': rounded(edit.milliseconds),
    };
  });
  console.log('\nOne of 100 parts moved');
  console.table(rows);
}

function timed(make: () => LiveMade) {
  const start = performance.now();
  const made = make();
  return { made, milliseconds: performance.now() - start };
}
