/**
 * By how much a kernel's field changes when the point moves: what intervals of a field over a box are made of. Kernel units.
 *
 * Powers of a quadratic change in proportion to themselves, whatever the skel. With M² = core + r² and θ = by/M, a move takes
 * M^−n to M^−n (1 + 2xθ + θ²)^(−n/2), |x| ≤ 1: the generating function of the Gegenbauer polynomials, each largest at 1. So
 * what is left of the field after value and gradient is at most (1 − θ)^−n − 1 − nθ of it, however many points it comes from.
 * Its points are complex ones; close to the real ones, where the core counts, second derivatives along the way are two to five times
 * less (a third fewer bricks of a blob, whose field is of many such points).
 * The Gaussian's ratio has no bound far away, the quartic's none at its rim: there the derivatives in a direction count,
 * integrated over all that is farther than the nearest point, their positive and negative parts apart.
 */
import { rootPower } from './halfPower.ts';

/** A point that moves, and what comes of it. Mutable: filled again for each box. The numbers say that these are doubles. */
export class Step {
  /** the distance of the skel, not more than it is */
  r = 0.5;
  /** how far the point moves at most */
  by = 0.5;
  /** the distance at which it may then be */
  near = 0.5;
  /** n of the power kernel */
  exponent = 4.5;

  /** by which factors the field changes; Infinity where nothing is known */
  least = 0.5;
  most = 0.5;
  /** relative: what value and gradient leave out, in parts of the field; absolute: the second derivatives */
  bend = 0.5;
  /** absolute: the first derivatives */
  slope = 0.5;
}

export interface RelativeChange {
  readonly type: 'relative';
  /** the kernel is (core + r²)^(−n/2) */
  readonly core: 0 | 1;
  /** n, given that of the power kernel */
  power(exponent: number): number;
  /** Sees to least, most and bend for the field of points all at distance ≥ r. */
  factors(step: Step): void;
  /** Sees to bend as what the Taylor polynomial of the second degree leaves out. */
  cubic(step: Step): void;
}

/** A point, a line, a plane; the latter of weight 1. */
export type Dimension = 0 | 1 | 2;

export interface AbsoluteChange {
  readonly type: 'absolute';
  /**
   * Sees to slope and bend: the most that derivatives come to, in any direction, over what is farther than `near`. Of the
   * positive and the negative part the larger, which holds weights from 0 to 1; its double holds those from −1 to 1.
   */
  slopes(step: Step, dimension: Dimension): void;
}

export type Change = RelativeChange | AbsoluteChange;

/** Below, the first terms cancel, and the rest of Taylor's series is as good. */
const SMALL = 1e-3;
const SMALL_CUBE = 1e-2;
/** r² up to which second derivatives are asked, too, where there is a core; pieces of the way for them. 16 pruned as much. */
const BENT_UP_TO = 6;
const PIECES = 4;

/** Of (core + r²)^(−n/2); `n` where the kernel has it fixed. */
export const powerChange = (core: 0 | 1, n?: number): RelativeChange => new PowerChange(core, n);

class PowerChange implements RelativeChange {
  readonly type = 'relative';
  readonly core: 0 | 1;
  readonly #n: number | undefined;

  constructor(core: 0 | 1, n: number | undefined) {
    this.core = core;
    this.#n = n;
  }

  power(exponent: number): number {
    return this.#n ?? exponent;
  }

  factors(step: Step): void {
    const { core } = this;
    const { r, by } = step;
    const power = this.power(step.exponent);
    // where the ratios of M are extreme, if that is farther than r
    const root = Math.sqrt(by * by + 4 * core);
    const high = Math.max(r, 0.5 * (root + by));
    const low = Math.max(r, 0.5 * (root - by));
    const near = Math.max(high - by, 0);
    const after = core + near * near;
    const fall = (core + low * low) / (core + (low + by) * (low + by));
    const rise = (core + high * high) / after;
    // powers here in so many words: calls would put their numbers on the heap
    step.least = power === 4 ? fall * fall : rootPower(fall, power);
    step.most = !(after > 0) ? Infinity : power === 4 ? rise * rise : rootPower(rise, power);
    const theta = by / Math.sqrt(core + r * r);
    step.bend = theta < 1 ? bend(theta, power) : Infinity;
    if (r * r < BENT_UP_TO * core) step.bend = Math.min(step.bend, by * by * this.#bent(r, by, power));
  }

  /** ∫ (1 − t) f″ of a way of `by` towards points at distance ≥ r, in parts of their field: at most, piece by piece. */
  #bent(r: number, by: number, n: number): number {
    const { core } = this;
    let sum = 0;
    for (let i = 1; i <= PIECES; i++) {
      const moved = (i / PIECES) * by;
      const high = Math.max(r, 0.5 * (Math.sqrt(moved * moved + 4 * core) + moved));
      const rise = (core + high * high) / (core + (high - moved) * (high - moved));
      const grown = n === 4 ? rise * rise : rootPower(rise, n);
      const left = Math.max(r - moved, 0);
      sum += (PIECES - i + 0.5) * grown * steepest(core, left * left, n);
    }
    return sum / (PIECES * PIECES);
  }

  cubic(step: Step): void {
    const theta = step.by / Math.sqrt(this.core + step.r * step.r);
    step.bend = theta < 1 ? cubic(theta, this.power(step.exponent)) : Infinity;
  }
}

/** The largest second derivative of the kernel in any direction at that squared distance or farther, in parts of the kernel there. */
function steepest(core: number, r2: number, n: number): number {
  const q = 1 / (core + r2);
  const across = n * q;
  const along =
    r2 * (n + 1) < core * (n + 3)
      ? (n * (n + 1) * (n + 1)) / (4 * (n + 2) * core)
      : across * ((n + 1) * r2 - core) * q;
  return along > across ? along : across;
}

function bend(theta: number, n: number): number {
  const left = 1 - theta;
  const i = 1 / (left * left);
  const grown = n === 4 ? i * i : rootPower(i, n);
  if (theta < SMALL) return (0.5 * n * (n + 1) * theta * theta * grown) / (left * left);
  return grown - 1 - n * theta;
}

function cubic(theta: number, n: number): number {
  const left = 1 - theta;
  const i = 1 / (left * left);
  const grown = n === 4 ? i * i : rootPower(i, n);
  const third = (n * (n + 1) * (n + 2)) / 6;
  if (theta < SMALL_CUBE) return (third * theta * theta * theta * grown) / (left * left * left);
  return grown - 1 - n * theta * (1 + 0.5 * (n + 1) * theta);
}
