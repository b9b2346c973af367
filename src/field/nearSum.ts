/**
 * A sum of skels as it is within a cube: those that hardly bend there are added up once, as one linear function, and only the
 * others are asked at each point. What is neglected is bounded: each skel's spread says by how much it may leave its linear
 * part (a Gegenbauer remainder for the Cauchy kernel), least first, and their sum stays below the budget. Within a support
 * that is not reached nothing is neglected.
 *
 * An octree hands down what was left, so that a small cube never looks at all skels.
 */
import { SPREAD } from '../skeleton/skeleton.ts';
import { AROUND, closed, roundedHalf } from './closed.ts';
import type { Near } from './near.ts';
import type { BoundTerm } from './skelSum.ts';

/** value + g · (p − at) */
export interface Linear {
  readonly at: readonly [x: number, y: number, z: number];
  readonly value: number;
  readonly gx: number;
  readonly gy: number;
  readonly gz: number;
}

/** of what is added up */
const ROUNDING = 4e-15;

export class NearSum implements Near {
  readonly low: number;
  readonly high: number;
  readonly error: number;
  readonly #terms: readonly BoundTerm[];
  readonly #threshold: number;
  /** what was added up, less T */
  readonly #far: Linear;

  constructor(
    terms: readonly BoundTerm[],
    threshold: number,
    far: Linear = { at: [0, 0, 0], value: -threshold, gx: 0, gy: 0, gz: 0 },
    error = 0,
    range: ArrayLike<number> = [-Infinity, Infinity],
  ) {
    this.#terms = terms;
    this.#threshold = threshold;
    this.#far = far;
    this.error = error;
    this.low = range[0]!;
    this.high = range[1]!;
  }

  get asked(): number {
    return this.#terms.length;
  }

  value(x: number, y: number, z: number): number {
    let sum = linearAt(this.#far, x, y, z);
    for (const { field, factor } of this.#terms) sum += factor * field.value(x, y, z);
    return sum;
  }

  within(x: number, y: number, z: number, cube: number, share: number): Near {
    const half = roundedHalf(x, y, z, cube);
    const spreads = this.#spreads(x, y, z, AROUND * half);
    const range = this.#range(x, y, z, half, spreads);
    const order = spreads.map((_, i) => i).sort((a, b) => spreads[a]![4]! - spreads[b]![4]!);
    const budget = share * this.#threshold;
    let { gx, gy, gz } = this.#far;
    let value = linearAt(this.#far, x, y, z);
    let error = this.error;
    let count = 0;
    for (const i of order) {
      const spread = spreads[i]!;
      const more = spread[4]! + ROUNDING * Math.abs(spread[0]!);
      if (!(error + more <= budget)) break;
      error += more;
      value += spread[0]!;
      gx += spread[1]!;
      gy += spread[2]!;
      gz += spread[3]!;
      count++;
    }
    const near = count === 0 ? this.#terms : order.slice(count).map((i) => this.#terms[i]!);
    return new NearSum(near, this.#threshold, { at: [x, y, z], value, gx, gy, gz }, error, range);
  }

  #spreads(x: number, y: number, z: number, radius: number): Float64Array[] {
    return this.#terms.map(({ field, factor }) => {
      const spread = new Float64Array(SPREAD);
      field.spread(x, y, z, radius, factor, spread);
      return spread;
    });
  }

  /** As SkelSum's own, with what was added up before and what that neglects. */
  #range(x: number, y: number, z: number, half: number, spreads: readonly Float64Array[]): Float64Array {
    const { gx, gy, gz } = this.#far;
    const value = linearAt(this.#far, x, y, z);
    const swing = half * (Math.abs(gx) + Math.abs(gy) + Math.abs(gz));
    const total = new Float64Array(SPREAD);
    for (const spread of spreads) for (let i = 0; i < SPREAD; i++) total[i] = total[i]! + spread[i]!;
    const margin = this.error + ROUNDING * (this.#threshold + Math.abs(value) + Math.abs(total[0]!));
    total[0] = total[0]! + value;
    total[1] = total[1]! + gx;
    total[2] = total[2]! + gy;
    total[3] = total[3]! + gz;
    total[4] = total[4]! + margin;
    total[5] = total[5]! + value - swing - margin;
    total[6] = total[6]! + value + swing + margin;
    const range = new Float64Array(2);
    closed(total, half, range);
    return range;
  }
}

function linearAt({ at: [ax, ay, az], value, gx, gy, gz }: Linear, x: number, y: number, z: number): number {
  return value + gx * (x - ax) + gy * (y - ay) + gz * (z - az);
}
