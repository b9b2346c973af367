/**
 * What a skel's field may be within a ball: an interval, and a centred form, whose gradients a sum adds up before it takes
 * their lengths. Both hold for the values as computed: MARGIN of the largest that the skel can have there is put on either side.
 *
 * Theory: kernel/change.ts, and kernel/most.ts for balls that reach the skel. A form whose rest is larger than half the interval
 * says less than the interval, and is replaced by it: the middle, no gradient, half the width. So one near skel does not spoil
 * a sum of far ones.
 */
import type { Dimension, RelativeChange } from '../kernel/change.ts';
import type { Kernel } from '../kernel/kernel.ts';
import { mostOfLine, mostOfPlate } from '../kernel/most.ts';
import type { FieldValue, Spread } from './skeleton.ts';

/** of the largest field there; values are good to 1e-12 of it */
const MARGIN = 4e-12;
/** where that underflows */
const LEAST = 1e-300;
/** of distances: rounding of a box's size and of distances themselves */
const ROUNDING = 1e-14;
/** √floor over distance times n and a safe 2: what the clamp of singular lines changes beyond their ends */
const CLAMPED = 12;

interface Adding {
  add(x: number, y: number, z: number, factor: number, out: FieldValue): void;
}

/** What bounds need to know of a skel, kernel units. */
export interface Extent {
  readonly dimension: Dimension;
  /** length or area, as often as it is gone round; 1 for points */
  readonly size: number;
  readonly turns: number;
  /** a bound on |w| */
  readonly most: number;
  /** 1 or −1 where w has one sign, else 0 */
  readonly sign: number;
}

const change = new Float64Array(3);
const slopes = new Float64Array(2);
const nowhere = new Float64Array(2);
const centre = new Float64Array(4);
/** low, high, rest of one skel */
const range = new Float64Array(3);

export class Spreader {
  readonly #kernel: Kernel;
  readonly #exponent: number;
  readonly #extent: Extent;
  readonly #floor2: number;
  readonly #per: number;

  /** `per`: kernel units of a millimetre. */
  constructor(kernel: Kernel, exponent: number, extent: Extent, per: number) {
    this.#kernel = kernel;
    this.#exponent = exponent;
    this.#extent = extent;
    this.#floor2 = extent.dimension === 2 ? kernel.floor2.plate : kernel.floor2.line;
    this.#per = per;
  }

  /** The largest |F| at that squared distance or farther. */
  most(r2: number): number {
    const { dimension, size, turns, most } = this.#extent;
    const n = this.#exponent;
    if (dimension === 1) return most * mostOfLine(this.#kernel, r2, size, n);
    if (dimension === 2) return most * mostOfPlate(this.#kernel, r2, size, turns, n);
    return most * this.#kernel.value(Math.max(r2, this.#floor2), n);
  }

  /**
   * Adds `factor` times the spread of `field` within `radius` mm. `distance` (kernel units) is the skel's from the centre;
   * `isClear`: nowhere is a line or a plane so near that it is clamped; `slack`: what sums over edges leave of the field elsewhere.
   */
  add(
    field: Adding,
    x: number,
    y: number,
    z: number,
    radius: number,
    factor: number,
    out: Spread,
    distance: number,
    isClear: boolean,
    slack: number,
  ): void {
    const by = radius * this.#per * (1 + ROUNDING);
    const near = Math.max(distance - by - ROUNDING * (distance + by), 0);
    const { most, sign } = this.#extent;
    if (most === 0 || (near >= this.#kernel.support && slack === 0)) return;
    const cap = near < this.#kernel.support ? this.most(near * near) : 0;
    const margin = MARGIN * cap + slack + LEAST;
    centre.fill(0);
    field.add(x, y, z, 1, centre);
    this.#change(distance, near, by, cap, isClear);
    const low = Math.max(range[0]!, sign > 0 ? 0 : -cap) - margin;
    const high = Math.min(range[1]!, sign < 0 ? 0 : cap) + margin;
    write(out, factor, low, high, range[2]! + margin);
  }

  #change(distance: number, near: number, by: number, cap: number, isClear: boolean): void {
    const { change } = this.#kernel;
    if (change.type === 'relative') {
      this.#relative(change, distance, near, by, cap, isClear);
      return;
    }
    const { dimension, size, turns, most, sign } = this.#extent;
    const r2 = near * near;
    change.slopes(0, r2, nowhere);
    let [slope, bend] = [nowhere[0]!, nowhere[1]!];
    if (dimension > 0) {
      change.slopes(dimension, r2, slopes);
      slope = Math.min(size * slope, turns * slopes[0]!);
      bend = Math.min(size * bend, turns * slopes[1]!);
    }
    // weights of both signs may add up what both parts come to
    const weight = sign === 0 ? 2 * most : most;
    const swing = weight * slope * by;
    range[0] = centre[0]! - swing;
    range[1] = centre[0]! + swing;
    range[2] = 0.5 * weight * bend * by * by;
  }

  #relative(
    kernelChange: RelativeChange,
    distance: number,
    near: number,
    by: number,
    cap: number,
    isClear: boolean,
  ): void {
    const least = Math.sqrt(this.#floor2);
    kernelChange.factors(Math.max(distance * (1 - ROUNDING), least), by, this.#exponent, change);
    const value = centre[0]!;
    const down = change[0]!;
    const up = Math.min(change[1]!, 1e300);
    if (this.#extent.sign === 0) {
      const whole = this.most(distance * distance);
      const swing = whole * Math.max(up - 1, 1 - down);
      range[0] = value - swing;
      range[1] = value + swing;
      range[2] = whole * change[2]!;
    } else {
      range[0] = value * (value > 0 ? down : up);
      range[1] = value * (value > 0 ? up : down);
      range[2] = Math.abs(value) * change[2]!;
    }
    if (isClear && near >= least) return;
    const isBeyond = this.#extent.dimension === 1 && near > least;
    range[2] = isBeyond ? range[2]! + (CLAMPED * cap * least) / near : Infinity;
  }
}

function write(out: Spread, factor: number, low: number, high: number, rest: number): void {
  const size = Math.abs(factor);
  const half = 0.5 * (high - low);
  if (rest < half) {
    for (let i = 0; i < 4; i++) out[i] = out[i]! + factor * centre[i]!;
    out[4] = out[4]! + size * rest;
  } else {
    out[0] = out[0]! + factor * (low + half);
    out[4] = out[4]! + size * half;
  }
  out[5] = out[5]! + factor * (factor > 0 ? low : high);
  out[6] = out[6]! + factor * (factor > 0 ? high : low);
}
