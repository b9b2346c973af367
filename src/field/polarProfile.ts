/**
 * Drawn cross section: a closed curve R(θ) about the skel, 12 cubic Bézier segments of 30° in polar form (Tai et al.
 * (13)–(17), basis B_{n,i}), m = 1/R(θ). The joints are halfway between their neighbours, which makes R differentiable;
 * 24 radii remain. Angles count from x to y; fitted to a drawn loop in polarFit.ts.
 */
import { fastAtan2 } from '../math/atan.ts';
import { TAU } from '../math/trig.ts';
import { FieldError } from '../skeleton/skeleton.ts';
import { radialBend, radialMove, type Section } from './section.ts';

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
  const { largest, smallest, steepest, bend } = polarLimits(radii);
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
    move(x, y, m, rx, ry, out) {
      const rho = Math.sqrt(x * x + y * y);
      const by = Math.max(rx, ry);
      const sine = by < rho ? by / rho : 1;
      const swing = sine < 0.9 ? (steepest * sine) / Math.sqrt(1 - sine * sine) : Infinity;
      const least = Math.max(smallest, 1 / m - swing);
      const most = Math.min(largest, 1 / m + swing);
      out[0] = radialMove(rho, by, m * rho, Math.max(rho - by, 0) / most, (rho + by) / least);
      out[1] = radialBend(rho, by, bend);
    },
    extent: (r) => [r * largest, r * largest],
  };
}

/** Of a checked profile: its radii, and how far it may turn away. */
export function polarLimits(radii: readonly number[]) {
  const [largest, smallest] = [Math.max(...radii), Math.min(...radii)];
  return { largest, smallest, ...slopesOf(controlRadii(radii), smallest) };
}

/**
 * Bounds on |R'|, and on |h'' + h|, h the curve itself: m'' along and 2 m' across, m = 1/R.
 */
function slopesOf(
  control: Float64Array,
  smallest: number,
): { readonly steepest: number; readonly bend: number } {
  let steepest = 0;
  let second = 0;
  for (let i = 0; i < control.length; i += 4) {
    const [r0, r1, r2, r3] = [control[i]!, control[i + 1]!, control[i + 2]!, control[i + 3]!];
    steepest = Math.max(steepest, Math.abs(r1 - r0), Math.abs(r2 - r1), Math.abs(r3 - r2));
    second = Math.max(second, Math.abs(r2 - 2 * r1 + r0), Math.abs(r3 - 2 * r2 + r1));
  }
  const slope = 3 * TURN * steepest;
  const curve = 6 * TURN * TURN * second;
  const m1 = slope / (smallest * smallest);
  const m2 = curve / (smallest * smallest) + (2 * slope * slope) / (smallest * smallest * smallest);
  return { steepest: slope, bend: Math.sqrt(m2 * m2 + 4 * m1 * m1) };
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
