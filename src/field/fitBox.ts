/**
 * The box of a body, nearly: its own is a bound, which for kernels that fall slowly is many times larger, and a lattice over it
 * would spend its nodes on air. Cubes over it that are proven to hold nothing (TreeField.range) go, the others are halved, until
 * they are small beside what is left. Tried before: the box of what a coarse lattice finds inside, which lost legs thinner than a cell.
 */
import type { Vec3 } from '../math/vec.ts';
import { type Box, FieldError } from '../skeleton/skeleton.ts';
import { grown, meet, unite } from './boxes.ts';
import type { Lattice, LatticeValues } from './lattice.ts';
import type { TreeField } from './treeField.ts';

/** of the longest side of what is left: how large the last cubes are */
const FINE = 1 / 24;
/** cubes of a level; more say nothing that is worth their time */
const MOST_CUBES = 1 << 16;

/** Holds all that is inside of `box`; null where that is nothing. Yields once a level. */
export function* fitting(field: TreeField, box: Box): Generator<number, Box | null> {
  let half = longest(box) / 2;
  let cubes: readonly Vec3[] = [middleOf(box)];
  let solid: Box | null = null;
  const range = new Float64Array(2);
  for (;;) {
    const open: Vec3[] = [];
    for (const centre of cubes) {
      field.range(...centre, half, range);
      if (range[1]! <= 0) continue;
      if (range[0]! > 0) solid = around(solid, centre, half);
      else open.push(centre);
    }
    const left = open.reduce<Box | null>((all, centre) => around(all, centre, half), solid);
    if (!left) return null;
    if (2 * half <= FINE * longest(left) || open.length > MOST_CUBES || open.length === 0) {
      return meet(left, box);
    }
    yield 2 * half;
    half /= 2;
    cubes = open.flatMap((centre) => eighths(centre, half));
  }
}

const middleOf = ({ min, max }: Box): Vec3 => [
  (min[0] + max[0]) / 2,
  (min[1] + max[1]) / 2,
  (min[2] + max[2]) / 2,
];

function around(box: Box | null, centre: Vec3, half: number): Box {
  const own = grown({ min: centre, max: centre }, half);
  return (box && unite(box, own)) ?? own;
}

const eighths = ([x, y, z]: Vec3, half: number): Vec3[] =>
  [-half, half].flatMap((dx) =>
    [-half, half].flatMap((dy) => [-half, half].map((dz): Vec3 => [x + dx, y + dy, z + dz])),
  );

/** The box grown by a quarter on the sides where the inside reaches the lattice's border; null where it does not. */
export function crossed(box: Box, lattice: Lattice, values: LatticeValues): Box | null {
  const found = insideBox(lattice, values);
  if (!found) return null;
  const { origin, step, counts } = lattice;
  const more = longest(box) / 4 || step;
  let leaves = false;
  const side = (axis: 0 | 1 | 2, end: 'min' | 'max') => {
    const border = end === 'min' ? origin[axis] : origin[axis] + (counts[axis] - 1) * step;
    if (Math.abs(found[end][axis] - border) > step / 2) return box[end][axis];
    leaves = true;
    return box[end][axis] + (end === 'min' ? -more : more);
  };
  const of = (end: 'min' | 'max') => [side(0, end), side(1, end), side(2, end)] as const;
  const larger = { min: of('min'), max: of('max') };
  if (!larger.max.every(Number.isFinite)) throw new FieldError('the body has no end');
  return leaves ? larger : null;
}

function insideBox({ origin, step, counts }: Lattice, values: LatticeValues): Box | null {
  const low = [Infinity, Infinity, Infinity];
  const high = [-Infinity, -Infinity, -Infinity];
  for (let k = 0, at = 0; k < counts[2]; k++) {
    for (let j = 0; j < counts[1]; j++) {
      for (let i = 0; i < counts[0]; i++, at++) {
        if (!(values[at]! > 0)) continue;
        if (i < low[0]!) low[0] = i;
        if (i > high[0]!) high[0] = i;
        if (j < low[1]!) low[1] = j;
        if (j > high[1]!) high[1] = j;
        if (k < low[2]!) low[2] = k;
        if (k > high[2]!) high[2] = k;
      }
    }
  }
  if (low[0] === Infinity) return null;
  const place = (ends: readonly number[]) =>
    [origin[0] + ends[0]! * step, origin[1] + ends[1]! * step, origin[2] + ends[2]! * step] as const;
  return { min: place(low), max: place(high) };
}

function longest({ min, max }: Box): number {
  return Math.max(max[0] - min[0], max[1] - min[1], max[2] - min[2]);
}
