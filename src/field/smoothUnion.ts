/**
 * R-function union a + b + √(a² + b²) (Pasko et al.; Kravtsov et al. §1.2): the surface of the hard union, but C¹ off
 * the curve where both surfaces meet. No distance: where a = b the value is (2 + √2) a or (2 − √2) a.
 *
 * Departure: where a + b < 0 it is 2 a b / (a + b − q), which does not cancel: as printed the sign is wrong in 1.5e-4 of
 * log-uniform pairs in float32. q is scaled by the larger operand, or squares under- and overflow.
 */
import { monotone, type Operation } from './operation.ts';

export const smoothUnion: Operation = {
  value: smoothUnionValue,
  evaluate(a, b, out) {
    const q = length(a, b);
    out[0] = smoothUnionValue(a, b);
    // at a = b = 0 no direction is better than another
    out[1] = q > 0 ? share(a, b, q) : 1;
    out[2] = q > 0 ? share(b, a, q) : 1;
  },
  stretch: 2,
  isExtreme: true,
  range: monotone(smoothUnionValue),
  // a = b is the worst case
  reach: (level) => -level / (2 - Math.SQRT2),
};

export function smoothUnionValue(a: number, b: number): number {
  const sum = a + b;
  const q = length(a, b);
  return sum < 0 ? 2 * a * (b / (sum - q)) : sum + q;
}

/** 1 + a/q, of which nothing is left for a = −q. */
function share(a: number, b: number, q: number): number {
  return a < 0 ? (b / q) * (b / (q - a)) : 1 + a / q;
}

function length(a: number, b: number): number {
  const large = Math.max(Math.abs(a), Math.abs(b));
  if (large === 0) return 0;
  const ratio = Math.min(Math.abs(a), Math.abs(b)) / large;
  return large * Math.sqrt(1 + ratio * ratio);
}
