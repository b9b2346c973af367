/**
 * Uniform cubic B-splines by subdivision (thesis 5.5.2, [BS00]): one direction of a net, clamped (end knots fourfold) or periodic.
 *
 * Halving all knots of a clamped spline with N points leaves 2N − 3 (Boehm's insertion in every middle, written out); of a
 * periodic one 2N. Departure: control points are still 8e-3 of a random net away from the surface after four subdivisions
 * (measured), so they are pushed to their limits by the masks of positions and derivatives at knots: then they are the
 * basis functions' own values (equation 3.4) to rounding.
 */

export type Ends = 'clamped' | 'periodic';

/** One result: Σ weights[k] · point[from + k], counted round where the spline is periodic. */
export interface Stencil {
  readonly from: number;
  readonly weights: readonly number[];
}

/** Results in order. */
export type Mask = readonly Stencil[];

/** Control points of a spline with `spans` spans between knots: clamped at least 1, periodic 3. */
export function controlCount(spans: number, ends: Ends): number {
  return ends === 'clamped' ? spans + 3 : spans;
}

/** From `count` control points to those of twice as many spans. RangeError below 4 (clamped) or 3 (periodic) points. */
export const subdivisionMask = cached((count, ends) => {
  enough(count, ends);
  if (ends === 'periodic') {
    return rounds(2 * count, (j) =>
      j % 2 === 0 ? at(j / 2 - 1, 1 / 8, 3 / 4, 1 / 8) : at((j - 1) / 2, 1 / 2, 1 / 2),
    );
  }
  return mirrored(2 * count - 3, count, (j) => clampedSubdivision(j, count));
});

/** Positions at the knots: spans + 1 of a clamped spline, spans of a periodic one. */
export const limitMask = cached((count, ends) => {
  enough(count, ends);
  if (ends === 'periodic') return rounds(count, (k) => at(k - 1, 1 / 6, 2 / 3, 1 / 6));
  return mirrored(count - 2, count, (k) => {
    if (k === 0) return at(0, 1);
    if (count === 5) return at(1, 1 / 4, 1 / 2, 1 / 4);
    return k === 1 ? at(1, 1 / 4, 7 / 12, 1 / 6) : at(k, 1 / 6, 2 / 3, 1 / 6);
  });
});

/** Derivatives there, per span. */
export const slopeMask = cached((count, ends) => {
  enough(count, ends);
  if (ends === 'periodic') return rounds(count, (k) => at(k - 1, -1 / 2, 0, 1 / 2));
  const slope = (k: number): Stencil => {
    if (k === 0) return at(0, -3, 3);
    if (count === 5) return at(1, -3 / 4, 0, 3 / 4);
    return k === 1 ? at(1, -3 / 4, 1 / 4, 1 / 2) : at(k, -1 / 2, 0, 1 / 2);
  };
  return mirrored(count - 2, count, slope, -1);
});

/** A mask depends on two numbers alone, and patches ask for a few of them again and again. */
function cached(make: (count: number, ends: Ends) => Mask): (count: number, ends: Ends) => Mask {
  const known = { clamped: new Map<number, Mask>(), periodic: new Map<number, Mask>() };
  return (count, ends) => {
    const masks = known[ends];
    const kept = masks.get(count);
    if (kept) return kept;
    const mask = make(count, ends);
    if (masks.size >= MOST_MASKS) masks.clear();
    masks.set(count, mask);
    return mask;
  };
}

/** kept of each kind */
const MOST_MASKS = 64;

function clampedSubdivision(j: number, count: number): Stencil {
  if (j === 0) return at(0, 1);
  if (j === 1) return at(0, 1 / 2, 1 / 2);
  if (j === 2) return count === 4 ? at(1, 1 / 2, 1 / 2) : at(1, 3 / 4, 1 / 4);
  if (j === 3) return count === 5 ? at(1, 3 / 16, 5 / 8, 3 / 16) : at(1, 3 / 16, 11 / 16, 1 / 8);
  return j % 2 === 0 ? at(j / 2, 1 / 2, 1 / 2) : at((j - 1) / 2, 1 / 8, 3 / 4, 1 / 8);
}

/** The second half is the first one backwards; `sign` −1 for derivatives. */
function mirrored(results: number, count: number, half: (j: number) => Stencil, sign: 1 | -1 = 1): Mask {
  return rounds(results, (j) => {
    const back = results - 1 - j;
    if (j <= back) return half(j);
    const { from, weights } = half(back);
    return { from: count - from - weights.length, weights: weights.map((w) => sign * w).reverse() };
  });
}

function rounds(results: number, stencil: (j: number) => Stencil): Mask {
  return Array.from({ length: results }, (_, j) => stencil(j));
}

function at(from: number, ...weights: number[]): Stencil {
  return { from, weights };
}

function enough(count: number, ends: Ends): void {
  const least = ends === 'clamped' ? 4 : 3;
  if (!(count >= least)) throw new RangeError(`a ${ends} cubic spline needs ${least} points, got ${count}`);
}
