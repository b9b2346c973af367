/**
 * What the field of a segment may be within a ball: how far the segment is from the centre, and whether the ball comes so
 * near to its line that singular kernels are clamped.
 */
import type { Kernel, LineField, LineFrame } from '../kernel/kernel.ts';
import type { Spread } from './skeleton.ts';
import { Spreader } from './spread.ts';
import { weightRange } from './weightRange.ts';

/** of the length: what a distance from the axis loses when it is made orthogonal once */
const BLUR = 2e-15;

export class SegmentSpread {
  readonly #spreader: Spreader;
  readonly #a: Float64Array;
  readonly #u: Float64Array;
  readonly #per: number;
  readonly #length: number;
  /** twice the distance from the line that singular kernels are clamped to */
  readonly #clear: number;

  /** `a` (mm) and `u`: the first end and the direction; `per`: kernel units of a millimetre. */
  constructor(kernel: Kernel, frame: LineFrame, a: Float64Array, u: Float64Array, per: number) {
    const { length, exponent, floor2 } = frame;
    const extent = { dimension: 1, size: length, turns: 1, ...weightRange(frame) } as const;
    this.#spreader = new Spreader(kernel, exponent, extent, per);
    this.#a = a;
    this.#u = u;
    this.#per = per;
    this.#length = length;
    this.#clear = 2 * Math.sqrt(floor2);
  }

  /** The largest |F| at that squared distance or farther. */
  most(r2: number): number {
    return this.#spreader.most(r2);
  }

  /** Adds `factor` times the spread of `field`, the segment's own or its quick form. */
  add(field: LineField, x: number, y: number, z: number, radius: number, factor: number, out: Spread): void {
    const a = this.#a;
    const u = this.#u;
    const per = this.#per;
    const length = this.#length;
    const clear = this.#clear;
    const vx = (x - a[0]!) * per;
    const vy = (y - a[1]!) * per;
    const vz = (z - a[2]!) * per;
    const t = vx * u[0]! + vy * u[1]! + vz * u[2]!;
    const nearest = t < 0 ? 0 : t > length ? length : t;
    const distance = Math.max(away(vx, vy, vz, nearest, u) - BLUR * length, 0);
    const room = clear > 0 ? away(vx, vy, vz, t, u) - radius * per - BLUR * (length + Math.abs(t)) : 0;
    this.#spreader.add(field, x, y, z, radius, factor, out, distance, room >= clear, 0);
  }
}

/** From a place on the line. */
function away(vx: number, vy: number, vz: number, t: number, u: Float64Array): number {
  const x = vx - t * u[0]!;
  const y = vy - t * u[1]!;
  const z = vz - t * u[2]!;
  return Math.sqrt(x * x + y * y + z * z);
}
