/**
 * Spline of quadratic Bézier pieces with a weight at each joint (linear in the curve's parameter), followed by chords until
 * a proven bound on the field's error is met.
 *
 * Theory: c(t) is paired with the chord's point at t; they are at most |p₀ − 2p₁ + p₂|/4 apart, and allowedShift (curve.ts)
 * says how far they may be. The mass w|c′| dt, no polynomial, is carried by w times the line between the speeds at both
 * ends, which lies above since |c′| is convex: an error of at most max|f| max|w| (½(|c′₀| + |c′₁|) − length). Four fifths
 * of the error are for places, the rest for masses; pieces are even in t, those that miss their share of mass are halved.
 * Departure: instead of a fixed count. w times a line is a weight of degree 2, which segments integrate exactly. The true
 * error was 0.13–0.15 of the bound.
 */
import type { Kernel, KernelParams } from '../kernel/kernel.ts';
import { gauss } from '../math/quadrature.ts';
import { PI, TAU } from '../math/trig.ts';
import { add3, dot3, length3, scale3, sub3 } from '../math/tuple.ts';
import type { Vec3 } from '../math/vec.ts';
import { checkNumbers, checkPlaces } from './binding.ts';
import { allowedShift, distance3, type Fidelity, MOST_PIECES, type Steepness, steepness } from './curve.ts';
import { FieldError } from './skeleton.ts';
import type { SegmentSkel } from './skels.ts';

export interface QuadraticSkel extends Fidelity {
  readonly type: 'quadratic';
  /** 2 n + 1: on the curve, off, on, off … on */
  readonly points: readonly Vec3[];
  /** n + 1, at the points on the curve */
  readonly weights: readonly number[];
}

/** A quadratic Bézier curve with the weights at its ends. */
interface Piece {
  readonly p: readonly [Vec3, Vec3, Vec3];
  readonly w: readonly [number, number];
}

/** of the error, for points that were moved; the rest for masses */
const PLACES = 0.8;

/** FieldError for numbers that do not fit, and when more than MOST_PIECES chords were needed. */
export function expandQuadratic(skel: QuadraticSkel, kernel: Kernel, params: KernelParams): SegmentSkel[] {
  const { points, weights, fieldError, distance } = skel;
  checkPlaces('the points of a spline', points.flat());
  checkNumbers('the weights of a spline', weights);
  const count = weights.length - 1;
  if (count < 1 || points.length !== 2 * count + 1) {
    throw new FieldError(
      `${weights.length} weights need ${2 * count + 1} points (at least 3), got ${points.length}`,
    );
  }
  if (!(fieldError > 0)) throw new FieldError(`fieldError must be above 0, got ${fieldError}`);
  const steep = steepness(kernel, params, distance / 2);
  const segments = weights.slice(1).flatMap((w1, i) => {
    const [a, b, c] = points.slice(2 * i, 2 * i + 3) as [Vec3, Vec3, Vec3];
    const even = evenPieces({ p: [a, b, c], w: [weights[i]!, w1] }, skel, fieldError / count, steep);
    const share = ((1 - PLACES) * fieldError) / count / even.length;
    return even.flatMap((piece) => {
      const chords = follow(piece, share, steep.value, 0);
      if (!chords) throw tooMany(fieldError);
      return chords;
    });
  });
  if (segments.length === 0) throw new FieldError('a curve needs two points that are apart');
  return segments;
}

/** Even in the parameter, all as far from their chords: |Δ|/4n². */
function evenPieces(
  piece: Piece,
  { distance, fieldError }: Fidelity,
  error: number,
  steep: Steepness,
): Piece[] {
  const [a, b, c] = piece.p;
  const [start, end] = [sub3(b, a), sub3(c, b)];
  const heaviest = Math.max(Math.abs(piece.w[0]), Math.abs(piece.w[1]));
  const shift = allowedShift(
    steep,
    PLACES * error,
    heaviest,
    length3(start) + length3(end),
    winding(start, end),
  );
  const nearest = distance > 0 ? distance / 2 : Infinity;
  const count = Math.max(Math.ceil(Math.sqrt(length3(sub3(end, start)) / 4 / Math.min(shift, nearest))), 1);
  if (!(count <= MOST_PIECES)) throw tooMany(fieldError);
  return Array.from({ length: count }, (_, i) => part(piece, i / count, (i + 1) / count));
}

/** What a ball of radius 1 holds of the curve: twice as much as of its chord, at most a convex curve's equator. */
function winding(start: Vec3, end: Vec3): number {
  const product = length3(start) * length3(end);
  const halfTurn = product > 0 ? Math.sqrt(Math.max(0.5 * (1 + dot3(start, end) / product), 0)) : 0;
  return halfTurn > 1 / PI ? 2 / halfTurn : TAU;
}

/** null where the halving finds no end */
function follow(piece: Piece, share: number, most: number, depth: number): SegmentSkel[] | null {
  const segment = chord(piece);
  const { mass, excess } = masses(piece);
  if (mass === 0) return [];
  if (segment && most * excess <= share) return [segment];
  if (depth > 12) return null;
  const [first, second] = [0, 0.5].map((t) => follow(part(piece, t, t + 0.5), share / 2, most, depth + 1));
  return first && second ? [...first, ...second] : null;
}

/** ∫|c′| by the line between the speeds at both ends, and what of it, times the larger weight, is too much. */
function masses({ p: [a, b, c], w }: Piece): { readonly mass: number; readonly excess: number } {
  const [start, end] = [scale3(sub3(b, a), 2), scale3(sub3(c, b), 2)];
  const speed = (t: number) => length3(add3(scale3(start, 1 - t), scale3(end, t)));
  const mass = 0.5 * (length3(start) + length3(end));
  const heaviest = Math.max(Math.abs(w[0]), Math.abs(w[1]));
  return { mass, excess: heaviest * Math.max(mass - gauss(speed, 0, 1), 0) };
}

/** w(t) times the line between the speeds at both ends, over the chord instead of over t; null when it has no length. */
function chord({ p: [a, b, c], w }: Piece): SegmentSkel | null {
  const length = distance3(a, c);
  if (length === 0) return null;
  const [s0, s1] = [2 * distance3(a, b), 2 * distance3(b, c)];
  const [dw, ds] = [w[1] - w[0], s1 - s0];
  const k = 1 / length;
  const weights = [w[0] * s0 * k, (w[0] * ds + dw * s0) * k * k, dw * ds * k * k * k];
  while (weights.length > 1 && weights.at(-1) === 0) weights.pop();
  return { type: 'segment', a, b: c, weights };
}

/** From t = u to t = v: the polar form at (u, u), (u, v), (v, v). */
function part({ p: [a, b, c], w }: Piece, u: number, v: number): Piece {
  const mix = (p: Vec3, q: Vec3, t: number) => add3(scale3(p, 1 - t), scale3(q, t));
  const at = (s: number, t: number) => mix(mix(a, b, s), mix(b, c, s), t);
  const weight = (t: number) => (1 - t) * w[0] + t * w[1];
  return { p: [at(u, u), at(u, v), at(v, v)], w: [weight(u), weight(v)] };
}

function tooMany(error: number): FieldError {
  return new FieldError(`fieldError ${error} needs more than ${MOST_PIECES} chords`);
}
