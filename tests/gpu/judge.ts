/** How far a float32 field may be from the truth: the tolerances of the reference vectors, for any skel and kernel. */
import { expect } from 'vitest';
import { evaluatePairs } from '../../src/gpu/pairs.ts';
import type { KernelSkel } from '../../src/gpu/records.ts';
import type { Vec3 } from '../../src/math/vec.ts';
import { regionOf } from '../../src/skeleton/region.ts';
import { withDevice } from './compute.ts';

export interface Case extends KernelSkel {
  readonly title: string;
  readonly p: Vec3;
  /** the truth: value and gradient */
  readonly truth: ArrayLike<number>;
}

export interface Errors {
  /** of what is allowed */
  readonly value: number;
  readonly gradient: number;
}

/** Expects every error to be allowed, and prints the worst of each kernel. */
export function expectAllowed(title: string, cases: readonly Case[], errors: readonly Errors[]): void {
  const wrong: string[] = [];
  const worst = new Map<string, Errors>();
  cases.forEach((one, i) => {
    const { value, gradient } = errors[i]!;
    const name = [one.kernel.name, one.params.n].join(' ').trim();
    const before = worst.get(name) ?? { value: 0, gradient: 0 };
    // not by Math.max: what is no number is worst
    worst.set(name, {
      value: value <= before.value ? before.value : value,
      gradient: gradient <= before.gradient ? before.gradient : gradient,
    });
    if (!(value <= 1 && gradient <= 1)) wrong.push(`${one.title}: ${value}, ${gradient}`);
  });
  const rows = [...worst].map(
    ([kernel, { value, gradient }]) => `${kernel} ${value.toFixed(2)} ${gradient.toFixed(2)}`,
  );
  console.info(`${title}, worst of what is allowed (value, gradient): ${rows.join(', ')}`);
  expect(wrong).toEqual([]);
}

interface Scale {
  /** what errors of the value are relative to, less |value| itself */
  readonly value: number;
  /** the same by this length is the scale of gradients; mm */
  readonly width: number;
  /** allowed, of the scale */
  readonly tolerance: Errors;
}

const TOLERANCE: Errors = { value: 2e-6, gradient: 1e-5 };

/**
 * Errors of what the GPU makes of each case.
 */
export async function judged(cases: readonly Case[]): Promise<Errors[]> {
  const points = Float32Array.from(cases.flatMap(({ p }) => p));
  const values = await withDevice((device) => evaluatePairs(device, cases, points));
  return cases.map((one, i) => errorsOf(one, values.subarray(4 * i, 4 * i + 4)));
}

function errorsOf(one: Case, found: ArrayLike<number>): Errors {
  const { truth } = one;
  const { value, width, tolerance } = scaleOf(one);
  const slope = Math.hypot(truth[1]!, truth[2]!, truth[3]!);
  const off = Math.hypot(found[1]! - truth[1]!, found[2]! - truth[2]!, found[3]! - truth[3]!);
  const valueError = Math.abs(found[0]! - truth[0]!);
  const ratio = (error: number, scale: number) => (error === 0 ? 0 : error / scale);
  return {
    value: ratio(valueError, tolerance.value * Math.max(Math.abs(truth[0]!), value)),
    gradient: ratio(off, tolerance.gradient * Math.max(slope, value / width)),
  };
}

function scaleOf(one: Case): Scale {
  const { skel, kernel, params } = one;
  const exponent = params.n ?? 4;
  if (skel.type === 'polygon') return ofPlate(one, exponent);
  if (skel.type === 'point') {
    const width = kernel.homogeneity === 0 ? kernel.unit(params, 1) : 1;
    return { value: kernel.homogeneity === 0 ? Math.abs(skel.weight) : 0, width, tolerance: TOLERANCE };
  }
  const length = Math.hypot(...skel.b.map((x, axis) => x - skel.a[axis]!));
  if (kernel.homogeneity !== 0) {
    const relative = 2 * (5e-6 + (1e-6 * length) / distance(one));
    return { value: 0, width: 1, tolerance: { value: relative, gradient: relative } };
  }
  const weight = skel.weights.reduce((sum, w, k) => sum + Math.abs(w) * length ** k, 0);
  const width = kernel.unit(params, length);
  return {
    value: weight * width * kernel.wholeLine!(0, exponent),
    width,
    tolerance: allowing((0.5 * length) / width),
  };
}

/** A place is known to 2⁻²⁴ of the numbers it is made of, which counts when the kernel is narrow. */
function allowing(extent: number): Errors {
  const lost = 2 ** -24 * extent;
  return { value: TOLERANCE.value + lost, gradient: TOLERANCE.gradient + 2 * lost };
}

function ofPlate({ skel, kernel, params, p }: Case, exponent: number): Scale {
  if (skel.type !== 'polygon') throw new Error('a polygon');
  const { n, middle, radius } = regionOf(skel);
  const z = Math.abs(n.reduce((sum, x, axis) => sum + x * (p[axis]! - middle[axis]!), 0));
  const free = kernel.homogeneity !== 0;
  const unit = kernel.unit(params, radius);
  const plate = kernel.wholePlane?.(free ? (z / unit) ** 2 : 0, exponent) ?? Infinity;
  // where no unbounded plate has a field: that of a disc as wide as the point is far
  const reached = Math.hypot(...p.map((x, axis) => x - middle[axis]!)) / unit;
  const scale = Number.isFinite(plate)
    ? plate
    : Math.PI * (1 + reached) ** (2 - (-kernel.homogeneity || exponent));
  return {
    value: Math.abs(skel.weight) * scale * unit ** (2 + kernel.homogeneity),
    width: free ? z : unit,
    tolerance: allowing(radius / (free ? z : unit)),
  };
}

/** of the point from the segment */
function distance({ skel, p }: Case): number {
  if (skel.type !== 'segment') throw new Error('a segment');
  const along = skel.b.map((x, axis) => x - skel.a[axis]!);
  const from = p.map((x, axis) => x - skel.a[axis]!);
  const dot = (v: readonly number[], w: readonly number[]) => v.reduce((sum, x, i) => sum + x * w[i]!, 0);
  const t = Math.min(1, Math.max(0, dot(from, along) / dot(along, along)));
  return Math.hypot(...from.map((x, axis) => x - t * along[axis]!));
}
