/**
 * Two strokes as the sides q_l(u), q_r(u) of one surface (thesis 5.3.1), u in [0, 1] on both.
 *
 * The thesis takes the strokes as they are drawn, point u of one against point u of the other. Here they are first
 * turned and ordered (align.ts), then matched at ends, crossings and corners, with u running evenly (mean arc
 * length of the two) between matches (match.ts); ends that nearly meet are made to meet.
 *
 * Interface note: an open and a closed stroke do not make a pair in the application. Given here, the closed one is
 * opened where it is nearest to the open one's start.
 */
import { add2, distance2, mix2, scale2, sub2 } from '../math/tuple.ts';
import type { Vec2 } from '../math/vec.ts';
import type { Curve } from '../stroke/curve.ts';
import { align } from './align.ts';
import { type Anchor, matchSides } from './match.ts';
import { pieceAt } from './rows.ts';
import { ON_CORNER, type Side } from './side.ts';

/** Both sides at one u, mm on the plane, with their derivatives by u. */
export interface Section {
  readonly left: Vec2;
  readonly right: Vec2;
  readonly dLeft: Vec2;
  readonly dRight: Vec2;
}

/** A u at which rows must lie: ends, crossings, corners. */
export interface Stop {
  readonly u: number;
  /** both sides are in one point: a crossing, or ends that meet */
  readonly pole: boolean;
}

export interface Pair {
  /** u = 1 is u = 0 */
  readonly closed: boolean;
  /** mean of the sides' lengths, mm */
  readonly length: number;
  /** ascending from u = 0 to u = 1; the sides are smooth between stops */
  readonly stops: readonly Stop[];
  /** `side`: at a stop, the derivatives before (−1) or after (1) it */
  at(u: number, side: -1 | 1): Section;
}

/** ends nearer than this part of the mean length are meant to meet */
const MEET = 0.03;
/** … unless the form is hardly wider than that anywhere: a rod keeps its caps */
const MEET_OF_WIDTH = 0.3;
/** a gap is closed over this many times its width: the sides bend by 1/8 (7°) at most */
const EASE = 8;

/** Pairs two strokes in any order and direction. */
export function pairCurves(first: Curve, second: Curve): Pair {
  const { left, right, closed, pinched } = align(first, second);
  const map = stretch(left, right, matchSides(left, right, pinched));
  const raw = (u: number, side: -1 | 1): Section => sectionAt(left, right, map, u, side);
  const ends = closed
    ? []
    : [gapAt(raw, map.length, 0), gapAt(raw, map.length, 1)].filter((gap) => gap !== null);
  return {
    closed,
    length: map.length,
    stops: stopsOf(
      left,
      right,
      map,
      ends.map(({ end }) => end),
    ),
    at: (u, side) => ends.reduce((section, gap) => closeGap(section, gap, u), raw(u, side)),
  };
}

/** The piecewise linear maps from u to each side's own parameter. */
interface Stretch {
  readonly length: number;
  readonly anchors: readonly Anchor[];
  /** u of each anchor */
  readonly us: readonly number[];
}

function stretch(l: Side, r: Side, anchors: readonly Anchor[]): Stretch {
  let walked = 0;
  const lengths = anchors.map(({ a, b }, i) => {
    const before = anchors[i - 1] ?? { a, b };
    walked += ((a - before.a) * l.length + (b - before.b) * r.length) / 2;
    return walked;
  });
  const even = anchors.map((_, i) => i / (anchors.length - 1));
  const us = walked > 0 ? lengths.map((length) => length / walked) : even;
  us[us.length - 1] = 1;
  return { length: walked, anchors, us };
}

function sectionAt(l: Side, r: Side, { anchors, us }: Stretch, u: number, side: -1 | 1): Section {
  const k = pieceAt(us, u, side);
  const span = us[k + 1]! - us[k]!;
  const from = anchors[k]!;
  const to = anchors[k + 1]!;
  const t = (u - us[k]!) / span;
  const a = from.a * (1 - t) + to.a * t;
  const b = from.b * (1 - t) + to.b * t;
  return {
    left: l.point(a),
    right: r.point(b),
    dLeft: scale2(l.derivative(a, side), (to.a - from.a) / span),
    dRight: scale2(r.derivative(b, side), (to.b - from.b) / span),
  };
}

/** Anchors, and the corners that found no match. */
function stopsOf(l: Side, r: Side, map: Stretch, met: readonly number[]): Stop[] {
  const { anchors, us } = map;
  const stops = anchors.map(({ crossing }, i) => ({ u: us[i]!, pole: crossing || met.includes(us[i]!) }));
  const lonely = [
    ...l.corners.map((corner) =>
      inverse(
        anchors.map(({ a }) => a),
        us,
        corner,
      ),
    ),
    ...r.corners.map((corner) =>
      inverse(
        anchors.map(({ b }) => b),
        us,
        corner,
      ),
    ),
  ];
  for (const u of lonely) {
    if (u !== null && stops.every((stop) => Math.abs(stop.u - u) > ON_CORNER)) stops.push({ u, pole: false });
  }
  return stops.sort((a, b) => a.u - b.u);
}

/** u at which a side's own parameter is x; null where it was trimmed away. */
function inverse(xs: readonly number[], us: readonly number[], x: number): number | null {
  const k = xs.findIndex((x0, i) => i + 1 < xs.length && x >= x0 && x <= xs[i + 1]!);
  if (k < 0) return null;
  const t = (x - xs[k]!) / (xs[k + 1]! - xs[k]!);
  return us[k]! * (1 - t) + us[k + 1]! * t;
}

/** What is added to the sides at an end to make them meet. */
interface Gap {
  readonly end: 0 | 1;
  /** part of u over which the gap is closed */
  readonly over: number;
  readonly left: Vec2;
  readonly right: Vec2;
}

function gapAt(raw: Pair['at'], length: number, end: 0 | 1): Gap | null {
  const width = (u: number): number => {
    const { left, right } = raw(u, 1);
    return distance2(left, right);
  };
  const gap = width(end);
  const widest = Math.max(...Array.from({ length: 17 }, (_, i) => width(i / 16)));
  if (gap > MEET * length || gap > MEET_OF_WIDTH * widest) return null;
  const { left, right } = raw(end, 1);
  const middle = mix2(left, right, 0.5);
  const over = Math.min(Math.max((EASE * gap) / length, 1e-6), 0.5);
  return { end, over, left: sub2(middle, left), right: sub2(middle, right) };
}

/** The sides moved by (1 − t)² of the gap, t from 0 at the end to 1 where nothing moves any more. */
function closeGap(section: Section, { end, over, left, right }: Gap, u: number): Section {
  const t = Math.abs(u - end) / over;
  if (t >= 1) return section;
  const weight = (1 - t) * (1 - t);
  const slope = ((end === 0 ? -2 : 2) * (1 - t)) / over;
  return {
    left: add2(section.left, scale2(left, weight)),
    right: add2(section.right, scale2(right, weight)),
    dLeft: add2(section.dLeft, scale2(left, slope)),
    dRight: add2(section.dRight, scale2(right, slope)),
  };
}
