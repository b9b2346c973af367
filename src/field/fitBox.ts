/**
 * The box of what a lattice finds inside. A field's own box is a bound, which for kernels that fall slowly is many times
 * larger than the body: a lattice over it would spend its nodes on air.
 */
import { type Box, FieldError } from '../skeleton/skeleton.ts';
import { grown, meet } from './boxes.ts';
import { type Lattice, type LatticeValues, latticeAround, sampling } from './lattice.ts';
import type { TreeField } from './treeField.ts';

/** cells along the box: 14 000 values a round */
const COARSE = 24;
/** the box of 1/r is at worst some hundred times larger than its body */
const ROUNDS = 6;
/** a box that shrinks by less is good */
const SHRINKS = 0.85;

/** steps around the greatest value in which a body is looked for that fell between all nodes */
const NEAR = 2;

/**
 * Much of the body, if anything of it was found: what is thinner than a cell may stick out, and lies across the border of the
 * finer lattice then (see `crossed`). Where nothing is inside, what is nearest to it is looked at more closely; pieces
 * that are both apart from the others and small may be lost. Yields once a layer.
 */
export function* fitting(field: TreeField, box: Box): Generator<number, Box> {
  let around = box;
  for (let round = 0; round < ROUNDS; round++) {
    const lattice = latticeAround(around, COARSE);
    const values = yield* sampling(field, lattice);
    const found = insideBox(lattice, values);
    if (!found) {
      around = aboutGreatest(lattice, values);
      continue;
    }
    // never flat: both are bounds of the same body
    const tight = meet(grown(found, lattice.step), around) ?? around;
    if (longest(tight) > SHRINKS * longest(around)) return tight;
    around = tight;
  }
  return around;
}

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

function aboutGreatest({ origin, step, counts: [nx, ny] }: Lattice, values: LatticeValues): Box {
  let best = 0;
  values.forEach((value, i) => {
    if (value > values[best]!) best = i;
  });
  const [i, j, k] = [best % nx, Math.floor(best / nx) % ny, Math.floor(best / (nx * ny))];
  const at = [origin[0] + i * step, origin[1] + j * step, origin[2] + k * step] as const;
  return grown({ min: at, max: at }, NEAR * step);
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
