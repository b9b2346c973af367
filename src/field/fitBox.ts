/**
 * The box of a body, nearly: its own is a bound, which for kernels that fall slowly is many times larger, and a lattice over it
 * would spend its nodes on air. Towards each of the six sides cubes are looked at from outside in: those that are proven to hold nothing
 * (near.ts) go, the foremost of the others is halved, until it is small beside the body.
 *
 * Tried: the box of what a coarse lattice finds inside, which lost legs thinner than a cell; halving all cubes that may hold surface,
 * which asked a tree of 63 segments ten times as much.
 */
import type { Vec3 } from '../math/vec.ts';
import { type Box, FieldError } from '../skeleton/skeleton.ts';
import { longest, meet } from './boxes.ts';
import type { Near } from './near.ts';

/** of the longest side of what is left: how large the foremost cubes are */
const FINE = 1 / 40;
/** of the first cube's half edge: what far skels may be missed by, twice as much each level; it makes no interval much wider */
const FIRST_MISSED = 1e-5;
/** cubes towards a side; more say nothing that is worth their time */
const MOST_CUBES = 400;

type Axis = 0 | 1 | 2;
const SIDES: readonly (readonly [axis: Axis, way: -1 | 1])[] = [
  [0, -1],
  [0, 1],
  [1, -1],
  [1, 1],
  [2, -1],
  [2, 1],
];

/** Holds all that is inside of `box`; null where that is nothing. Yields at each side. */
export function* fitting(whole: Near, box: Box): Generator<number, Box | null> {
  const half = longest(box) / 2;
  const first = cubeOf(whole, middleOf(box), half, FIRST_MISSED * half);
  let left = box;
  for (let fine = Infinity; fine > FINE * longest(left); ) {
    fine = FINE * longest(left);
    const ends: number[] = [];
    for (const [axis, way] of SIDES) {
      const end = first && endTowards(first, axis, way, fine);
      if (end === null) return null;
      ends.push(end);
      yield 0;
    }
    const [x0, x1, y0, y1, z0, z1] = ends as [number, number, number, number, number, number];
    const found = meet({ min: [x0, y0, z0], max: [x1, y1, z1] }, box);
    if (!found) return null;
    left = found;
  }
  return left;
}

/** Of the octree; what was found towards one side is there for the others. */
interface Cube {
  readonly centre: Vec3;
  readonly half: number;
  readonly near: Near;
  readonly missed: number;
  parts: readonly Cube[] | null;
}

/** Null where nothing is inside. */
function cubeOf(outer: Near, centre: Vec3, half: number, missed: number): Cube | null {
  const near = outer.within(...centre, half, missed);
  return near.high <= 0 ? null : { centre, half, near, missed, parts: null };
}

function partsOf({ centre: [x, y, z], half, near, missed }: Cube): readonly Cube[] {
  const by = half / 2;
  return Array.from({ length: 8 }, (_, i) => {
    const way = (bit: number) => (i & bit ? by : -by);
    return cubeOf(near, [x + way(1), y + way(2), z + way(4)], by, 2 * missed);
  }).filter((part) => part !== null);
}

/** How far anything may be inside; null where nothing is. */
function endTowards(first: Cube, axis: Axis, way: -1 | 1, fine: number): number | null {
  const open = [first];
  const reach = ({ centre, half }: Cube) => way * centre[axis] + half;
  for (let count = 0; open.length > 0; count++) {
    const at = open.reduce((best, cube, i) => (reach(cube) > reach(open[best]!) ? i : best), 0);
    const foremost = open[at]!;
    const isKnown = 2 * foremost.half <= fine || foremost.near.low > 0;
    if (isKnown || count >= MOST_CUBES) return way * reach(foremost);
    foremost.parts ??= partsOf(foremost);
    open[at] = open.at(-1)!;
    open.pop();
    open.push(...foremost.parts);
  }
  return null;
}

const middleOf = ({ min, max }: Box): Vec3 => [
  (min[0] + max[0]) / 2,
  (min[1] + max[1]) / 2,
  (min[2] + max[2]) / 2,
];

/** The box grown by a quarter on the sides (−x, x, −y, y, −z, z) where the body leaves its lattice; null where it does not. */
export function grownWhere(box: Box, exits: readonly boolean[]): Box | null {
  if (!exits.includes(true)) return null;
  const more = longest(box) / 4 || 1;
  const of = (end: 'min' | 'max'): Vec3 => {
    const by = (axis: 0 | 1 | 2) => {
      const grows = exits[2 * axis + (end === 'min' ? 0 : 1)];
      return box[end][axis] + (grows ? (end === 'min' ? -more : more) : 0);
    };
    return [by(0), by(1), by(2)];
  };
  const larger = { min: of('min'), max: of('max') };
  if (!larger.max.every(Number.isFinite)) throw new FieldError('the body has no end');
  return larger;
}
