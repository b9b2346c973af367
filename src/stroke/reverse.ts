/**
 * Reverse subdivision: the coarse control points that a fine polygon may have come from; its details are dropped.
 *
 * Theory: the thesis, equation 4.1 and the cubic filter after it (rows: `masks.ts`). Exact for what was subdivided.
 * Departure: offered for comparison. As a noise filter it is weak, because it aliases noise into low frequencies: white
 * noise reaches the evaluated curve with a gain of 0.72 / 0.73 / 0.75 (quadratic) or 0.70 / 0.80 / 0.93 (cubic) at levels
 * 1 / 2 / 3, where least squares reaches 0.71 / 0.51 / 0.36 (`noise.test.ts`).
 */
import type { Vec2 } from '../math/vec.ts';
import type { Degree } from './bspline.ts';
import { reverseRow } from './masks.ts';
import { applyRow, coarseCount } from './subdivide.ts';

/** One level coarser. RangeError when the number of points is not admissible (see `admissibleCount`). */
export function reverseSubdivide(fine: readonly Vec2[], degree: Degree, closed: boolean): Vec2[] {
  const controls = coarseCount(fine.length, degree, closed, 1);
  if (controls === null) {
    const kind = closed ? 'closed' : 'open';
    throw new RangeError(`${fine.length} points do not come from a ${kind} subdivision of degree ${degree}`);
  }
  return Array.from({ length: controls }, (_, j) => applyRow(reverseRow(degree, closed, controls, j), fine));
}

/** Several levels at once. */
export function reverseLevels(
  fine: readonly Vec2[],
  degree: Degree,
  closed: boolean,
  levels: number,
): Vec2[] {
  let points = [...fine];
  for (let level = 0; level < levels; level++) points = reverseSubdivide(points, degree, closed);
  return points;
}
