/**
 * How rows are shared out along u: stops are always rows, and between them rows are even in u, that is by arc
 * length, about as many in all as were asked for.
 */
import { ON_CORNER } from './side.ts';

/** Rows of one smooth piece: ascending u, the first and the last on its stops. */
export type Piece = readonly number[];

/**
 * `stops` ascending; `quads` is the wish for all pieces together. Each piece gets at least one quad, or what
 * `least` asks for (a piece between two poles needs two, else it would have no inside).
 */
export function pieces(
  stops: readonly number[],
  quads: number,
  least: (piece: number) => number = () => 1,
): Piece[] {
  const from = stops[0]!;
  const whole = stops[stops.length - 1]! - from;
  return stops.slice(1).map((end, i) => {
    const start = stops[i]!;
    const share = whole > 0 ? Math.round((quads * (end - start)) / whole) : 1;
    const count = Math.max(share, least(i), 1);
    // both ends exactly, for rows at one stop must lie in one place bit for bit
    return Array.from({ length: count + 1 }, (_, k) =>
      k === count ? end : start + ((end - start) * k) / count,
    );
  });
}

/** The piece between stops that holds u; at a stop the one before (−1) or after (1) it. */
export function pieceAt(stops: readonly number[], u: number, side: -1 | 1): number {
  const last = stops.length - 2;
  for (let k = 0; k < last; k++) {
    if (side === 1 ? u < stops[k + 1]! - ON_CORNER : u < stops[k + 1]! + ON_CORNER) return k;
  }
  return last;
}

/** A number of quads, rounded and at least `least`. Throws RangeError when it is no number. */
export function quadCount(name: string, wish: number, least: number): number {
  if (!Number.isFinite(wish)) throw new RangeError(`surface: ${name} must be a number of quads, got ${wish}`);
  return Math.max(Math.round(wish), least);
}
