/**
 * Control points of a clamped cubic B-spline that follows a stroke: least squares over even places, ends pinned, as few as are near enough.
 * Radii are taken at the Greville abscissae (Schoenberg's approximation), so that none is beyond those of the stroke.
 */
import { leastSquares } from '../../math/lstsq.ts';
import { distance2, sub2 } from '../../math/tuple.ts';
import type { Vec2 } from '../../math/vec.ts';
import { clampedKnots } from '../../skeleton/nurbs.ts';

const DEGREE = 3;
const FEWEST = 4;
const MOST = 32;
/** of the size, how far the curve may be off the stroke */
const OFF = 0.008;
/** places looked at for each control point */
const LOOKED_AT = 8;

/** Knots from 0 to 1, whatever they run from; null where they cannot be those of so many control points. */
export function knotsFor(knots: readonly number[] | null, count: number): readonly number[] | null {
  if (!knots || knots.length !== count + DEGREE + 1 || count < FEWEST) return null;
  const [first, last] = [knots[0]!, knots.at(-1)!];
  const isClamped = [0, count].every((i) => knots.slice(i, i + 4).every((knot) => knot === knots[i]));
  const rises = knots.every((knot, i) => Number.isFinite(knot) && (i === 0 || knot >= knots[i - 1]!));
  const isWhole = knots.every((knot, i) => i === 0 || i >= count || knot !== knots[i + DEGREE]);
  if (!isClamped || !rises || !isWhole || !(last > first)) return null;
  return knots.map((knot) => (knot - first) / (last - first));
}

export const evenKnots = (count: number): readonly number[] =>
  clampedKnots(count).map((knot) => knot / (count - DEGREE));

/** `point`: of the stroke at u, 0–1. With knots as many control points as those are for, if the stroke determines them. */
export function controlsOf(point: (u: number) => Vec2, given: readonly number[] | null): readonly Vec2[] {
  if (given) {
    const fitted = fit(point, knotsFor(given, given.length - DEGREE - 1));
    if (fitted) return fitted.controls;
  }
  const places = Array.from({ length: 64 }, (_, i) => point(i / 63));
  const span = (axis: 0 | 1) =>
    Math.max(...places.map((p) => p[axis])) - Math.min(...places.map((p) => p[axis]));
  const enough = OFF * Math.max(span(0), span(1));
  let best: Fitted | null = null;
  for (let count = FEWEST; count <= MOST; count += count < 12 ? 1 : 2) {
    const fitted = fit(point, evenKnots(count));
    if (fitted && (!best || fitted.off < 0.9 * best.off)) best = fitted;
    if (best && best.off <= enough) break;
  }
  return best?.controls ?? [0, 1 / 3, 2 / 3, 1].map(point);
}

interface Fitted {
  readonly controls: readonly Vec2[];
  /** mm, the most */
  readonly off: number;
}

function fit(point: (u: number) => Vec2, knots: readonly number[] | null): Fitted | null {
  if (!knots) return null;
  const count = knots.length - DEGREE - 1;
  const steps = LOOKED_AT * count;
  const places = Array.from({ length: steps + 1 }, (_, i) => point(i / steps));
  const rows = places.map((_, i) => basis(knots, i / steps));
  const [start, end] = [places[0]!, places[steps]!];
  const inner = rows.map((row) => row.slice(1, -1));
  const unpinned = (axis: 0 | 1) =>
    places.map((p, i) => p[axis] - rows[i]![0]! * start[axis] - rows[i]![count - 1]! * end[axis]);
  try {
    const [x, y] = [leastSquares(inner, unpinned(0)), leastSquares(inner, unpinned(1))];
    const controls: Vec2[] = [start, ...x.map((value, i): Vec2 => [value, y[i]!]), end];
    const at = (row: readonly number[]): Vec2 => [
      row.reduce((sum, b, k) => sum + b * controls[k]![0], 0),
      row.reduce((sum, b, k) => sum + b * controls[k]![1], 0),
    ];
    const off = places.reduce((most, p, i) => Math.max(most, aside(places, i, sub2(at(rows[i]!), p))), 0);
    return { controls, off };
  } catch (error) {
    if (error instanceof RangeError) return null;
    throw error;
  }
}

/** mm of a difference at a place across the stroke: along it is no matter, but for ends. */
function aside(places: readonly Vec2[], i: number, off: Vec2): number {
  const [a, b] = [places[Math.max(i - 1, 0)]!, places[Math.min(i + 1, places.length - 1)]!];
  const length = distance2(a, b);
  if (!(length > 0)) return distance2(off, [0, 0]);
  const across = Math.abs((b[0] - a[0]) * off[1] - (b[1] - a[1]) * off[0]) / length;
  return Math.max(across, (0.5 * Math.abs((b[0] - a[0]) * off[0] + (b[1] - a[1]) * off[1])) / length);
}

/** All basis functions at t, 0–1 (Cox & de Boor). */
function basis(knots: readonly number[], t: number): readonly number[] {
  const count = knots.length - DEGREE - 1;
  let span = DEGREE;
  while (span < count - 1 && t >= knots[span + 1]!) span++;
  const all = new Array<number>(count).fill(0);
  all[span] = 1;
  for (let d = 1; d <= DEGREE; d++) {
    for (let k = span - d; k <= span; k++) {
      const left = knots[k + d]! > knots[k]! ? ((t - knots[k]!) / (knots[k + d]! - knots[k]!)) * all[k]! : 0;
      const width = knots[k + d + 1]! - knots[k + 1]!;
      const right = width > 0 && k < span ? ((knots[k + d + 1]! - t) / width) * all[k + 1]! : 0;
      all[k] = left + right;
    }
  }
  return all;
}

/** Where along the stroke each control point counts most. */
export const grevilles = (knots: readonly number[]): readonly number[] =>
  Array.from(
    { length: knots.length - DEGREE - 1 },
    (_, i) => (knots[i + 1]! + knots[i + 2]! + knots[i + 3]!) / 3,
  );
