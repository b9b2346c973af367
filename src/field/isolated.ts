/**
 * What no corner of the lattice comes near: groups of bricks that may hold surface, as far as is proven, but have no corner inside, and that no brick
 * with one touches. Most hold nothing. From some of their middles the field is followed upwards, to the ridge of what may be thinner
 * than any cell: steep kernels, bodies that a matrix has flattened. Holes in the midst of a body likewise, with all signs the other way round.
 */
import { add3, length3, scale3, sub3 } from '../math/tuple.ts';
import type { Vec3 } from '../math/vec.ts';
import { around, type Bricks } from './bricks.ts';
import { BRICK } from './lattice.ts';
import { type Crossed, surfacePoint } from './surfacePoint.ts';
import { THIN, type ThinSpot } from './thinWalls.ts';
import { turned } from './unseen.ts';

/** groups that are looked into, and bricks of each */
const GROUPS = 64;
const TRIES = 6;
/** cells to a ridge from the middle of its brick; turns on the way, which needles need */
const FARTHEST = 4;
const TURNS = 3;
/** halvings of that way */
const STEPS = 20;

const value = new Float64Array(4);
const beside = new Int32Array(27);

/** Places in `active` of bricks without a corner inside, and of those without one outside. */
export interface OneSided {
  readonly empty: number[];
  readonly full: number[];
}

export function isolatedSpots(whole: Crossed, bricks: Bricks, { empty, full }: OneSided): ThinSpot[] {
  const gaps = spotsIn(turned(whole), bricks, full).map((spot) => ({ ...spot, isGap: true }));
  return [...spotsIn(whole, bricks, empty), ...gaps];
}

function spotsIn(whole: Crossed, bricks: Bricks, empty: readonly number[]): ThinSpot[] {
  const open = new Set(empty);
  const spots: ThinSpot[] = [];
  let groups = 0;
  for (const first of empty) {
    const group = open.has(first) ? groupOf(first, bricks, open) : null;
    if (!group || ++groups > GROUPS) continue;
    const every = Math.ceil(group.length / TRIES);
    const spot = group
      .filter((_, i) => i % every === 0)
      .map((place) => ridgeIn(whole, bricks, place, group))
      .find((found) => found !== null);
    if (spot) spots.push(spot);
  }
  return spots;
}

/** Takes it out of `open`; null where a brick with a corner inside touches it. */
function groupOf(first: number, bricks: Bricks, open: Set<number>): readonly number[] | null {
  const group = [first];
  const seen = new Set(group);
  let isAlone = true;
  for (const place of group) {
    around(bricks, bricks.active[place]!, beside);
    for (const next of beside) {
      if (next < 0 || seen.has(next)) continue;
      if (!open.has(next)) {
        isAlone = false;
        continue;
      }
      seen.add(next);
      group.push(next);
    }
  }
  for (const place of group) open.delete(place);
  return isAlone ? group : null;
}

function ridgeIn(whole: Crossed, bricks: Bricks, place: number, group: readonly number[]): ThinSpot | null {
  const { step, origin } = bricks.lattice;
  const brick = bricks.active[place]!;
  const middle = (axis: 0 | 1 | 2, at: number) => origin[axis] + BRICK * (at + 0.5) * step;
  let at: Vec3 = [middle(0, brick.i), middle(1, brick.j), middle(2, brick.k)];
  for (let turn = 0; turn < TURNS; turn++) {
    whole.evaluate(...at, value);
    const way = direction(value[1]!, value[2]!, value[3]!);
    if (!way) return null;
    const from = at;
    at = add3(from, scale3(way, highest(whole, from, way, FARTHEST * step)));
    if (whole.value(...at) > 0) return isIn(at, bricks, group) ? spotAt(whole, at, way, step) : null;
  }
  return null;
}

/** How far from a point the field no longer rises along a unit vector; far from steep kernels its values do not tell, its gradient does. */
function highest(field: Crossed, from: Vec3, way: Vec3, farthest: number): number {
  let [low, high] = [0, farthest];
  for (let i = 0; i < STEPS; i++) {
    const middle = (low + high) / 2;
    field.evaluate(...add3(from, scale3(way, middle)), value);
    const rises = value[1]! * way[0] + value[2]! * way[1] + value[3]! * way[2] > 0;
    [low, high] = rises ? [middle, high] : [low, middle];
  }
  return (low + high) / 2;
}

/** Null where there is none; its square may be below all numbers. */
function direction(x: number, y: number, z: number): Vec3 | null {
  const most = Math.max(Math.abs(x), Math.abs(y), Math.abs(z));
  if (!(most > 0 && most < Infinity)) return null;
  const scaled: Vec3 = [x / most, y / most, z / most];
  return scale3(scaled, 1 / length3(scaled));
}

/** What is elsewhere the mesh has. */
function isIn(at: Vec3, { lattice, counts, grid }: Bricks, group: readonly number[]): boolean {
  const brick = (axis: 0 | 1 | 2) => Math.floor((at[axis] - lattice.origin[axis]) / (BRICK * lattice.step));
  const [i, j, k] = [brick(0), brick(1), brick(2)];
  const isWithin = i >= 0 && j >= 0 && k >= 0 && i < counts[0] && j < counts[1] && k < counts[2];
  return isWithin && group.includes(grid[i + counts[0] * (j + counts[1] * k)]!);
}

/** From side to side along the way that one came; as thick as a cell where that goes on inside. */
function spotAt(field: Crossed, at: Vec3, way: Vec3, step: number): ThinSpot {
  const inside = field.value(...at);
  const [p, q] = [-1, 1].map((side) => {
    const end = add3(at, scale3(way, side * THIN * step));
    const beyond = field.value(...end);
    return beyond > 0 ? null : surfacePoint(field, at, end, inside, beyond).at;
  });
  return { at, thickness: p && q ? length3(sub3(p, q)) : step, across: THIN, isGap: false };
}
