/**
 * Redrawing part of a cross section (thesis 6.2, B.2.2): the part x(α) … x(β) between the points nearest to the ends of a
 * stroke is deleted and the stroke put in its place.
 *
 * Departures. The thesis then parametrises the whole anew; here the stroke takes over the v of what it replaces, so that all else
 * stays where it is, on this section and between sections. On closed outlines it does not say which of the two parts
 * goes: the one nearer to the stroke, or, where both are about as near, the one that was seen. The stroke's ends are moved onto the outline, fading over a quarter of it, and
 * turned into its direction where they differ by less than 30° (else there is a corner).
 */
import { add2, distance2, dot2, length2, scale2, sub2 } from '../math/tuple.ts';
import type { Vec2 } from '../math/vec.ts';
import type { Curve } from '../stroke/curve.ts';
import { nearestParameter } from '../stroke/nearestPoint.ts';
import type { Outline } from './outline.ts';
import { redrawnWhole } from './redrawnWhole.ts';

/** v shorter than this is no part to replace: a dot, or a stroke that lies beside an end */
const LEAST_PART = 1e-3;
/** an end this near (in v) to an end of an open outline is meant to be there */
const AT_END = 1e-6;
/** cosine of the angle (30°) up to which the stroke is led into the outline's direction */
const SMOOTH = 0.866;
/** share of the stroke over which its ends are moved, at least and at most; gaps are closed over eight times their width */
const FADE: readonly [number, number] = [0.25, 0.5];
const EASE = 8;

/** The v at which the outline is nearest to `p`. */
export function nearestV(outline: Outline, p: Vec2): number {
  return nearestParameter(outline.point, (v) => outline.derivative(v, 1), p, outline.closed);
}

/** nearness (of one part to that of the other) from which on both are meant as much: a dent to the middle of a circle */
const TIE = 2 / 3;
/** sine of the angle between the plane and the line of sight: one who looks straight onto the plane sees both parts */
const SEES_BOTH = 0.2;

/**
 * `stroke` in half chords, in the outline's frame, drawn either way; `towards`: the person who drew it, what the unit vector there shows
 * in the outline's plane. The outline itself when the stroke says nothing.
 */
export function redrawn(outline: Outline, stroke: Curve, towards: Vec2 = [0, 0]): Outline {
  if (!(stroke.length > 0 && stroke.length < Infinity)) return outline;
  if (stroke.closed) return outline.closed ? redrawnWhole(outline, stroke) : outline;
  const part = partOf(outline, stroke, towards);
  if (!(part.span >= LEAST_PART)) return outline;
  return replaced(outline, part, arcOf(outline, stroke, part));
}

/** What is replaced, and by what of the stroke. */
interface Part {
  /** v of its start, and how far it reaches; on closed outlines beyond 1 */
  readonly from: number;
  readonly span: number;
  /** parameters of the stroke at its two ends */
  readonly t0: number;
  readonly t1: number;
}

function partOf(outline: Outline, stroke: Curve, towards: Vec2): Part {
  const [a, b] = [nearestV(outline, stroke.point(0)), nearestV(outline, stroke.point(1))];
  const forth: Part = { from: a, span: b - a, t0: 0, t1: 1 };
  const back: Part = { from: b, span: a - b, t0: 1, t1: 0 };
  if (!outline.closed) return trimmed(outline, stroke, a <= b ? forth : back);
  const round = [forth, back].map((part) => ({ ...part, span: part.span - Math.floor(part.span) }));
  const [first, second] = round as [Part, Part];
  const [one, other] = [distanceTo(outline, stroke, first), distanceTo(outline, stroke, second)];
  const isTie = Math.min(one, other) > TIE * Math.max(one, other) && length2(towards) > SEES_BOTH;
  if (isTie)
    return towardsOf(outline, first, towards) >= towardsOf(outline, second, towards) ? first : second;
  return one <= other ? first : second;
}

/** How far a part comes towards the person who looks, on the whole. */
const towardsOf = (outline: Outline, part: Part, towards: Vec2): number =>
  pointsOf(outline, part).reduce((sum, p) => sum + dot2(p, towards), 0);

/** What was drawn beyond the ends of an open outline is left out. */
function trimmed(outline: Outline, stroke: Curve, part: Part): Part {
  const nearest = (v: number): number =>
    nearestParameter(stroke.point, stroke.tangent, outline.point(v), false);
  const t0 = part.from <= AT_END ? nearest(0) : part.t0;
  const t1 = part.from + part.span >= 1 - AT_END ? nearest(1) : part.t1;
  // a stroke that passes both ends on its way says nothing about what lies between
  return (t1 - t0) * (part.t1 - part.t0) > 0 ? { ...part, t0, t1 } : part;
}

const PROBES = 48;
const PLACES = Array.from({ length: PROBES + 1 }, (_, i) => i / PROBES);

const pointsOf = (outline: Outline, { from, span }: Part): Vec2[] =>
  PLACES.map((x) => outline.point(wrapped(from + span * x)));

/** How far a part of the outline and the stroke are from each other, on the whole. */
function distanceTo(outline: Outline, stroke: Curve, part: Part): number {
  const drawn = PLACES.map((t) => stroke.point(t));
  const there = pointsOf(outline, part);
  return meanDistance(drawn, there) + meanDistance(there, drawn);
}

function meanDistance(from: readonly Vec2[], to: readonly Vec2[]): number {
  const nearest = from.map((p) => to.reduce((least, q) => Math.min(least, distance2(p, q)), Infinity));
  return nearest.reduce((sum, d) => sum + d, 0) / from.length;
}

const wrapped = (v: number): number => v - Math.floor(v);

/** The new arc by x in [0, 1], with derivatives by x. */
interface Arc {
  readonly corners: readonly number[];
  readonly isCorner: readonly [start: boolean, end: boolean];
  point(x: number): Vec2;
  derivative(x: number, side: -1 | 1): Vec2;
}

/** One end of the stroke, led onto the outline: what is added fades out over `fade` of x. */
interface Joint {
  readonly shift: Vec2;
  /** added to the derivative by x at the end itself */
  readonly lean: Vec2;
  readonly fade: number;
  readonly place: Vec2;
  readonly isCorner: boolean;
}

function arcOf(outline: Outline, stroke: Curve, part: Part): Arc {
  const { from, span, t0, t1 } = part;
  const sense = t1 > t0 ? 1 : -1;
  const length = stroke.length * Math.abs(t1 - t0);
  const tangent = (x: number, side: -1 | 1): Vec2 =>
    scale2(stroke.tangent(t0 + (t1 - t0) * x, sense === 1 ? side : side === 1 ? -1 : 1), sense);
  const until = outline.closed ? wrapped(from + span) : from + span;
  const start = jointOf(outline, from, stroke.point(t0), tangent(0, 1), length, -1);
  const end = jointOf(outline, until, stroke.point(t1), tangent(1, -1), length, 1);
  return {
    corners: stroke.corners
      .map((t) => (t - t0) / (t1 - t0))
      .filter((x) => x > 0 && x < 1)
      .sort((a, b) => a - b),
    isCorner: [start.isCorner, end.isCorner],
    point: (x) => {
      if (x <= 0 || x >= 1) return x <= 0 ? start.place : end.place;
      return add2(stroke.point(t0 + (t1 - t0) * x), add2(added(start, x, 1)[0], added(end, 1 - x, -1)[0]));
    },
    derivative: (x, side) =>
      add2(scale2(tangent(x, side), length), add2(added(start, x, 1)[1], added(end, 1 - x, -1)[1])),
  };
}

/** `side`: of the joint, on which the outline goes on. */
function jointOf(
  outline: Outline,
  v: number,
  drawn: Vec2,
  tangent: Vec2,
  length: number,
  side: -1 | 1,
): Joint {
  const place = outline.point(v);
  const shift = sub2(place, drawn);
  const fade = Math.min(Math.max((EASE * length2(shift)) / length, FADE[0]), FADE[1]);
  const atEnd = !outline.closed && (side === -1 ? v <= AT_END : v >= 1 - AT_END);
  const rate = outline.derivative(v, side);
  const speed = length2(rate);
  if (atEnd || !(speed > 0)) return { shift, lean: [0, 0], fade, place, isCorner: false };
  const along = scale2(rate, 1 / speed);
  const isCorner = dot2(along, tangent) < SMOOTH;
  const lean: Vec2 = isCorner ? [0, 0] : scale2(sub2(along, tangent), length);
  return { shift, lean, fade, place, isCorner };
}

/** What is added to the point `away` from the joint, and its derivative by x; `sense`: x grows away from it (1) or towards it. */
function added({ shift, lean, fade }: Joint, away: number, sense: 1 | -1): readonly [Vec2, Vec2] {
  const y = away / fade;
  if (y >= 1) return [NOTHING, NOTHING];
  const rest = 1 - y;
  const ease = rest * rest * (1 + 2 * y);
  const dEase = (-6 * y * rest) / fade;
  // y (1 − y)² starts with slope 1 and ends with 0
  const bend = sense * fade * y * rest * rest;
  const dBend = rest * (1 - 3 * y);
  return [
    add2(scale2(shift, ease), scale2(lean, bend)),
    add2(scale2(shift, sense * dEase), scale2(lean, dBend)),
  ];
}

const NOTHING: Vec2 = [0, 0];

function replaced(outline: Outline, { from, span }: Part, arc: Arc): Outline {
  const { closed } = outline;
  const inside = (v: number): number => {
    const x = (closed ? wrapped(v - from) : v - from) / span;
    if (Math.abs(x - 1) <= NEAR) return 1;
    return Math.abs(x) <= NEAR || (closed && x >= 1 / span - NEAR) ? 0 : x;
  };
  const isNew = (x: number, side: -1 | 1): boolean => (side === 1 ? x >= 0 && x < 1 : x > 0 && x <= 1);
  const place = (x: number): number => (closed ? wrapped(from + span * x) : from + span * x);
  const kept = outline.corners.filter((v) => inside(v) < 0 || inside(v) > 1);
  const ends = [0, 1].filter((x) => arc.isCorner[x as 0 | 1]);
  return {
    closed,
    corners: [...kept, ...[...arc.corners, ...ends].map(place)].sort((a, b) => a - b),
    point: (v) => {
      const x = inside(v);
      return x >= 0 && x <= 1 ? arc.point(x) : outline.point(v);
    },
    derivative: (v, side) => {
      const x = inside(v);
      return isNew(x, side) ? scale2(arc.derivative(x, side), 1 / span) : outline.derivative(v, side);
    },
  };
}

/** part of the new arc: a v this near to a joint is the joint */
const NEAR = 1e-9;
