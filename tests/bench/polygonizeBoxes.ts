/**
 * The stored scenes in their own boxes, of exactly n cells along each side, as the targets are stated: work of each stage against all skels at
 * all nodes, exponents in n and in k at equal density, skels near a brick, time of the field stages (everything but triangles) and
 * of the whole against dense sampling, errors of vertices.
 */

import { bindField } from '../../src/field/bind.ts';
import { BrickMesh } from '../../src/field/brickMesh.ts';
import { culling } from '../../src/field/bricks.ts';
import { BrickValues } from '../../src/field/brickValues.ts';
import type { Lattice } from '../../src/field/lattice.ts';
import { Tally } from '../../src/field/near.ts';
import type { TreeField } from '../../src/field/treeField.ts';
import { finished } from '../../src/math/finished.ts';
import { nodeCount } from '../field/nodeCount.ts';
import { denseTime, vertexErrors } from './polygonizing.ts';
import { type SceneName, sceneNode } from './scenes/index.ts';
import { rounded } from './timing.ts';

/** mm, half of each box */
const SCENES = { tree16: 1, tree64: 1, tree178: 1, tree1024: 2.52, blob200: 1 } as const;
const CELLS = process.env.ROTUND_FULL === undefined ? [64, 128, 256] : [64, 128, 256, 512];
/** engines need some to know the code; large lattices take long */
const ROUNDS = { small: 8, large: 3 };
/** skels asked for the errors of a mesh */
const ERRORS = 4e7;

export function timeBoxes(): void {
  const chosen = process.env.ROTUND_SCENES?.split(',') ?? Object.keys(SCENES);
  for (const name of chosen.filter((one): one is keyof typeof SCENES => one in SCENES)) {
    const skels = sceneNode(name).skels.length;
    let before = 0;
    const rows = CELLS.map((cells) => {
      const { row, work } = rowOf(name, skels, cells);
      const exponent = before > 0 ? rounded(Math.log2(work / before), 2) : '';
      before = work;
      return { ...row, 'exponent in n': exponent };
    });
    console.log(`\n${name} in its box, ${skels} skels`);
    console.table(rows);
  }
}

function rowOf(name: SceneName & keyof typeof SCENES, skels: number, cells: number) {
  const half = SCENES[name];
  const counts = [cells + 1, cells + 1, cells + 1] as const;
  const lattice: Lattice = { origin: [-half, -half, -half], step: (2 * half) / cells, counts };
  const field = bindField(sceneNode(name));
  const runs = Array.from({ length: cells > 128 ? ROUNDS.large : ROUNDS.small }, () => run(field, lattice));
  const [{ work, mesh, bricks }] = runs as [(typeof runs)[number]];
  const least = (of: keyof (typeof runs)[number]['times']) => Math.min(...runs.map(({ times }) => times[of]));
  const [fields, whole] = [least('field'), least('whole')];
  const dense = denseTime(field, lattice);
  const vertices = mesh.positions.length / 3;
  const every = Math.max(1, Math.ceil((vertices * skels) / ERRORS));
  const { p999, most } = vertexErrors(field, mesh, lattice, every);
  const row = {
    cells,
    'work, M': rounded(work.all / 1e6, 3),
    'culling, values, vertices': [work.culling, work.values, work.vertices]
      .map((x) => rounded(x / 1e6, 2))
      .join(', '),
    'times fewer': rounded((skels * nodeCount(lattice)) / work.all, 0),
    bricks: bricks.active.length,
    'near each': rounded(
      bricks.active.reduce((sum, { near }) => sum + near.asked, 0) / bricks.active.length,
      1,
    ),
    'dense, ms': rounded(dense.milliseconds),
    'culling and values, ms': rounded(least('values')),
    'with vertices, ms': rounded(fields),
    'times faster': rounded(dense.milliseconds / fields, 1),
    'whole, ms': rounded(whole),
    'times faster, whole': rounded(dense.milliseconds / whole, 1),
    'off by, cells: 99.9 %': p999.toPrecision(2),
    most: most.toPrecision(2),
  };
  return { row, work: work.all };
}

/** Stage by stage, the field's being culling, values and vertices, the whole's triangles too; what the surface crosses of the box's sides is cut off. */
function run(field: TreeField, lattice: Lattice) {
  const tally = new Tally();
  const start = performance.now();
  const whole = field.near(tally);
  const bricks = finished(culling(whole, lattice));
  const culled = tally.work;
  const values = new BrickValues(whole, bricks, tally);
  const filled = bricks.active.map((_, place) => values.fill(place));
  const evaluated = tally.work;
  const between = performance.now();
  const mesh = new BrickMesh(bricks, values, tally);
  let triangles = 0;
  bricks.active.forEach((brick, place) => {
    if (!mesh.enter(brick, filled[place]!)) return;
    const placed = performance.now();
    mesh.join();
    triangles += performance.now() - placed;
  });
  const joined = performance.now();
  const made = mesh.mesh();
  const end = performance.now();
  return {
    mesh: made,
    bricks,
    work: { culling: culled, values: evaluated - culled, vertices: tally.work - evaluated, all: tally.work },
    times: { values: between - start, field: joined - start - triangles, whole: end - start },
  };
}
