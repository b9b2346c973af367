/** Fields of curves by dense quadrature, and sums of bound segments. */
import { kernelNamed } from '../../src/kernel/index.ts';
import type { KernelParams } from '../../src/kernel/kernel.ts';
import { gauss } from '../../src/math/quadrature.ts';
import type { Vec3 } from '../../src/math/vec.ts';
import { bindSkel } from '../../src/skeleton/index.ts';
import type { Skel } from '../../src/skeleton/skels.ts';

/** A curve over 0…1 with its speed and weight. */
export interface Curve {
  at(t: number): Vec3;
  speed(t: number): number;
  weight(t: number): number;
}

/** f at a distance of r mm. */
export function kernelAt(name: string, params: KernelParams, r: number): number {
  const kernel = kernelNamed(name)!;
  const unit = kernel.unit(params, 1);
  return kernel.value((r / unit) * (r / unit), params.n ?? 4) * unit ** kernel.homogeneity;
}

/** ∫ w f |c′| dt with 8 points on each of `panels` panels. */
export function curveField(curve: Curve, name: string, params: KernelParams, p: Vec3, panels = 200): number {
  const f = (t: number) => {
    const [x, y, z] = curve.at(t);
    const r = Math.hypot(x - p[0], y - p[1], z - p[2]);
    return curve.weight(t) * curve.speed(t) * kernelAt(name, params, r);
  };
  let sum = 0;
  for (let i = 0; i < panels; i++) sum += gauss(f, i / panels, (i + 1) / panels);
  return sum;
}

/** The sum of the fields of skels, as a function of the point. */
export function sumField(skels: readonly Skel[], name: string, params: KernelParams): (p: Vec3) => number {
  const fields = skels.map((skel) => bindSkel(skel, kernelNamed(name)!, params));
  return (p) => fields.reduce((sum, field) => sum + field.value(...p), 0);
}

export const PARAMS: readonly (readonly [string, KernelParams])[] = [
  ['cauchy', { s: 0.8 }],
  ['gaussian', { s: 0.5 }],
  ['quartic', { R: 4 }],
  ['power', { s: 0.8, n: 3 }],
];
