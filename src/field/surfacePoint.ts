/**
 * Where the surface crosses an edge of a lattice: regula falsi on the field itself, then one step of Newton's with the slope
 * that is wanted for the normal anyway. Tried with secants alone until they agreed to 1e-4 of the edge: three times
 * the values for the same error.
 */
import { add3, dot3, scale3, sub3 } from '../math/tuple.ts';
import type { Vec3 } from '../math/vec.ts';
import type { FieldValue } from '../skeleton/skeleton.ts';

/** values taken along an edge at most; smooth fields need two or three */
const STEPS = 16;
/** After so many every other one halves what is left: beside an axis where the field is nearly infinite, secants come no nearer. */
const SECANTS = 4;
/** parts of the edge between two secants, and of the smaller end's value: Newton's step does the rest */
const CLOSE = 1e-2;
const SMALL = 0.05;
/** parts of the edge: a longer step of Newton's is none */
const POLISH = 0.05;
/** Parts of the edge that are kept from its ends: edges that meet at a node must not put their vertices into one place. */
const ENDS = 1e-4;

/** What is looked at along an edge. */
export interface Crossed {
  value(x: number, y: number, z: number): number;
  evaluate(x: number, y: number, z: number, out: FieldValue): void;
}

export interface SurfacePoint {
  readonly at: Vec3;
  /** unit, out of where the field is positive; null where it has no slope */
  readonly normal: Vec3 | null;
}

const value = new Float64Array(4);

/** Between a and b, with values of opposite signs there. */
export function surfacePoint(field: Crossed, a: Vec3, b: Vec3, valueA: number, valueB: number): SurfacePoint {
  const along = sub3(b, a);
  const t = crossing(field, a, along, valueA, valueB);
  const near = add3(a, scale3(along, t));
  field.evaluate(...near, value);
  const gradient: Vec3 = [value[1]!, value[2]!, value[3]!];
  const step = -value[0]! / dot3(gradient, along);
  const polished = Math.abs(step) < POLISH ? kept(t + step) : t;
  return { at: add3(a, scale3(along, polished)), normal: outward(gradient) };
}

/** A part of an edge, off its ends; at the first where it is no number. */
export const kept = (t: number): number => (t > ENDS ? (t < 1 - ENDS ? t : 1 - ENDS) : ENDS);

/** Nearly the part of the way at which the field is 0. Illinois: the end that stays counts half, or it would stay for ever. */
function crossing(field: Crossed, a: Vec3, along: Vec3, valueA: number, valueB: number): number {
  const small = SMALL * Math.min(Math.abs(valueA), Math.abs(valueB));
  let [low, high, atLow, atHigh] = [0, 1, valueA, valueB];
  let [guess, last] = [Number.NaN, Number.NaN];
  let t = 0.5;
  let stayed = 0;
  for (let i = 0; i < STEPS; i++) {
    const secant = low + ((high - low) * atLow) / (atLow - atHigh);
    const before = guess;
    guess = secant > low && secant < high ? secant : 0.5 * (low + high);
    t = guess;
    // two that agree mean nothing beside the steep end of a singular kernel
    if (Math.abs(guess - before) < CLOSE && Math.abs(last) < small) break;
    if (i >= SECANTS && i % 2 === 0) t = 0.5 * (low + high);
    last = field.value(a[0] + t * along[0], a[1] + t * along[1], a[2] + t * along[2]);
    if (last === 0) break;
    if (last > 0 === valueA > 0) {
      [low, atLow] = [t, last];
      if (stayed === 1) atHigh /= 2;
      stayed = 1;
    } else {
      [high, atHigh] = [t, last];
      if (stayed === -1) atLow /= 2;
      stayed = -1;
    }
  }
  return kept(t);
}

function outward([gx, gy, gz]: Vec3): Vec3 | null {
  // squares of the slopes of singular kernels may overflow
  const most = Math.max(Math.abs(gx), Math.abs(gy), Math.abs(gz));
  if (!(most > 0 && most < Infinity)) return null;
  const [ux, uy, uz] = [gx / most, gy / most, gz / most];
  const length = -Math.sqrt(ux * ux + uy * uy + uz * uz);
  return [ux / length, uy / length, uz / length];
}
