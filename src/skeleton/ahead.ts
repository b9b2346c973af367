/**
 * What a field surely is ahead of a point, along whatever ray: value and gradient there, and what bounds how it bends from there on.
 *
 * Theory: a power kernel's source at M = √(core + r²) changes over t by what Gegenbauer's generating function says
 * (kernel/change.ts): value and gradient leave out at most (1 − θ)⁻ⁿ − 1 − nθ of it, θ = t/M. Over θ² that grows with θ, so for a sum
 * with the least M it is at most t² Σ|F|/M² times that of the nearest. So the bound is made once a point, for all t at once; Kalra &
 * Barr (1989) and Hart (1996) take Lipschitz constants of whole boxes, with which steps towards the surface shrink in proportion, and
 * these are Newton's.
 */
import { halfPower } from '../kernel/halfPower.ts';

/**
 * [value, ∂x, ∂y, ∂z, Σ|F|/M² (1/mm²), least M (mm), bound on second derivatives (1/mm²), n, Σ|F|, and in parts of that the largest that
 * first and second derivatives come to anywhere (1/mm, 1/mm²; Infinity: not known), mm up to which all holds]; mutable: skels add to it.
 */
export type Ahead = Float64Array;

export const AHEAD = 12;
export const LOOSE = 4;
export const WIDTH = 5;
export const BEND = 6;
export const POWER = 7;
export const MASS = 8;
export const FIRST = 9;
export const SECOND = 10;
export const LIMIT = 11;

/** θ up to which the bound is used */
const MOST = 0.9;
/** and rounding */
const AT_MOST = MOST * (1 + 1e-9);
const SMALL = 1e-3;
/** x up to which eˣ is */
const GROWN = 3;

/** Of nothing yet. */
export function clearAhead(out: Ahead): void {
  out.fill(0);
  out[WIDTH] = Infinity;
  out[POWER] = 4;
  out[LIMIT] = Infinity;
}

/** How far the bound holds, mm. */
export function known(ahead: Ahead): number {
  const smooth = ahead[SECOND]! < Infinity ? GROWN / ahead[FIRST]! : 0;
  return Math.min(ahead[LIMIT]!, Math.max(MOST * ahead[WIDTH]!, smooth));
}

/** What value and gradient leave out over t ≤ `known`, at most, for each square millimetre of t². */
export function looseness(ahead: Ahead, t: number): number {
  const bend = 0.5 * ahead[BEND]!;
  const loose = ahead[LOOSE]!;
  if (!(loose > 0)) return bend;
  const smooth = 0.5 * ahead[SECOND]! * ahead[MASS]! * grown(ahead[FIRST]! * t);
  const theta = t / ahead[WIDTH]!;
  return bend + (theta < AT_MOST ? Math.min(smooth, loose * relative(theta, ahead[POWER]!)) : smooth);
}

/** A little more than eˣ, in few words: (1 − x/8)⁻⁸. */
function grown(x: number): number {
  if (!(x < 8)) return Infinity;
  const one = 1 / (1 - 0.125 * x);
  const two = one * one;
  return two * two * (two * two);
}

/** ((1 − θ)⁻ⁿ − 1 − nθ)/θ² */
function relative(theta: number, n: number): number {
  const left = 1 - theta;
  const grown = halfPower(left * left, n);
  if (theta < SMALL) return (0.5 * n * (n + 1) * grown) / (left * left);
  return (grown - 1 - n * theta) / (theta * theta);
}
