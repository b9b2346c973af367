/**
 * A weight curve drawn along a line of segments (Jin & Tai, "Weight distribution control with cubic profile curves"):
 * keys with tension, continuity and bias (Kochanek & Bartels 1984), or Bézier ordinates. Both are cubics in the fraction of
 * the length, so that each piece is a segment with a weight of degree 3 and nothing is approximated.
 */
import { add3, length3, scale3 } from '../math/tuple.ts';
import type { Vec3 } from '../math/vec.ts';
import { distance3 } from './curve.ts';
import { FieldError } from './skeleton.ts';
import type { SegmentSkel } from './skels.ts';

export interface ProfileKey {
  /** fraction of the length, rising from 0 to 1 */
  readonly at: number;
  readonly weight: number;
  /** −1…1 each, 0 when left out */
  readonly tension?: number;
  readonly continuity?: number;
  readonly bias?: number;
}

export type WeightCurve =
  | { readonly type: 'keys'; readonly keys: readonly ProfileKey[] }
  /** 3 n + 1 ordinates at even fractions, n pieces */
  | { readonly type: 'bezier'; readonly ordinates: readonly number[] };

export interface ProfileSkel {
  readonly type: 'profile';
  readonly points: readonly Vec3[];
  readonly curve: WeightCurve;
}

/** w(v) = Σ coefficients[k] v^k, v = 0 at `from`, 1 at `to` (fractions of the whole length). */
export interface WeightPiece {
  readonly from: number;
  readonly to: number;
  readonly coefficients: readonly [number, number, number, number];
}

/**
 * Of the size of the numbers: where a piece of the curve ends at a vertex but for rounding, what is left between them is no
 * segment. It has no direction, and a cross section needs one.
 */
const GRAIN = 1e-12;

/** FieldError for curves and lines that do not fit. */
export function expandProfile({ points, curve }: ProfileSkel): SegmentSkel[] {
  const pieces = weightPieces(curve);
  const lengths = points.slice(1).map((p, i) => distance3(points[i]!, p));
  const total = lengths.reduce((sum, length) => sum + length, 0);
  if (!(total > 0 && total < Infinity)) throw new FieldError('a profile needs two points that are apart');
  let start = 0;
  return lengths.flatMap((length, i) => {
    const [from, to] = [start / total, i === lengths.length - 1 ? 1 : (start + length) / total];
    start += length;
    if (length === 0) return [];
    return pieces
      .filter((piece) => Math.min(piece.to, to) > Math.max(piece.from, from))
      .map((piece) => {
        const [u0, u1] = [Math.max(piece.from, from), Math.min(piece.to, to)];
        const at = (u: number) => mix(points[i]!, points[i + 1]!, (u - from) / (to - from));
        return { type: 'segment', a: at(u0), b: at(u1), weights: restricted(piece, u0, 1 / total) } as const;
      })
      .filter(({ a, b }) => distance3(a, b) > GRAIN * (total + length3(a)));
  });
}

export function weightPieces(curve: WeightCurve): WeightPiece[] {
  return curve.type === 'keys' ? fromKeys(curve.keys) : fromBezier(curve.ordinates);
}

/** The piece's polynomial in mm from the fraction `u0`; `perMm` fractions a mm. */
function restricted(
  { from, to, coefficients: [c0, c1, c2, c3] }: WeightPiece,
  u0: number,
  perMm: number,
): number[] {
  const v = (u0 - from) / (to - from);
  const k = perMm / (to - from);
  return [
    c0 + v * (c1 + v * (c2 + v * c3)),
    k * (c1 + v * (2 * c2 + 3 * v * c3)),
    k * k * (c2 + 3 * v * c3),
    k * k * k * c3,
  ];
}

function fromBezier(ordinates: readonly number[]): WeightPiece[] {
  const count = (ordinates.length - 1) / 3;
  if (!(Number.isInteger(count) && count >= 1 && ordinates.every(Number.isFinite))) {
    throw new FieldError(`a Bézier curve needs 4, 7, 10 … ordinates, got ${ordinates.length}`);
  }
  return Array.from({ length: count }, (_, i) => {
    const [a, b, c, d] = ordinates.slice(3 * i, 3 * i + 4) as [number, number, number, number];
    const coefficients = [a, 3 * (b - a), 3 * (a - 2 * b + c), d - a + 3 * (b - c)] as const;
    return { from: i / count, to: (i + 1) / count, coefficients };
  });
}

function fromKeys(keys: readonly ProfileKey[]): WeightPiece[] {
  checkKeys(keys);
  return keys.slice(1).map((end, i) => {
    const start = keys[i]!;
    const rise = end.weight - start.weight;
    const d0 = tangent(keys, i, 1);
    const d1 = tangent(keys, i + 1, -1);
    const coefficients = [start.weight, d0, 3 * rise - 2 * d0 - d1, d0 + d1 - 2 * rise] as const;
    return { from: start.at, to: end.at, coefficients };
  });
}

/** Per interval, leaving key i forwards (1) or arriving at it from before (−1). */
function tangent(keys: readonly ProfileKey[], i: number, direction: 1 | -1): number {
  const { at, weight, tension = 0, continuity = 0, bias = 0 } = keys[i]!;
  const before = keys[i - 1] ?? null;
  const after = keys[i + 1] ?? null;
  const gapBefore = before ? at - before.at : after!.at - at;
  const gapAfter = after ? after.at - at : gapBefore;
  const riseBefore = before ? weight - before.weight : after!.weight - weight;
  const riseAfter = after ? after.weight - weight : riseBefore;
  const c = direction * continuity;
  const even = 0.5 * (1 - tension) * ((1 + bias) * (1 + c) * riseBefore + (1 - bias) * (1 - c) * riseAfter);
  // the paper's correction for intervals of unequal length
  return (even * 2 * (direction === 1 ? gapAfter : gapBefore)) / (gapBefore + gapAfter);
}

function checkKeys(keys: readonly ProfileKey[]): void {
  const rising = keys.every(({ at }, i) => i === 0 || at > keys[i - 1]!.at);
  if (keys.length < 2 || !rising || keys[0]!.at !== 0 || keys.at(-1)!.at !== 1) {
    throw new FieldError('keys must rise from 0 to 1');
  }
  keys.forEach(({ weight, tension = 0, continuity = 0, bias = 0 }, i) => {
    if (!Number.isFinite(weight)) throw new FieldError(`keys[${i}]: weight must be a number, got ${weight}`);
    const wrong = [tension, continuity, bias].find((value) => !(value >= -1 && value <= 1));
    if (wrong !== undefined)
      throw new FieldError(`keys[${i}]: tension, continuity and bias are −1…1, got ${wrong}`);
  });
}

/** a at t = 0 and b at t = 1, both exactly. */
function mix(a: Vec3, b: Vec3, t: number): Vec3 {
  return add3(scale3(a, 1 - t), scale3(b, t));
}
