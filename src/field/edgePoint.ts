/**
 * A vertex of the mesh: where the surface crosses an edge of the lattice, first by the cubic through four values along it, then by Newton's
 * steps along the slope of the local field, which is wanted for the normal anyway. Where that is no short way, as beside a
 * crease, the crossing is looked for along the edge (surfacePoint.ts).
 */
import type { Vec3 } from '../math/vec.ts';
import type { Near } from './near.ts';
import { type Crossed, kept, surfacePoint } from './surfacePoint.ts';

/** parts of the edge: a longer first step is none of Newton's, and after a longer one another follows: meshes of both kinds agree to 1e-4 cells */
const FARTHEST = 0.15;
const CLOSE = 0.01;
const STEPS = 3;
/** cells that the error of a list may come to at the vertex; it is some times less. .03 took a tenth more work of a blob, and .1 missed by .015. */
export const UNSURE = 0.05;
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
  /** where the edge begins, and how long edges are */
  readonly #first = new Float64Array(3);
  #axis = 0;
  #step = 0.5;
  readonly #value = new Float64Array(4);

  /** `step`: how long edges are. */
  constructor(step: number) {
    this.#step = step;
  }

  /** Goes to the edge from (x, y, z) on along an axis. */
  enter(x: number, y: number, z: number, axis: number): void {
    const first = this.#first;
    first[0] = x;
    first[1] = y;
    first[2] = z;
    this.#axis = axis;
  }

  /** From `t` of the edge on. False where Newton's steps are too long. */
  newton(field: Crossed, t: number): boolean {
    const [first, axis, along] = [this.#first, this.#axis, t * this.#step];
    this.x = first[0]! + (axis === 0 ? along : 0);
    this.y = first[1]! + (axis === 1 ? along : 0);
    this.z = first[2]! + (axis === 2 ? along : 0);
    return this.polish(field) && this.#isBeside();
  }

  /** Once more by all skels, where the slope is so small that what the list misses there moves the surface. */
  sharpen(whole: Crossed, near: Pick<Near, 'errorAt'>): boolean {
    if (near.errorAt(this.x, this.y, this.z) < UNSURE * this.#step * this.slope) return true;
    return this.polish(whole) && this.#isBeside();
  }

  /** So near to the edge that no vertex of another edge is in the same place. */
  #isBeside(): boolean {
    const [first, axis, step] = [this.#first, this.#axis, this.#step];
    const dx = this.x - first[0]!;
    const dy = this.y - first[1]!;
    const dz = this.z - first[2]!;
    const along = (axis === 0 ? dx : axis === 1 ? dy : dz) / step;
    const most = BESIDE * Math.min(along, 1 - along) * step;
    return (
      (axis === 0 || Math.abs(dx) <= most) &&
      (axis === 1 || Math.abs(dy) <= most) &&
      (axis === 2 || Math.abs(dz) <= most)
    );
  }

  /** From where it is, near the surface. */
  polish(field: Crossed): boolean {
    const value = this.#value;
    const step = this.#step;
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
  // c0 + u (c1 + u (c2 + u c3)), of Newton's differences
  const d2 = 0.5 * (v2 - 2 * v1 + v0);
  const c3 = (v3 - 3 * v2 + 3 * v1 - v0) / 6;
  const c2 = d2 - 3 * c3;
  const c1 = v1 - v0 - d2 + 2 * c3;
  let low = from;
  let high = from + 1;
  let atLow = v0 + low * (c1 + low * (c2 + low * c3));
  let atHigh = v0 + high * (c1 + high * (c2 + high * c3));
  let u = low + atLow / (atLow - atHigh);
  // Illinois: the end that stays counts half, or it would stay for ever
  for (let i = 0; i < 3 && u > low && u < high; i++) {
    const value = v0 + u * (c1 + u * (c2 + u * c3));
    if (value > 0 === atLow > 0) {
      low = u;
      atLow = value;
      atHigh *= 0.5;
    } else {
      high = u;
      atHigh = value;
      atLow *= 0.5;
    }
    u = low + ((high - low) * atLow) / (atLow - atHigh);
  }
  return kept(u - from);
}

/** additions and products of that */
export const CROSSING_FLOPS = 60;
