/**
 * What a ray sees of fields that tell nothing ahead (rayAhead.ts), by their intervals over cubes: around the next part of the ray, which
 * is shortened until the interval does not hold 0.
 */
import type { Ray } from './near.ts';

/** Writes the interval over the cube about (x, y, z) with edges of 2 `half`. */
type Range = (x: number, y: number, z: number, half: number, out: Float64Array) => void;

/** the next try is shorter by that */
const SHORTER = 0.5;
/** of the reach: shorter is nothing */
const SHORTEST = 1e-7;

const range = new Float64Array(2);

/** Over a cube around `t` mm of the ray from `at` on. */
export function rangeAlong(of: Range, at: ArrayLike<number>, ray: Ray, t: number, out: Float64Array): void {
  const h = 0.5 * t;
  const half = h * Math.max(Math.abs(ray[0]), Math.abs(ray[1]), Math.abs(ray[2])) * (1 + 1e-12);
  of(at[0]! + h * ray[0], at[1]! + h * ray[1], at[2]! + h * ray[2], half, out);
}

/** mm along the ray over which the value surely is on the same side of 0; `first`: the longest that is tried, mm. */
export function clearAlong(of: Range, at: ArrayLike<number>, ray: Ray, first: number): number {
  for (let t = first; t > SHORTEST * first; t *= SHORTER) {
    rangeAlong(of, at, ray, t, range);
    if (range[0]! > 0 || range[1]! < 0) return t;
  }
  return 0;
}
