/**
 * Drawn cross section: a closed curve R(θ) about the skel, 12 cubic Bézier segments of 30° in polar form (Tai et al.
 * (13)–(17), basis B_{n,i}), m = 1/R(θ). The joints are halfway between their neighbours, which makes R differentiable;
 * 24 radii remain. Angles count from x to y; fitted to a drawn loop in polarFit.ts.
 */
import { fastAtan2 } from '../math/atan.ts';
import { TAU } from '../math/trig.ts';
import { FieldError } from '../skeleton/skeleton.ts';
import type { Section } from './section.ts';

export interface PolarProfile {
  readonly type: 'polar';
  /** the two inner control radii of each of the 12 segments, in units of the generic radius; all at least LEAST_RADIUS */
  readonly radii: readonly number[];
}

export const PROFILE_SEGMENTS = 12;
/** Thinner, the field beside the skel is stretched so much that float32 sees steps. */
export const LEAST_RADIUS = 0.05;

const TURN = PROFILE_SEGMENTS / TAU;

export function polarProfile({ radii }: PolarProfile): Section {
  const count = 2 * PROFILE_SEGMENTS;
  if (radii.length !== count) throw new FieldError(`radii must be ${count} numbers, got ${radii.length}`);
  radii.forEach((radius, i) => {
    if (!(radius >= LEAST_RADIUS && radius < Infinity)) {
      throw new FieldError(`radii[${i}] must be at least ${LEAST_RADIUS}, got ${radius}`);
    }
  });
  const control = controlRadii(radii);
  const largest = Math.max(...radii);
  return {
    value(x, y) {
      if (x === 0 && y === 0) return 1;
      const u = turn(x, y);
      const k = Math.floor(u);
      const t = u - k;
      const s = 1 - t;
      const i = 4 * k;
      return (
        1 /
        (s * s * (s * control[i]! + 3 * t * control[i + 1]!) +
          t * t * (3 * s * control[i + 2]! + t * control[i + 3]!))
      );
    },
    evaluate(x, y, out) {
      const rho2 = x * x + y * y;
      out[0] = 1;
      out[1] = 0;
      out[2] = 0;
      if (rho2 === 0) return;
      const u = turn(x, y);
      const k = Math.floor(u);
      const t = u - k;
      const s = 1 - t;
      const r0 = control[4 * k]!;
      const r1 = control[4 * k + 1]!;
      const r2 = control[4 * k + 2]!;
      const r3 = control[4 * k + 3]!;
      const m = 1 / (s * s * (s * r0 + 3 * t * r1) + t * t * (3 * s * r2 + t * r3));
      const slope = 3 * TURN * (s * s * (r1 - r0) + 2 * s * t * (r2 - r1) + t * t * (r3 - r2));
      const around = (slope * m * m) / rho2;
      out[0] = m;
      out[1] = around * y;
      out[2] = -around * x;
    },
    extent: (r) => [r * largest, r * largest],
  };
}

/** Four for each segment, its joints included. */
export function controlRadii(radii: readonly number[]): Float64Array {
  const n = radii.length;
  const joint = (k: number) => 0.5 * (radii[(2 * k - 1 + n) % n]! + radii[(2 * k) % n]!);
  return Float64Array.from({ length: 2 * n }, (_, i) => {
    const k = i >> 2;
    const inner = i & 3;
    return inner === 0 ? joint(k) : inner === 3 ? joint(k + 1) : radii[2 * k + inner - 1]!;
  });
}

/** The angle in segments, 0 ≤ u < 12. */
function turn(x: number, y: number): number {
  const u = TURN * fastAtan2(y, x);
  const positive = u < 0 ? u + PROFILE_SEGMENTS : u;
  return positive < PROFILE_SEGMENTS ? positive : 0;
}
