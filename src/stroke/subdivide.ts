/**
 * Subdivision of quadratic (Chaikin) and cubic B-spline curves, open (clamped) and closed, and the counts it makes.
 *
 * Theory: one step doubles the knots and leaves the curve as it is (the rows and their sources: `masks.ts`).
 * Counts: closed N → 2N, open quadratic N → 2N − 2, open cubic N → 2N − 3.
 */
import type { Vec2 } from '../math/vec.ts';
import type { Degree } from './bspline.ts';
import { type Row, subdivisionRow } from './masks.ts';

/** The control points of the same curve with every span halved. RangeError below degree + 1 (open) or 3 points. */
export function subdivide(points: readonly Vec2[], degree: Degree, closed: boolean): Vec2[] {
  if (points.length < fewestControls(degree, closed)) {
    throw new RangeError(`subdivision of degree ${degree} needs more than ${points.length} points`);
  }
  const fine = fineCount(points.length, degree, closed, 1);
  return Array.from({ length: fine }, (_, i) =>
    applyRow(subdivisionRow(degree, closed, points.length, i), points),
  );
}

/** How many fine points `levels` subdivisions of `controls` points make. */
export function fineCount(controls: number, degree: Degree, closed: boolean, levels: number): number {
  return (controls - shared(degree, closed)) * (1 << levels) + shared(degree, closed);
}

/** How many control points lie `levels` below `fine` points, or null where that count is not admissible. */
export function coarseCount(fine: number, degree: Degree, closed: boolean, levels: number): number | null {
  const controls = (fine - shared(degree, closed)) / (1 << levels) + shared(degree, closed);
  return Number.isInteger(controls) && controls >= fewestControls(degree, closed) ? controls : null;
}

/** The smallest admissible count of fine points that is at least `atLeast`. */
export function admissibleCount(atLeast: number, degree: Degree, closed: boolean, levels: number): number {
  const k = shared(degree, closed);
  const controls = Math.ceil((atLeast - k) / (1 << levels)) + k;
  return fineCount(Math.max(controls, fewestControls(degree, closed)), degree, closed, levels);
}

/** The fewest control points that make a curve. */
export function fewestControls(degree: Degree, closed: boolean): number {
  return closed ? 3 : degree + 1;
}

/** The weighted sum of points that a row asks for; indices wrap. */
export function applyRow(row: Row, points: readonly Vec2[]): Vec2 {
  const n = points.length;
  let x = 0;
  let y = 0;
  row.weights.forEach(([numerator, denominator], k) => {
    const p = points[(((row.from + k) % n) + n) % n]!;
    x += (numerator * p[0]) / denominator;
    y += (numerator * p[1]) / denominator;
  });
  return [x, y];
}

/** control points of an open curve that its spans do not double: its degree */
function shared(degree: Degree, closed: boolean): number {
  return closed ? 0 : degree;
}
