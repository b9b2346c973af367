/**
 * The kernels: one line each is the registry. A new kernel is a file that meets the contract of kernel.ts and a line here;
 * the conformance suites test it, menus and files know it by its name.
 */
import { cauchy } from './cauchy.ts';
import { gaussian } from './gaussian.ts';
import { inverse } from './inverse.ts';
import { inverseCubic } from './inverseCubic.ts';
import { inverseQuintic } from './inverseQuintic.ts';
import { inverseSquared } from './inverseSquared.ts';
import type { Kernel } from './kernel.ts';
import { power } from './power.ts';
import { quartic } from './quartic.ts';

export const kernels: readonly Kernel[] = [
  cauchy,
  gaussian,
  quartic,
  inverse,
  inverseSquared,
  inverseCubic,
  inverseQuintic,
  power,
];

/** By name; undefined where there is none. */
export const kernelNamed = (name: string): Kernel | undefined =>
  kernels.find((kernel) => kernel.name === name);
