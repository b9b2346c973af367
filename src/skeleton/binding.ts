/** What all skels need when a kernel is chosen for them: checked parameters, and how far a bound on the field reaches. */
import type { Kernel, KernelParams } from '../kernel/kernel.ts';
import { FieldError } from './skeleton.ts';

/** Parameters with defaults where they are missing; FieldError for what is unknown or out of range. */
export function checkedParams(kernel: Kernel, params: KernelParams): KernelParams {
  const known = kernel.params.map(({ name }) => name as string);
  for (const name of Object.keys(params)) {
    if (known.includes(name)) continue;
    const has = known.length > 0 ? `it has ${known.join(', ')}` : 'it has none';
    throw new FieldError(`the kernel ${kernel.name} has no parameter ${name}; ${has}`);
  }
  const entries = kernel.params.map(({ name, min, max, default: usual }) => {
    const value = params[name] ?? usual;
    if (value >= min && value <= max) return [name, value] as const;
    throw new FieldError(`${kernel.name}: ${name} must be from ${min} to ${max}, found ${value}`);
  });
  return Object.fromEntries(entries);
}

/** mm: the farthest a skel may be from the origin; fields of larger numbers overflow in float32, and at last in float64 */
const FARTHEST = 1e15;
/** the largest weight: a point of r⁻⁵ with a radius of 1e6 mm needs 1e30 */
const HEAVIEST = 1e60;
/** mm: shorter lines are none */
export const SHORTEST = 1e-15;

/** FieldError when one of the lengths or coordinates, in mm, is no finite number or beyond all reason. */
export function checkPlaces(what: string, numbers: Iterable<number>): void {
  checkWithin(what, numbers, FARTHEST, ' mm');
}

/** The same for weights, angles and other numbers. */
export function checkNumbers(what: string, numbers: Iterable<number>): void {
  checkWithin(what, numbers, HEAVIEST, '');
}

function checkWithin(what: string, numbers: Iterable<number>, most: number, unit: string): void {
  for (const number of numbers) {
    if (Math.abs(number) <= most) continue;
    throw new FieldError(`${what} must be numbers within ±${most}${unit}, found ${number}`);
  }
}

/**
 * The distance, in the units of `bound`, at which a bound that falls with the squared distance comes down to `threshold`; 0
 * where it never is above, Infinity for a threshold that is not above 0. Bisection: formulas like Zhu's (17)–(19) exist for
 * some kernels only, and take the root of a negative number where there is nothing to bound.
 */
export function reach(bound: (r2: number) => number, threshold: number, support: number): number {
  if (!(threshold > 0)) return support;
  if (bound(0) <= threshold) return 0;
  let far = 1;
  while (far < support && bound(far * far) > threshold && far < 1e150) far *= 2;
  far = Math.min(far, support);
  let near = far > 1 ? far / 4 : 0;
  for (let i = 0; i < 60; i++) {
    const middle = 0.5 * (near + far);
    if (bound(middle * middle) > threshold) near = middle;
    else far = middle;
  }
  return far;
}

/** c^n for whole n from −5 to 5: the same bits everywhere. */
export function whole(c: number, n: number): number {
  let power = 1;
  for (let i = Math.abs(n); i > 0; i--) power *= c;
  return n < 0 ? 1 / power : power;
}
