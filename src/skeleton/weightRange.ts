/** The largest |w| of a polynomial weight along its line, and its sign where it has one: by Bernstein's coefficients, which hold it. */
import type { LineFrame } from '../kernel/kernel.ts';

export interface WeightRange {
  /** not less than |w| */
  readonly most: number;
  /** 1 or −1 where w surely has no other sign */
  readonly sign: number;
  /** not less than the largest |w| over the least */
  readonly evenness: number;
}

export function weightRange({ weights: w, length: l }: Pick<LineFrame, 'weights' | 'length'>): WeightRange {
  const [a0, a1, a2, a3] = [w[0]!, w[1]! * l, w[2]! * l * l, w[3]! * l * l * l];
  const b = [a0, a0 + a1 / 3, a0 + (2 * a1 + a2) / 3, a0 + a1 + a2 + a3];
  const [low, high] = [Math.min(...b), Math.max(...b)];
  const sign = low >= 0 ? 1 : high <= 0 ? -1 : 0;
  const most = Math.max(high, -low);
  return { most, sign, evenness: sign === 0 ? Infinity : most / Math.min(Math.abs(low), Math.abs(high)) };
}
