/**
 * The Cauchy segment with a linear weight as the papers write it (Jin & Tai 2002): d² − h², two arc tangents of the engine. The
 * yardstick for ours; wrong by all digits beyond the ends of long segments.
 */
import type { SegmentSkel } from '../../src/skeleton/skels.ts';
import type { TimedGradient } from './timing.ts';

export function plainCauchy({ a, b, weights }: SegmentSkel, s: number): TimedGradient {
  const [ax, ay, az] = a;
  const l = Math.hypot(b[0] - ax, b[1] - ay, b[2] - az);
  const [ux, uy, uz] = [(b[0] - ax) / l, (b[1] - ay) / l, (b[2] - az) / l];
  const [w0, w1] = [weights[0]!, weights[1]!];
  const s2 = s * s;
  return {
    value(x, y, z) {
      const dx = x - ax;
      const dy = y - ay;
      const dz = z - az;
      const h = dx * ux + dy * uy + dz * uz;
      const g = l - h;
      const p2 = 1 + s2 * (dx * dx + dy * dy + dz * dz - h * h);
      const p = Math.sqrt(p2);
      const q0 = p2 + s2 * h * h;
      const q1 = p2 + s2 * g * g;
      const angle = Math.atan((s * h) / p) + Math.atan((s * g) / p);
      const two = (h / q0 + g / q1 + angle / (s * p)) / (2 * p2);
      const one = (1 / q0 - 1 / q1) / (2 * s2);
      return (w0 + w1 * h) * two + w1 * one;
    },
    add(x, y, z, factor, out) {
      const dx = x - ax;
      const dy = y - ay;
      const dz = z - az;
      const h = dx * ux + dy * uy + dz * uz;
      const g = l - h;
      const p2 = 1 + s2 * (dx * dx + dy * dy + dz * dz - h * h);
      const p = Math.sqrt(p2);
      const i0 = 1 / (p2 + s2 * h * h);
      const i1 = 1 / (p2 + s2 * g * g);
      const angle = Math.atan((s * h) / p) + Math.atan((s * g) / p);
      const two = (h * i0 + g * i1 + angle / (s * p)) / (2 * p2);
      const one = (i0 - i1) / (2 * s2);
      const foot = w0 + w1 * h;
      const three = (h * i0 * i0 + g * i1 * i1 + 3 * two) / (4 * p2);
      const oneThree = (i0 * i0 - i1 * i1) / (4 * s2);
      const across = -4 * s2 * factor * (foot * three + w1 * oneThree);
      const along = factor * (w0 * i0 * i0 - (w0 + w1 * l) * i1 * i1 + w1 * two);
      out[0] = out[0]! + factor * (foot * two + w1 * one);
      out[1] = out[1]! + across * (dx - h * ux) + along * ux;
      out[2] = out[2]! + across * (dy - h * uy) + along * uy;
      out[3] = out[3]! + across * (dz - h * uz) + along * uz;
    },
  };
}
