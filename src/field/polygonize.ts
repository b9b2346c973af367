/**
 * The surface of a field as a mesh: bricks of cells where it may be (bricks.ts), values there (brickValues.ts), marching cubes
 * (brickMesh.ts). Watertight, with vertices on the surface, the field's own normals and colours, and sharp edges where the
 * tree has them. Work follows the surface: Kravtsov et al. §1.2.3 and Zhu et al. §4 sample the whole volume instead.
 *
 * The steps are generators that yield the share done of the step they are at, so that a worker may pause or give up between
 * them; `polygonize` runs all of them at once.
 */
import { finished } from '../math/finished.ts';
import type { Box } from '../skeleton/skeleton.ts';
import { BrickMesh, type FieldMesh } from './brickMesh.ts';
import { type Bricks, culling } from './bricks.ts';
import { BrickValues } from './brickValues.ts';
import { fitting, grownWhere } from './fitBox.ts';
import { type Lattice, latticeAround, latticeOver } from './lattice.ts';
import { type Near, Tally } from './near.ts';
import type { TreeField } from './treeField.ts';

export interface Polygonized {
  readonly mesh: FieldMesh;
  readonly lattice: Lattice;
  /** all that was asked of skels, in values of one skel at one point (skeleton/work.ts) */
  readonly evaluations: number;
  readonly bricks: Bricks;
}

/** mm to all sides of the origin: what is seen of bodies without end, such as half-spaces */
export const PAGE = 100;

/** A body that still leaves its lattice after so many rounds is cut off there. */
export const ROUNDS = 6;
/** bricks between two looks at the clock */
const BATCH = 16;

/** The share of the time that it takes to locate a body. */
const LOCATED = 0.6;

/** The same steps, whose share is one from `first` to `last` of something larger. */
function* partOf<T>(steps: Generator<number, T>, first: number, last: number): Generator<number, T> {
  for (;;) {
    const { done, value } = steps.next();
    if (done) return value;
    yield first + (last - first) * value;
  }
}

/** Runs to the end; see `polygonizing`. */
export function polygonize(field: TreeField, resolution: number, box: Box | null = field.box): Polygonized {
  return finished(polygonizing(field, resolution, box));
}

/** What a field is asked through, and the lattice of its body. */
export interface Fitted {
  readonly whole: Near;
  readonly tally: Tally;
  readonly lattice: Lattice;
  /** around all that is inside */
  readonly box: Box;
}

/** The same, and where its surface may be. */
export interface Located extends Omit<Fitted, 'lattice'> {
  readonly bricks: Bricks;
}

/**
 * `resolution` cells along the longest side of the body in `box`, which is fitted to the body, and grown where the body leaves
 * it. Without a box the body has no end, and is cut off at `PAGE`. FieldError for a box of no finite numbers.
 */
export function* polygonizing(
  field: TreeField,
  resolution: number,
  box: Box | null = field.box,
): Generator<number, Polygonized> {
  let within = box;
  let before = 0;
  for (let round = 0; ; round++) {
    const located = yield* partOf(locating(field, resolution, within), 0, LOCATED);
    const { mesh, exits } = yield* partOf(meshing(located), LOCATED, 1);
    const larger = within && round < ROUNDS ? grownWhere(within, exits) : null;
    const { bricks, tally } = located;
    const evaluations = before + tally.work;
    if (!larger) return { mesh, lattice: bricks.lattice, evaluations, bricks };
    before = evaluations;
    within = larger;
  }
}

/** The lattice of a body in `box`, as above. */
export function* latticed(
  field: TreeField,
  resolution: number,
  box: Box | null = field.box,
): Generator<number, Fitted> {
  const tally = new Tally();
  const whole = field.near(tally);
  const { lattice, around } = yield* fittedLattice(whole, box, resolution);
  return { whole, tally, lattice, box: around };
}

/** Around what is inside of `box`; null: over the page. */
export function* fittedLattice(whole: Near, box: Box | null, resolution: number) {
  if (!box) {
    const around: Box = { min: [-PAGE, -PAGE, -PAGE], max: [PAGE, PAGE, PAGE] };
    return { lattice: latticeOver(PAGE, resolution), around };
  }
  // a lattice where nothing is makes an empty mesh
  const around: Box = (yield* fitting(whole, box)) ?? box;
  return { lattice: latticeAround(around, resolution), around };
}

/** The bricks of a body in `box`. */
export function* locating(
  field: TreeField,
  resolution: number,
  box: Box | null = field.box,
): Generator<number, Located> {
  const { lattice, ...fitted } = yield* latticed(field, resolution, box);
  return { ...fitted, bricks: yield* culling(fitted.whole, lattice) };
}

/** The mesh of all bricks, and whether it was cut off at each side of the lattice: −x, x, −y, y, −z, z. */
export function* meshing({ whole, tally, bricks }: Located) {
  const values = new BrickValues(whole, bricks, tally);
  const mesh = new BrickMesh(bricks, values, tally);
  for (const [place, brick] of bricks.active.entries()) {
    mesh.add(brick, values.fill(place));
    if (place % BATCH === 0) yield place / bricks.active.length;
  }
  return { mesh: mesh.mesh(), exits: values.exits };
}
