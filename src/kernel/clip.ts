/**
 * What lies outside a disc about the foot of the plane's perpendicular: kernels that are nothing beyond a radius (quartic) or
 * nothing worth counting (Gaussian) integrate over an edge inside it, and turn what is outside into an angle.
 */
import { fastAtan2 } from '../math/atan.ts';

/** The signed angle at the origin of an edge's parts α…low and high…β. All three are on one line at distance d. */
export function angleOutside(d: number, alpha: number, beta: number, low: number, high: number): number {
  // the product of both parts as complex numbers; a part of no length is 1, also where the origin is its end
  const before = low !== alpha;
  const after = high !== beta;
  if (!before && !after) return 0;
  const x0 = before ? d * d + alpha * low : 1;
  const y0 = before ? d * (low - alpha) : 0;
  const x1 = after ? d * d + high * beta : 1;
  const y1 = after ? d * (beta - high) : 0;
  return fastAtan2(x0 * y1 + y0 * x1, x0 * x1 - y0 * y1);
}

export const clamped = (value: number, limit: number): number =>
  value < -limit ? -limit : value > limit ? limit : value;
