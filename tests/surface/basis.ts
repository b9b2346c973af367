/** Cubic basis functions by Cox and de Boor's recursion, as the thesis prints it (equation 3.5, with 0/0 = 0): independent truth. */
import type { Ends } from '../../src/surface/bspline.ts';

function recursion(knots: readonly number[], k: number, order: number, t: number): number {
  if (order === 1) return t >= knots[k]! && t < knots[k + 1]! ? 1 : 0;
  const share = (x: number, width: number) => (width === 0 ? 0 : x / width);
  return (
    share(t - knots[k]!, knots[k + order - 1]! - knots[k]!) * recursion(knots, k, order - 1, t) +
    share(knots[k + order]! - t, knots[k + order]! - knots[k + 1]!) * recursion(knots, k + 1, order - 1, t)
  );
}

/** N′ = 3 (N_k / width − N_(k+1) / width) of one degree less. */
function slope(knots: readonly number[], k: number, t: number): number {
  const share = (i: number) => {
    const width = knots[i + 3]! - knots[i]!;
    return width === 0 ? 0 : recursion(knots, i, 3, t) / width;
  };
  return 3 * (share(k) - share(k + 1));
}

/** Weights of the control points (and their derivatives) at t from 0 to the number of spans; knot 0 of a periodic one is point 0's. */
export function basis(count: number, ends: Ends, t: number): { at: number[]; slope: number[] } {
  const at = new Array<number>(count).fill(0);
  const slopes = new Array<number>(count).fill(0);
  const spans = ends === 'clamped' ? count - 3 : count;
  // the recursion is 0 at the last knot: the limit from the left, by the mirrored spline
  if (ends === 'clamped' && t === spans) {
    const mirror = basis(count, ends, 0);
    return { at: mirror.at.reverse(), slope: mirror.slope.map((x) => -x).reverse() };
  }
  const knots =
    ends === 'clamped'
      ? Array.from({ length: count + 4 }, (_, i) => Math.min(Math.max(i - 3, 0), spans))
      : Array.from({ length: count + 8 }, (_, i) => i - 4);
  for (let k = 0; k + 4 < knots.length; k++) {
    // a periodic one: function k lies on knots k − 4 … k, about k − 2
    const point = ends === 'clamped' ? k : (k - 2 + count) % count;
    at[point]! += recursion(knots, k, 4, t);
    slopes[point]! += slope(knots, k, t);
  }
  return { at, slope: slopes };
}
