/** How fields are compared: relative to the scale of tests/fixtures/vectors, over specimens and kernels. */
import { expect } from 'vitest';
import type { Vec3 } from '../../src/math/vec.ts';
import type { SkelField } from '../../src/skeleton/skeleton.ts';
import type { Skel } from '../../src/skeleton/skels.ts';
import { lineWeight, plateWeight } from '../../src/skeleton/weight.ts';
import { type Variant, variants } from '../kernel/variants.ts';
import { everySpecimen, pointsAround } from './specimens.ts';

export const SEED = 11;

export function evaluated(field: SkelField, [x, y, z]: Vec3): Float64Array {
  const out = new Float64Array(4);
  field.add(x, y, z, 1, out);
  return out;
}

export const norm = (v: ArrayLike<number>, from = 0) => Math.hypot(...Array.from(v).slice(from));

/** The README's scale, and its width: the field of the skel without its ends, as near as the kernel's width. */
export function scaleOf(
  skel: Skel,
  { kernel, params }: Variant,
  p: Vec3,
): { readonly size: number; readonly width: number } {
  const width = kernel.homogeneity === 0 ? kernel.unit(params, 1) : Infinity;
  const near = 1e-3 * Math.min(width, 1);
  if (skel.type === 'point') return { size: width < Infinity ? Math.abs(skel.weight) : 0, width };
  if (skel.type === 'segment') {
    if (width === Infinity) return { size: 0, width };
    const length = Math.hypot(skel.b[0] - skel.a[0], skel.b[1] - skel.a[1], skel.b[2] - skel.a[2]);
    const most = skel.weights.reduce((sum, w, k) => sum + Math.abs(w) * length ** k, 0);
    return { size: most / lineWeight(kernel, params, near, 1, length), width };
  }
  const { u, v, origin } = skel;
  const n = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]] as const;
  const z = Math.abs(n.reduce((sum, c, i) => sum + c * (p[i]! - origin[i]!), 0)) / norm(n);
  const height = width < Infinity ? near : z;
  return {
    size: Math.abs(skel.weight) / plateWeight(kernel, params, height, 1, 100),
    width: Math.min(width, z),
  };
}

export function expectSame(
  found: ArrayLike<number>,
  wanted: ArrayLike<number>,
  scale: ReturnType<typeof scaleOf>,
  what: string,
) {
  const value = Math.abs(found[0]! - wanted[0]!) / (Math.max(Math.abs(wanted[0]!), scale.size) || 1);
  if (!(value < 1e-10)) expect(value, `value ${what}`).toBeLessThan(1e-10);
  const miss = Math.hypot(found[1]! - wanted[1]!, found[2]! - wanted[2]!, found[3]! - wanted[3]!);
  const steep = Math.max(norm(wanted, 1), scale.size / scale.width || 0) || 1;
  if (!(miss / steep < 1e-10)) expect(miss / steep, `gradient ${what}`).toBeLessThan(1e-10);
}

/** Exponents of each kind: closed at once, by a step of the recurrence, and sampled. The kernels' own suite has all. */
const EXPONENTS = [2, 2.5, 3, 5, 6];
export const some = variants.filter(({ params: { n } }) => n === undefined || EXPONENTS.includes(n));

export function eachSpecimen(visit: (skel: Skel, p: Vec3, what: string) => void, count = 4): void {
  everySpecimen.forEach((skel, i) => {
    for (const p of pointsAround(skel, SEED + i, count)) visit(skel, p, `of ${JSON.stringify(skel)} at ${p}`);
  });
}
