/**
 * The interval of a field over a cube from its spread over the ball around the cube: the centred form, whose gradient counts by
 * its parts along the edges, within what the spread says itself.
 */
import type { Spread } from '../skeleton/skeleton.ts';

/** of the cube's half edge: of the ball around it */
export const AROUND = Math.sqrt(3) * (1 + 1e-15);
/** of coordinates: half a last digit */
const EPSILON = 2.3e-16;
/** of all that is added */
const ROUNDING = 2e-15;

/** `half`, and what coordinates in the cube are off by when they are rounded. */
export function roundedHalf(x: number, y: number, z: number, half: number): number {
  return half + EPSILON * (Math.max(Math.abs(x), Math.abs(y), Math.abs(z)) + half);
}

export function closed(spread: Spread, half: number, out: Float64Array): void {
  const middle = spread[0]!;
  const slope = Math.abs(spread[1]!) + Math.abs(spread[2]!) + Math.abs(spread[3]!);
  const reach = half * slope + spread[4]!;
  const swing = reach + ROUNDING * (reach + (reach > 0 ? Math.abs(middle) : 0));
  out[0] = Math.max(spread[5]!, middle - swing);
  out[1] = Math.min(spread[6]!, middle + swing);
}
