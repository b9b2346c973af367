/**
 * Σ λ_i F_i − T. The colour is the mean of those of the skels, weighted by what they add to the field beyond a thousandth of T:
 * less is not seen, and in float32 it may be a residue of either sign. What carves has no colour.
 */
import { Ball } from '../skeleton/ball.ts';
import { type Box, FieldError, type FieldValue, SPREAD, type Spread } from '../skeleton/skeleton.ts';
import { type BoundTerm, type Grain, UNSEEN } from './boundTerm.ts';
import { grown, unite } from './boxes.ts';
import { AROUND, closed, roundedHalf } from './closed.ts';
import type { LeafFrame } from './leafFrame.ts';
import type { Near, Tally } from './near.ts';
import { nearSum } from './nearSum.ts';
import type { LeafField, TreeField } from './treeField.ts';

/** FieldError when it is not above 0. */
export function checkThreshold(threshold: number): void {
  if (!(threshold > 0 && threshold < Infinity))
    throw new FieldError(`threshold must be above 0, got ${threshold}`);
}

/** mm, of the kernel where it is narrowest, and where it is widest. */
export interface Widths {
  readonly least: number;
  readonly most: number;
}

/** `widths` for kernels that have one. FieldError when there is nothing to add. */
export function skelSum(
  terms: readonly BoundTerm[],
  threshold: number,
  widths: Widths | null = null,
): LeafField {
  if (terms.length === 0) throw new FieldError('a body needs at least one skel');
  return new SkelSum(terms, threshold, grainOf(terms, threshold, widths));
}

/** Widths and reaches of the thickest skel over which a field falls by T about a surface, at least: tubes of radius 0.6/s to 0.8/s, thick ones. */
const FALL = { width: 1.2, reach: 2, singular: 1 };

/** Kernels without a width are nowhere wide enough: beside a singular point interpolants swing through 0. */
function grainOf(terms: readonly BoundTerm[], threshold: number, widths: Widths | null): Grain {
  const thick = terms.reduce((most, { field, factor }) => {
    const reach = field.offset(threshold / Math.abs(factor));
    return reach < Infinity ? Math.max(most, reach) : most;
  }, 0);
  // of weak skels that only together come to T nothing is known: nothing is missed then
  if (widths === null) return { width: 0, slope: thick > 0 ? (FALL.singular * threshold) / thick : 0 };
  return {
    width: widths.least,
    slope: threshold * Math.min(FALL.width / widths.most, thick > 0 ? FALL.reach / thick : Infinity),
  };
}

/** of T and the sum */
const ROUNDING = 4e-15;

class SkelSum implements LeafField {
  readonly #terms: readonly BoundTerm[];
  readonly #threshold: number;
  readonly #grain: Grain;
  readonly #spread = new Float64Array(SPREAD);
  readonly #ball = new Ball();
  readonly box: Box | null;

  constructor(terms: readonly BoundTerm[], threshold: number, grain: Grain) {
    this.#terms = terms;
    this.#grain = grain;
    this.#threshold = threshold;
    this.box = this.boxAbove(0);
  }

  value(x: number, y: number, z: number): number {
    let sum = -this.#threshold;
    for (const { field, factor } of this.#terms) sum += factor * field.value(x, y, z);
    return sum;
  }

  evaluate(x: number, y: number, z: number, out: FieldValue): void {
    out[0] = -this.#threshold;
    out[1] = 0;
    out[2] = 0;
    out[3] = 0;
    for (const { field, factor } of this.#terms) field.add(x, y, z, factor, out);
  }

  colour(x: number, y: number, z: number, out: Float64Array): number {
    let sum = -this.#threshold;
    let weight = 0;
    const unseen = UNSEEN * this.#threshold;
    out[0] = 0;
    out[1] = 0;
    out[2] = 0;
    for (const { field, factor, colour } of this.#terms) {
      const value = factor * field.value(x, y, z);
      sum += value;
      const seen = value - unseen;
      if (seen <= 0) continue;
      weight += seen;
      // a running mean: sums of singular fields would overflow
      const share = seen / weight;
      for (let i = 0; i < 3; i++) out[i]! += share * (colour[i]! - out[i]!);
    }
    // beyond every support: no surface comes here
    if (weight === 0) out.set(this.#terms[0]!.colour);
    return sum;
  }

  spread(x: number, y: number, z: number, radius: number, out: Spread): void {
    const threshold = this.#threshold;
    out.fill(0);
    const ball = this.#ball.set(x, y, z, radius);
    for (const { field, factor } of this.#terms) field.spread(ball, factor, out);
    // beyond every support nothing is rounded
    const margin = out[4]! > 0 ? ROUNDING * (threshold + Math.abs(out[0]!)) : 0;
    out[0] = out[0]! - threshold;
    out[4] = out[4]! + margin;
    out[5] = out[5]! - threshold - margin;
    out[6] = out[6]! - threshold + margin;
  }

  range(x: number, y: number, z: number, half: number, out: Float64Array): void {
    const grown = roundedHalf(x, y, z, half);
    this.spread(x, y, z, AROUND * grown, this.#spread);
    closed(this.#spread, grown, out);
  }

  near(tally: Tally): Near {
    return nearSum(this.#terms, this.#threshold, this.#grain, null, tally);
  }

  nearIn(frame: LeafFrame, _: TreeField, tally: Tally): Near {
    return nearSum(this.#terms, this.#threshold, this.#grain, frame, tally);
  }

  /** Beyond every skel's own box its term is below its even share of T + level. */
  boxAbove(level: number): Box | null {
    const needed = this.#threshold + level;
    if (!(needed > 0)) return null;
    let box: Box | null = null;
    for (const { field, factor } of this.#terms) {
      const own = grown(field.box, field.offset(needed / (this.#terms.length * Math.abs(factor))));
      box = box ? unite(box, own) : own;
    }
    return box;
  }
}
