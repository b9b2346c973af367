/**
 * Bézier spans as one curve by arc length.
 *
 * Theory: s(t) = ∫|c′| by eight-point Gauss quadrature on each span, halved until two halves agree with the whole; u is
 * inverted by Newton's method inside a bracket, so it is monotone. Equal steps of u give equal lengths to 1e-9.
 */
import { gauss } from '../math/quadrature.ts';
import { length2, scale2, sub2 } from '../math/tuple.ts';
import type { Vec2 } from '../math/vec.ts';
import { bezierPoint, hodograph } from './bspline.ts';
import type { Curve } from './curve.ts';

/** The control points of one span, of degree 1 to 3. */
export type Bezier = readonly Vec2[];

/** A stretch of one span over which the quadrature is exact. */
interface Cell {
  readonly bezier: Bezier;
  /** the control points of c′ */
  readonly derivative: Bezier;
  /** |c′| at t */
  readonly speed: (t: number) => number;
  readonly t0: number;
  readonly t1: number;
  /** arc length before and after the cell, mm */
  readonly s0: number;
  readonly s1: number;
}

/** relative difference at which halving stops; the halves are then about 2⁻¹⁶ of it away */
const QUADRATURE_TOLERANCE = 1e-9;
/** a cusp (speed zero) is halved this often and then left: 2⁻¹⁴ of a span */
const MOST_HALVINGS = 14;
/** Newton needs three or four; at a cusp the bracket is halved instead, to 1e-12 of it */
const MOST_NEWTON_STEPS = 40;
/** u this close to a corner counts as on it */
const ON_CORNER = 1e-9;
/**
 * Pieces of Bézier spans as one curve. Pieces meet at corners; `smoothStart`: a closed curve whose first point is none.
 * `pressure` of u in [0, 1].
 */
export function bezierCurve(
  pieces: readonly (readonly Bezier[])[],
  closed: boolean,
  smoothStart: boolean,
  pressure: (u: number) => number,
): Curve {
  const { cells, starts, length } = measure(pieces);
  const corners = starts.filter((_, i) => i > 0 || (closed && !smoothStart)).map((s) => s / (length || 1));
  // who asks for the tangent has often asked for the point
  let last = { u: NaN, side: 0, found: { cell: cells[0]!, t: 0 } };
  const find = (u: number, side: -1 | 1) => {
    if (last.u !== u || last.side !== side)
      last = { u, side, found: locate(cells, place(u, closed) * length, length, closed, side) };
    return last.found;
  };
  return {
    closed,
    length,
    corners,
    point: (u) => {
      const { cell, t } = find(u, 1);
      return bezierPoint(cell.bezier, t);
    },
    tangent: (u, side = 1) => {
      const { cell, t } = find(u, side);
      return direction(cell, t);
    },
    pressure: (u) => pressure(place(u, closed)),
  };
}

function measure(pieces: readonly (readonly Bezier[])[]) {
  const cells: Cell[] = [];
  const starts: number[] = [];
  let s = 0;
  for (const piece of pieces) {
    starts.push(s);
    for (const bezier of piece) {
      const speed = speedOf(bezier);
      const derivative = hodograph(bezier);
      for (const [t0, t1, span] of stretches(bezier, speed)) {
        // a span of no length has no place on the curve, except when the curve has nothing else
        if (span > 0) cells.push({ bezier, derivative, speed, t0, t1, s0: s, s1: s + span });
        s += span;
      }
    }
  }
  if (cells.length === 0) {
    const bezier = pieces[0]![0]!;
    cells.push({ bezier, derivative: hodograph(bezier), speed: () => 0, t0: 0, t1: 1, s0: 0, s1: 0 });
  }
  return { cells, starts, length: s };
}

/** |c′| as a function of t; its coefficients are worked out once, because quadrature asks for it thousands of times. */
function speedOf(bezier: Bezier): (t: number) => number {
  const n = bezier.length - 1;
  const steps = bezier.slice(1).map((p, i): Vec2 => scale2(sub2(p, bezier[i]!), n));
  const [a, b = a, c = b] = steps as [Vec2, Vec2?, Vec2?];
  // degree 2 has the steps a, b, degree 3 the steps a, b, c, as the Bernstein coefficients of c′
  const once = n === 3 ? 2 : 1;
  const [x0, y0] = a;
  const [x1, y1] = scale2(sub2(b, a), once);
  const [x2, y2] = n === 3 ? [a[0] - 2 * b[0] + c[0], a[1] - 2 * b[1] + c[1]] : [0, 0];
  return (t) => {
    const x = x0 + t * (x1 + t * x2);
    const y = y0 + t * (y1 + t * y2);
    return Math.sqrt(x * x + y * y);
  };
}

/** [t0, t1, length] of stretches on which one quadrature suffices. */
function stretches(bezier: Bezier, speed: (t: number) => number): (readonly [number, number, number])[] {
  if (bezier.length === 2) return [[0, 1, speed(0)]];
  const total = gauss(speed, 0, 1);
  const found: (readonly [number, number, number])[] = [];
  const halve = (t0: number, t1: number, whole: number, depth: number): void => {
    const middle = 0.5 * (t0 + t1);
    const left = gauss(speed, t0, middle);
    const right = gauss(speed, middle, t1);
    if (depth === MOST_HALVINGS || Math.abs(left + right - whole) <= QUADRATURE_TOLERANCE * total) {
      found.push([t0, middle, left], [middle, t1, right]);
      return;
    }
    halve(t0, middle, left, depth + 1);
    halve(middle, t1, right, depth + 1);
  };
  halve(0, 1, total, 0);
  return found;
}

/** The cell and its parameter at arc length s; `side` chooses between the two cells that meet there. */
function locate(cells: readonly Cell[], s: number, length: number, closed: boolean, side: -1 | 1) {
  const slack = ON_CORNER * length;
  let low = 0;
  let high = cells.length - 1;
  while (low < high) {
    const middle = (low + high) >> 1;
    if (cells[middle]!.s1 > s) high = middle;
    else low = middle + 1;
  }
  const cell = cells[low]!;
  if (side === 1 && s >= cell.s1 - slack) {
    const next = low + 1 < cells.length ? low + 1 : closed ? 0 : low;
    return { cell: cells[next]!, t: next === low ? cell.t1 : cells[next]!.t0 };
  }
  if (side === -1 && s <= cell.s0 + slack) {
    const before = low > 0 ? low - 1 : closed ? cells.length - 1 : low;
    return { cell: cells[before]!, t: before === low ? cell.t0 : cells[before]!.t1 };
  }
  return { cell, t: invert(cell, s) };
}

/** t in the cell at which the arc length is s: Newton, kept inside a shrinking bracket. */
function invert(cell: Cell, s: number): number {
  const { speed, t0, t1, s0, s1 } = cell;
  if (s <= s0) return t0;
  let low = t0;
  let high = t1;
  let t = t0 + ((t1 - t0) * (s - s0)) / (s1 - s0);
  for (let step = 0; step < MOST_NEWTON_STEPS; step++) {
    const miss = s0 + gauss(speed, t0, t) - s;
    if (Math.abs(miss) <= 1e-13 * s1) break;
    if (miss > 0) high = t;
    else low = t;
    const guess = t - miss / speed(t);
    t = guess > low && guess < high ? guess : 0.5 * (low + high);
  }
  return t;
}

/** Unit tangent; where the speed vanishes (a cusp, doubled control points), that of a little further inside. */
function direction({ bezier, derivative }: Cell, t: number): Vec2 {
  const size = spread(bezier);
  for (const nudge of NUDGES) {
    const d = bezierPoint(derivative, t < 0.5 ? t + nudge : t - nudge);
    if (length2(d) > 1e-9 * size) return unit(d)!;
  }
  return unit(sub2(bezier[bezier.length - 1]!, bezier[0]!)) ?? [1, 0];
}

const NUDGES = [0, 1e-6, 1e-4, 1e-2] as const;

/** How far control points are from the first, mm. */
function spread(bezier: Bezier): number {
  let most = 0;
  for (const p of bezier) most = Math.max(most, length2(sub2(p, bezier[0]!)));
  return most;
}

/** u inside [0, 1]: clamped on open curves, wrapped on closed ones. */
export function place(u: number, closed: boolean): number {
  return closed ? u - Math.floor(u) : Math.min(Math.max(u, 0), 1);
}

/** v at length 1; null when it has none. */
export function unit(v: Vec2): Vec2 | null {
  const n = length2(v);
  return n > 0 ? [v[0] / n, v[1] / n] : null;
}
