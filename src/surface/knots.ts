/**
 * Where the knots of a spline lie on a parameter that has places of its own: pieces end at breaks (creases, poles), and inside a
 * piece given places are knots too, by running through the parameter a little unevenly, without a jump in speed.
 *
 * Departure: knots are uniform, for subdivision's sake. Tried instead: steps that are even between places; the jump in speed
 * at a place shows as a ripple of 3e-4 of the length.
 */
import { type Ascending, ascending } from './monotone.ts';

/** One smooth piece: t runs from 0 to `spans`, a knot at every whole number. */
export interface KnotPiece {
  readonly from: number;
  readonly to: number;
  readonly spans: number;
  /** the parameter at t */
  readonly map: Ascending;
}

/** places nearer to a break are in it */
export const IN_BREAK = 2e-3;

/**
 * Pieces between ascending breaks, `spans` shared out by length (about as many in all). Each piece gets at least `least` of it,
 * and one for every step between its places.
 */
export function knotPieces(
  breaks: readonly number[],
  places: readonly number[],
  spans: number,
  least: (piece: number) => number = () => 1,
): KnotPiece[] {
  const whole = breaks[breaks.length - 1]! - breaks[0]!;
  return breaks.slice(1).map((to, i) => {
    const from = breaks[i]!;
    const inside = places.filter((p) => p > from + IN_BREAK && p < to - IN_BREAK);
    const stops = [from, ...apart(inside), to];
    const share = whole > 0 ? Math.round((spans * (to - from)) / whole) : 1;
    const count = Math.max(share, least(i), stops.length - 1);
    const ts = wholeSteps(stops, count);
    return { from, to, spans: count, map: ascending(ts, stops) };
  });
}

/** The parameter at every knot, after each span was halved `times` times; both ends exactly. */
export function knotsOf({ from, to, spans, map }: KnotPiece, times = 0): number[] {
  const count = spans * (1 << times);
  return Array.from({ length: count + 1 }, (_, k) => {
    if (k === 0) return from;
    return k === count ? to : map.at((k * spans) / count);
  });
}

/** Ascending, without those that are in one place. */
function apart(places: readonly number[]): number[] {
  return [...places].sort((a, b) => a - b).filter((p, i, all) => i === 0 || p > all[i - 1]! + IN_BREAK);
}

/** A whole t for every stop, in proportion, at least one apart. */
function wholeSteps(stops: readonly number[], count: number): number[] {
  const [from, to] = [stops[0]!, stops[stops.length - 1]!];
  const ts = stops.map((stop) => Math.round((count * (stop - from)) / (to - from)));
  const last = ts.length - 1;
  for (let i = 1; i < last; i++) ts[i] = Math.max(ts[i]!, ts[i - 1]! + 1);
  for (let i = last - 1; i > 0; i--) ts[i] = Math.min(ts[i]!, ts[i + 1]! - 1);
  return ts;
}
