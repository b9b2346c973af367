/**
 * An edge's share of the Cauchy kernel over a polygon, in one piece: what powerEdge.ts does for all exponents, in two thirds of
 * the time and without numbers handed from call to call, which engines put on the heap.
 *
 * Theory: Green, as in powerEdge.ts: (d ∫ dτ/(w² + τ²))/(2m), w² = m + d², m = 1 + z², one arc tangent. Gradients beyond an end, where ∫ Q⁻² cancels, are left to powerEdge.ts.
 */
import { fastAtan2 } from '../math/atan.ts';
import type { EdgeFrame, Integral } from './kernel.ts';
import { powerEdge } from './powerEdge.ts';

export function cauchyEdge(frame: EdgeFrame, out: Integral): void {
  const { d, alpha, beta, length, z, slopes } = frame;
  const m = 1 + z * z;
  const w2 = m + d * d;
  const nearer = alpha > 0 ? alpha : -beta;
  if (slopes && nearer > 0 && nearer * nearer > w2) {
    powerEdge(frame, m, 4, out);
    return;
  }
  const w = Math.sqrt(w2);
  const ends = alpha * beta;
  const x = w2 + ends;
  const y = length * w;
  const angle = fastAtan2(y, x) / w;
  const four = (d * angle) / m;
  out[0] = 0.5 * four;
  if (!slopes) return;
  const line = (0.5 * (angle + (length * (w2 - ends)) / (x * x + y * y))) / w2;
  out[1] = -line;
  out[2] = (-z * (four + d * line)) / m;
}
