/** What the curve skeletons share: distances, and how fast a kernel can change. */
import type { Kernel, KernelParams } from '../kernel/kernel.ts';
import { length3, sub3 } from '../math/tuple.ts';
import type { Vec3 } from '../math/vec.ts';
import { FieldError } from './skeleton.ts';

export function distance3(a: Vec3, b: Vec3): number {
  return length3(sub3(b, a));
}

/** How closely a curve is followed by segments. */
export interface Fidelity {
  /** largest error of the field, in its unit (a fraction of T, say) */
  readonly fieldError: number;
  /** mm from the curve from which on that holds; above 0 for kernels that are infinite on the skel */
  readonly distance: number;
}

/** What a kernel can do at distances of at least `from` mm from a skel. */
export interface Steepness {
  /** largest |f| */
  readonly value: number;
  /** largest |df/dr|, 1/mm */
  readonly slope: number;
  /** ∫_0^length of the largest slope at each distance or beyond it */
  total(length: number): number;
}

const STEP = 0.005;
const STEPS = 4000;
/** what falls between two steps */
const MARGIN = 1.001;

/** All kernels fall with the distance, and have done most of it within 20 units. FieldError for a singular one from 0. */
export function steepness(kernel: Kernel, params: KernelParams, from: number): Steepness {
  if (!(from >= 0 && from < Infinity)) throw new FieldError(`distance must be at least 0 mm, got ${from}`);
  const isSingular = kernel.homogeneity !== 0;
  if (isSingular && from === 0) throw new FieldError(`kernel ${kernel.name} needs a distance above 0 mm`);
  const exponent = params.n ?? 4;
  const unit = kernel.unit(params, from);
  const r0 = from / unit;
  // f(c r) = c^h f(r)
  const scale = isSingular ? integerPower(unit, kernel.homogeneity) : 1;
  const slopes = new Float64Array(STEPS + 1);
  let steepest = 0;
  for (let i = STEPS; i >= 0; i--) {
    const r = r0 + i * STEP;
    if (r <= kernel.support) steepest = Math.max(steepest, Math.abs(2 * r * kernel.slope(r * r, exponent)));
    slopes[i] = (MARGIN * scale * steepest) / unit;
  }
  const slope = slopes[0]!;
  return {
    value: scale * Math.abs(r0 <= kernel.support ? kernel.value(r0 * r0, exponent) : 0),
    slope,
    total(length) {
      let sum = slope * Math.min(length, from);
      const step = STEP * unit;
      for (let i = 0; i <= STEPS; i++) {
        const rest = length - from - i * step;
        if (rest <= 0) return sum;
        sum += slopes[i]! * (i < STEPS ? Math.min(step, rest) : rest);
      }
      return sum;
    },
  };
}

/**
 * How far (mm) points of a curve may be moved for its field to change by at most `error`. At most `winding` · x of the
 * curve lies in any ball of radius x, so that ∫|f′(r)| ds ≤ winding · total(length / winding) wherever the point is.
 */
export function allowedShift(
  { slope, total }: Steepness,
  error: number,
  weight: number,
  length: number,
  winding: number,
): number {
  if (weight === 0 || length === 0) return Infinity;
  const most = winding * total(length / winding);
  const shift = error / (weight * most);
  // a point that was moved may be nearer by as much
  return error / (weight * (most + winding * shift * slope));
}

function integerPower(x: number, n: number): number {
  let product = 1;
  for (let i = 0; i < Math.abs(n); i++) product *= x;
  return n < 0 ? 1 / product : product;
}

/** FieldError when a curve would need more pieces. */
export const MOST_PIECES = 4096;
