/**
 * Polygonizing scenes at rising resolutions: work against dense work (on the lattice fitted to the body, and on a cube of as many cells
 * to all sides, as tables of n³ have it), time against dense sampling, memory, errors of vertices.
 */
import { bindField } from '../../src/field/bind.ts';
import type { FieldNode } from '../../src/field/node.ts';
import { denseTime, type Measured, measured, peakMemory, vertexErrors } from './polygonizing.ts';
import { chair, chairsAsSum } from './scenes/chairs.ts';
import { quarticScene, sceneNode } from './scenes/index.ts';
import { carvedTree, warpedTree } from './scenes/trees.ts';
import { rounded } from './timing.ts';

const FULL = process.env.ROTUND_FULL !== undefined;
const listed = (name: string) => process.env[name]?.split(',');

/** cells along the longest side of the body */
const USUAL = FULL ? [64, 128, 256, 512] : [64, 128];
const CELLS = listed('ROTUND_CELLS')?.map(Number) ?? USUAL;

const SCENES: Readonly<Record<string, () => FieldNode>> = {
  tree16: () => sceneNode('tree16'),
  tree64: () => sceneNode('tree64'),
  tree178: () => sceneNode('tree178'),
  tree1024: () => sceneNode('tree1024'),
  blob200: () => sceneNode('blob200'),
  'quartic tree64': () => quarticScene('tree64'),
  'quartic tree178': () => quarticScene('tree178'),
  'carved tree64': carvedTree,
  'warped tree64': warpedTree,
  chair: () => chair(1),
  '100 chairs': () => chairsAsSum(10),
};
/** for full runs: minutes, or like another */
const HEAVY = ['100 chairs', 'quartic tree178'];
const CHOSEN = listed('ROTUND_SCENES') ?? Object.keys(SCENES).filter((name) => FULL || !HEAVY.includes(name));

/** skels asked for the errors of a mesh: of larger ones some vertices only, but never in a full run */
const ERRORS = FULL ? Infinity : 2e7;

export function timeScenes(): void {
  for (const name of CHOSEN) {
    const node = SCENES[name]?.();
    if (!node) throw new Error(`no scene '${name}': ${Object.keys(SCENES).join(', ')}`);
    const runs = CELLS.map((cells) => ({ cells, ...measured(node, cells) }));
    console.log(`\n${name}, ${runs[0]?.skels} skels`);
    console.table(runs.map((run, i) => rowOf(node, run, runs[i - 1])));
  }
}

interface Run extends Measured {
  readonly cells: number;
}

function rowOf(node: FieldNode, run: Run, before: Run | undefined) {
  const { cells, result, work, denseWork, milliseconds } = run;
  const field = bindField(node);
  const dense = denseTime(field, result.lattice);
  const vertices = result.mesh.positions.length / 3;
  const every = Math.max(1, Math.ceil((vertices * run.skels) / ERRORS));
  const { p999, most } = vertexErrors(field, result.mesh, result.lattice, every);
  return {
    cells,
    'dense work, M': rounded(denseWork / 1e6, 1),
    'work, M': rounded(work / 1e6, 2),
    'times fewer': rounded(denseWork / work, 1),
    'than a cube’s': rounded((run.skels * (cells + 1) ** 3) / work, 1),
    'exponent in n': before ? rounded(exponent(work / before.work, cells / before.cells), 2) : '',
    'dense, ms': rounded(dense.milliseconds),
    'of it taken': rounded(dense.share, 3),
    'ours, ms': rounded(milliseconds),
    'times faster': rounded(dense.milliseconds / milliseconds, 1),
    triangles: result.mesh.indices.length / 3,
    'MiB at most': rounded(peakMemory(node, cells), 1),
    'vertices looked at': Math.ceil(vertices / every),
    'off by, cells: 99.9 %': p999.toPrecision(2),
    most: most.toPrecision(2),
  };
}

const exponent = (more: number, larger: number) => Math.log(more) / Math.log(larger);

/**
 * How work grows with the number of skels k: in the same box, where density grows too, and at equal density, cells as large, from
 * one tree to sixteen.
 */
export function timeGrowth(): void {
  const work = (name: 'tree16' | 'tree64' | 'tree178' | 'tree1024', cells: number) =>
    measured(sceneNode(name), cells);
  const rows = CELLS.filter((cells) => cells <= 128).map((cells) => {
    const [few, some, several] = [work('tree16', cells), work('tree64', cells), work('tree178', cells)];
    const more = Math.round(sizeOf(work('tree1024', 16), 16) / some.result.lattice.step);
    const many = work('tree1024', more);
    const between = (a: Measured, b: Measured) => rounded(exponent(b.work / a.work, b.skels / a.skels), 2);
    return {
      cells,
      '16 → 64': between(few, some),
      '64 → 178': between(some, several),
      'cells of 1,024': more,
      '64 → 1,024, equal density': between(some, many),
      'bricks, so': exponent(bricksOf(many) / bricksOf(some), many.skels / some.skels).toFixed(2),
    };
  });
  console.log('\nExponents of work in k');
  console.table(rows);
}

/** mm, the longest side of the body; lattices have air around it, and whole bricks */
const sizeOf = ({ result: { lattice } }: Measured, cells: number) => lattice.step * cells;

const bricksOf = ({ result: { bricks } }: Measured) => bricks.active.length;
