/**
 * The Cauchy kernel 1/(1 + s²r²)² (Zhu et al. 2011 §3.2; Jin & Tai 2002), in units of 1/s.
 *
 * Segments: FIELD-NOTES §2 (inversePower.ts). Polygons: FIELD-NOTES §3 (powerEdge.ts): one arc tangent an edge, where Zhu's
 * (16) has four, lacks its bracket, and divides by a component of the edge.
 */
import { fastAtan2 } from '../math/atan.ts';
import { PI } from '../math/trig.ts';
import { inversePower } from './inversePower.ts';
import type { Integral, Kernel, LineFrame } from './kernel.ts';
import { S } from './params.ts';
import { powerEdge } from './powerEdge.ts';

export const cauchy: Kernel = {
  name: 'cauchy',
  label: 'Cauchy',
  params: [S],
  homogeneity: 0,
  support: Infinity,
  floor2: { line: 0, plate: 0 },
  unit: ({ s = S.default }) => 1 / s,
  value: (r2) => 1 / ((1 + r2) * (1 + r2)),
  slope: (r2) => -2 / ((1 + r2) * (1 + r2) * (1 + r2)),
  line,
  edge: (frame, out) => powerEdge(frame, 1 + frame.z * frame.z, 4, out),
  wholeLine: (r2) => (0.5 * PI) / ((1 + r2) * Math.sqrt(1 + r2)),
  wholePlane: (r2) => PI / (1 + r2),
};

/** Linear weights near the segment, the usual case, in a straight line (half the time); the rest in general. */
function line(frame: LineFrame, out: Integral): void {
  const { rho2, alpha, beta, length, weights } = frame;
  const m2 = 1 + rho2;
  const nearer = alpha > 0 ? alpha : -beta;
  if (frame.degree > 1 || (nearer > 0 && nearer * nearer > m2) || m2 > 100 * length * length) {
    inversePower(frame, m2, 4, out);
    return;
  }
  const ends = alpha * beta;
  const m = Math.sqrt(m2);
  const theta = fastAtan2(length * m, m2 + ends) / m;
  const a = m2 + alpha * alpha;
  const b = m2 + beta * beta;
  const ab = 1 / (a * b);
  const per = 1 / m2;
  const two = 0.5 * length * ab;
  const zero = (0.5 * theta + (m2 - ends) * two) * per;
  const one = (alpha + beta) * two;
  const w1 = weights[1]!;
  const foot = weights[0]! - w1 * alpha;
  out[0] = foot * zero + w1 * one;
  if (!frame.slopes) return;
  // ∫ Q⁻³ and ∫ τ Q⁻³ from those of Q⁻²
  const ab2 = ab * ab;
  const b2 = b * b;
  const a2 = a * a;
  const zero3 = 0.25 * ((beta * a2 - alpha * b2) * ab2 + 3 * zero) * per;
  const one3 = 0.5 * one * (a + b) * ab;
  out[1] = -2 * (foot * zero3 + w1 * one3);
  out[2] = (weights[0]! * b2 - (weights[0]! + w1 * length) * a2) * ab2 + w1 * zero;
}
