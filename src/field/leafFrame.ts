/** The frame of a leaf that a matrix has moved: points go back into it, values and gradients come out of it. */
import type { Vec3 } from '../math/vec.ts';
import type { Affine } from './affine.ts';
import { stretches } from './affine.ts';

/** of coordinates */
const ROUNDING = 4e-15;

export class LeafFrame {
  readonly back: Affine;
  /** of values */
  readonly scale: number;
  /** of lengths, the largest */
  readonly #stretch: number;
  readonly #size: number;
  /** the point that `enter` was told of */
  x = 0.5;
  y = 0.5;
  z = 0.5;

  constructor(back: Affine, scale: number) {
    this.back = back;
    this.scale = scale;
    this.#stretch = stretches(back).most;
    this.#size = Math.abs(back[3]) + Math.abs(back[7]) + Math.abs(back[11]);
  }

  enter(x: number, y: number, z: number): void {
    const m = this.back;
    this.x = m[0] * x + m[1] * y + m[2] * z + m[3];
    this.y = m[4] * x + m[5] * y + m[6] * z + m[7];
    this.z = m[8] * x + m[9] * y + m[10] * z + m[11];
  }

  /** A direction. */
  along([x, y, z]: Vec3): Vec3 {
    const m = this.back;
    return [m[0] * x + m[1] * y + m[2] * z, m[4] * x + m[5] * y + m[6] * z, m[8] * x + m[9] * y + m[10] * z];
  }

  /** By how much the place of a point within `radius` of (x, y, z) is off when it is rounded. */
  off(x: number, y: number, z: number, radius: number): number {
    return ROUNDING * (this.#stretch * (Math.abs(x) + Math.abs(y) + Math.abs(z) + radius) + this.#size);
  }

  /** Of a ball of `radius` the one that holds it. */
  reach(radius: number): number {
    return radius * this.#stretch;
  }

  /** A gradient, at out[1], out[2] and out[3]; not yet scaled. */
  turn(out: Float64Array): void {
    const m = this.back;
    const [gx, gy, gz] = [out[1]!, out[2]!, out[3]!];
    out[1] = m[0] * gx + m[4] * gy + m[8] * gz;
    out[2] = m[1] * gx + m[5] * gy + m[9] * gz;
    out[3] = m[2] * gx + m[6] * gy + m[10] * gz;
  }

  /** A value and its gradient. */
  leave(out: Float64Array): void {
    this.turn(out);
    for (let i = 0; i < 4; i++) out[i] = out[i]! * this.scale;
  }
}
