/**
 * The largest field that a skel of weight 1 can have at a distance: a line of some length straight beside the point, a
 * disc of some area right below it (whatever lies farther than r is as far as that of a disc at height r). Kernel units.
 */
import { log1p } from '../math/log.ts';
import { PI } from '../math/trig.ts';
import { rootPower } from './halfPower.ts';
import type { Kernel } from './kernel.ts';

export function mostOfLine(kernel: Kernel, r2: number, length: number, n: number): number {
  const at = Math.max(r2, kernel.floor2.line);
  const whole = kernel.wholeLine ? kernel.wholeLine(at, n) : inverseLine(at, length);
  return Math.min(whole, length * kernel.value(at, n));
}

/** Of q^(−n/2), q = core + r²: without a call of the kernel. `whole`: of the line without end where q is 1. */
export const mostOfPower = (q: number, n: number, length: number, whole: number): number =>
  rootPower(1 / q, n) * Math.min(whole * Math.sqrt(q), length);

/** `turns`: how often an outline may go round a place, `covered`: the area with all turns. */
export function mostOfPlate(kernel: Kernel, r2: number, covered: number, turns: number, n: number): number {
  const at = Math.max(r2, kernel.floor2.plate);
  const whole = kernel.wholePlane ? kernel.wholePlane(at, n) : inversePlate(kernel, at, covered / turns);
  return Math.min(turns * whole, covered * kernel.value(at, n));
}

/** ∫ 1/r: 2 asinh(l/2r) */
function inverseLine(r2: number, length: number): number {
  const h = (0.5 * length) / Math.sqrt(r2);
  return 2 * log1p(h + (h * h) / (1 + Math.sqrt(1 + h * h)));
}

/** Of 1/r and 1/r² over a disc. */
function inversePlate({ homogeneity }: Kernel, z2: number, area: number): number {
  const rim2 = z2 + area / PI;
  return homogeneity === -1 ? (2 * area) / (Math.sqrt(rim2) + Math.sqrt(z2)) : PI * log1p(area / (PI * z2));
}
