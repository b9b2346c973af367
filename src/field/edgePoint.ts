/**
 * A vertex of the mesh: where the surface crosses an edge of the lattice, first by the cubic through four values along it, then by Newton's
 * steps along the slope of the local field, which is wanted for the normal anyway. Where that is no short way, as beside a
 * crease, the crossing is looked for along the edge (surfacePoint.ts).
 */
import type { Vec3 } from '../math/vec.ts';
import { type Crossed, kept, surfacePoint } from './surfacePoint.ts';

/** parts of the edge: a longer first step is none of Newton's, and after a longer one another follows */
const FARTHEST = 0.15;
const CLOSE = 0.01;
const STEPS = 3;
/** cells that the proven error of a list may come to; it is four to ten times less */
const UNSURE = 0.12;
/** of the way to the nearer end: less than a half, for edges that meet there */
const BESIDE = 0.49;

/** Position and unit normal, out of where the field is positive; the normal is 0 where the field has no slope. */
export class EdgePoint {
  x = 0.5;
  y = 0.5;
  z = 0.5;
  nx = 0.5;
  ny = 0.5;
  nz = 0.5;
  /** of the field, after `polish` */
  slope = 0.5;
  readonly #value = new Float64Array(4);

  /** From a on along an axis, `t` of a step; `step`: how long edges are. False where Newton's steps are too long. */
  newton(field: Crossed, a: Vec3, axis: number, step: number, t: number): boolean {
    const x = a[0] + (axis === 0 ? t * step : 0);
    const y = a[1] + (axis === 1 ? t * step : 0);
    const z = a[2] + (axis === 2 ? t * step : 0);
    return this.polish(field, [x, y, z], step) && this.#isBeside(a, axis, step);
  }

  /** Once more by all skels, where the slope is so small that what a list misses moves the surface. */
  sharpen(whole: Crossed, error: number, a: Vec3, axis: number, step: number): boolean {
    if (error < UNSURE * step * this.slope) return true;
    return this.polish(whole, [this.x, this.y, this.z], step) && this.#isBeside(a, axis, step);
  }

  /** So near to the edge that no vertex of another edge is in the same place. */
  #isBeside(a: Vec3, axis: number, step: number): boolean {
    const along = (axis === 0 ? this.x - a[0] : axis === 1 ? this.y - a[1] : this.z - a[2]) / step;
    const most = BESIDE * Math.min(along, 1 - along) * step;
    return (
      (axis === 0 || Math.abs(this.x - a[0]) <= most) &&
      (axis === 1 || Math.abs(this.y - a[1]) <= most) &&
      (axis === 2 || Math.abs(this.z - a[2]) <= most)
    );
  }

  /** From a place near the surface. */
  polish(field: Crossed, from: Vec3, step: number): boolean {
    [this.x, this.y, this.z] = from;
    const value = this.#value;
    for (let i = 0; i < STEPS; i++) {
      field.evaluate(this.x, this.y, this.z, value);
      const gx = value[1]!;
      const gy = value[2]!;
      const gz = value[3]!;
      const slope2 = gx * gx + gy * gy + gz * gz;
      const slope = Math.sqrt(slope2);
      const moved = Math.abs(value[0]!) / slope;
      if (!(moved < FARTHEST * step) || !(slope2 > 1e-200 && slope2 < 1e200)) return false;
      const by = value[0]! / slope2;
      this.x -= by * gx;
      this.y -= by * gy;
      this.z -= by * gz;
      this.nx = -gx / slope;
      this.ny = -gy / slope;
      this.nz = -gz / slope;
      this.slope = slope;
      if (moved < CLOSE * step) return true;
    }
    return false;
  }

  /** Between a and b, with values of opposite signs there. */
  search(field: Crossed, a: Vec3, b: Vec3, valueA: number, valueB: number): void {
    const { at, normal } = surfacePoint(field, a, b, valueA, valueB);
    [this.x, this.y, this.z] = at;
    [this.nx, this.ny, this.nz] = normal ?? [0, 0, 0];
  }
}

/** Where the cubic through four values at 0, 1, 2, 3 crosses 0 between `from` and `from` + 1, as a part of the way. */
export function cubicCrossing(v0: number, v1: number, v2: number, v3: number, from: number): number {
  const d1 = v1 - v0;
  const d2 = v2 - 2 * v1 + v0;
  const d3 = v3 - 3 * v2 + 3 * v1 - v0;
  const at = (u: number) => v0 + u * (d1 + 0.5 * (u - 1) * (d2 + ((u - 2) / 3) * d3));
  let [low, high] = [from, from + 1];
  let [atLow, atHigh] = [at(low), at(high)];
  let u = low + atLow / (atLow - atHigh);
  // Illinois: the end that stays counts half, or it would stay for ever
  for (let i = 0; i < 3 && u > low && u < high; i++) {
    const value = at(u);
    if (value > 0 === atLow > 0) {
      [low, atLow] = [u, value];
      atHigh *= 0.5;
    } else {
      [high, atHigh] = [u, value];
      atLow *= 0.5;
    }
    u = low + ((high - low) * atLow) / (atLow - atHigh);
  }
  return kept(u - from);
}

/** additions and products of that */
export const CROSSING_FLOPS = 60;
