/**
 * By how much a kernel's field changes when the point moves: what intervals of a field over a box are made of. Kernel units.
 *
 * Powers of a quadratic change in proportion to themselves, whatever the skel. With M² = core + r² and θ = by/M, a move takes
 * M^−n to M^−n (1 + 2xθ + θ²)^(−n/2), |x| ≤ 1: the generating function of the Gegenbauer polynomials, each largest at 1. So
 * what is left of the field after value and gradient is at most (1 − θ)^−n − 1 − nθ of it, however many points it comes from.
 * The Gaussian's ratio has no bound far away, the quartic's none at its rim: there the derivatives in a direction count,
 * integrated over all that is farther than the nearest point, their positive and negative parts apart.
 */
import { halfPower } from './halfPower.ts';

export interface RelativeChange {
  readonly type: 'relative';
  /**
   * Writes [least, most, bend]: by which factors the field of points all at distance ≥ `r` changes when it moves `by`, and what
   * value and gradient leave out, in parts of it. Infinity where nothing is known.
   */
  factors(r: number, by: number, exponent: number, out: Float64Array): void;
}

/** A point, a line, a plane; the latter of weight 1. */
export type Dimension = 0 | 1 | 2;

export interface AbsoluteChange {
  readonly type: 'absolute';
  /**
   * Writes the most that first and second derivatives come to, in any direction, over what is farther than r: the larger of the
   * positive and the negative part, so that any positive weights up to 1 are held by it, and others by its double.
   */
  slopes(dimension: Dimension, r2: number, out: Float64Array): void;
}

export type Change = RelativeChange | AbsoluteChange;

/** Below, 1 + nθ cancels, and the rest of Taylor's series is as good. */
const SMALL = 1e-3;

/** Of (core + r²)^(−n/2); `n` where the kernel has it fixed. */
export function powerChange(core: 0 | 1, n?: number): RelativeChange {
  return {
    type: 'relative',
    factors(r, by, exponent, out) {
      const power = n ?? exponent;
      // where the ratios of M are extreme, if that is farther than r
      const root = Math.sqrt(by * by + 4 * core);
      const high = Math.max(r, 0.5 * (root + by));
      const low = Math.max(r, 0.5 * (root - by));
      const near = Math.max(high - by, 0);
      out[0] = ratio(core + (low + by) * (low + by), core + low * low, power);
      out[1] = core + near * near > 0 ? ratio(core + near * near, core + high * high, power) : Infinity;
      const theta = by / Math.sqrt(core + r * r);
      out[2] = theta < 1 ? bend(theta, power) : Infinity;
    },
  };
}

const ratio = (after: number, before: number, n: number) => halfPower(after / before, n);

function bend(theta: number, n: number): number {
  const left = 1 - theta;
  const grown = halfPower(left * left, n);
  if (theta < SMALL) return (0.5 * n * (n + 1) * theta * theta * grown) / (left * left);
  return grown - 1 - n * theta;
}
