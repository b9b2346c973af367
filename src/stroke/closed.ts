/**
 * Is a stroke closed, and if so: joins its ends.
 *
 * The thesis takes a stroke as closed when its end is near its start. People miss the start by 5–30 pixels, short of it or
 * past it, so both ends are searched (8 % of the size): where they cross, the stroke is cut at the crossing, and no
 * little loop stays; where they only pass, at the nearest approach. The gap that remains is closed as the ends suggest:
 * running on into each other they are bridged, and bent together sideways; meeting at an angle they are prolonged to the
 * corner they point at. Else a straight line closes it, as the person was shown.
 * Tried: pulling all ends to the middle of the gap, which bent long straight sides of triangles visibly.
 */
import { cross2, dot2, length2, scale2, sub2 } from '../math/tuple.ts';
import type { Vec2 } from '../math/vec.ts';
import { between, distance, type Ink, inkAt, type Path, pathOf, toVec } from './path.ts';
import { angle } from './turn.ts';

/** A stroke is closed when its ends come closer than this share of its size. */
export const CLOSED_TOLERANCE = 0.04;
/** The size is the length, but no more than this many extents: a long scribble is not closed by chance (a circle has 2.2). */
const EXTENTS = 2.5;
/** share of the size at each end that may be an overshoot */
const OVERSHOOT = 0.08;
/** points per searched end: the crossing is found between them, so they need only follow the curve */
const SEARCH = 64;
/** Cutting away 1 mm must bring the ends this much nearer, else they stay as drawn. */
const CUT_COST = 0.25;
/** cosine of the most (60°) by which an overshoot may run askew of the start */
const SAME_WAY = 0.5;
/** ends that meet at more than this (radians, 60°) form a corner */
const CORNER_AT_JOIN = 1.05;
/** a corner further away than this many gaps is not what the ends point at */
const FARTHEST_CORNER = 2;
/** ends further apart sideways than this share of the length are not bent together */
const MOST_BEND = CLOSED_TOLERANCE;

/** Where the ends meet: arc lengths (mm) of the kept stretch, and the distance left between its ends (mm). */
export interface Meeting {
  readonly from: number;
  readonly to: number;
  readonly gap: number;
}

/** The meeting of the ends if they come closer than `tolerance` (0 … 1) of its size, else null. */
export function meetingOf(path: Path, tolerance: number): Meeting | null {
  const reach = (2 * OVERSHOOT + tolerance) * sizeOf(path);
  // most strokes are open, and the search need not be made
  if (path.length === 0 || distance(path.points[0]!, path.points.at(-1)!) > reach) return null;
  const best = crossingOfEnds(path) ?? nearestOfEnds(path);
  return best.gap <= tolerance * sizeOf(path) ? best : null;
}

/** Is the open path meant to be closed? */
export function isClosed(path: Path, tolerance: number): boolean {
  return meetingOf(path, tolerance) !== null;
}

/** The path as a closed one, its ends joined whatever their distance. */
export function joinEnds(path: Path): Path {
  const { from, to } = crossingOfEnds(path) ?? nearestOfEnds(path);
  const cut = pathOf(between(path, from, to), false);
  const joined = isCoarse(cut) ? cut.points : (meetAtCorner(cut) ?? bendTogether(cut));
  const first = joined[0]!;
  const last = joined[joined.length - 1]!;
  // a doubled first point, or one closer than the path's own detail, would make a segment of no direction
  const doubled = distance(first, last) <= 1e-3 * cut.length;
  return pathOf(doubled && joined.length > 3 ? joined.slice(0, -1) : joined, true);
}

/** shortest edge of a path of few points, in gaps: the gap is one more of them, and says nothing */
const COARSE = 0.5;

/** Points that a program gave rather than a pen: a polygon whose last edge is the closing one. */
function isCoarse({ points }: Path): boolean {
  const gap = distance(points[0]!, points.at(-1)!);
  return points.slice(1).every((p, i) => distance(points[i]!, p) >= COARSE * gap);
}

/** Places near an end: arc length (mm), point, direction of drawing. */
type Stations = readonly { readonly s: number; readonly p: Vec2; readonly along: Vec2 }[];

function endsOf(path: Path): { readonly head: Stations; readonly tail: Stations } {
  const reach = OVERSHOOT * sizeOf(path);
  const step = reach / SEARCH;
  const at = (s: number) => toVec(inkAt(path, s));
  const stations = (start: number) =>
    Array.from({ length: SEARCH + 1 }, (_, i) => {
      const s = start + step * i;
      return { s, p: at(s), along: unit(sub2(at(s + 4 * step), at(s - 4 * step))) };
    });
  return { head: stations(0), tail: stations(path.length - reach) };
}

/** The crossing of the two ends that cuts most off the later one: then no other is left. */
function crossingOfEnds(path: Path): Meeting | null {
  const { head, tail } = endsOf(path);
  for (let j = 1; j < tail.length; j++) {
    for (let i = 1; i < head.length; i++) {
      const at = crossing(head[i - 1]!.p, head[i]!.p, tail[j - 1]!.p, tail[j]!.p);
      if (at === null) continue;
      const from = head[i - 1]!.s + (head[i]!.s - head[i - 1]!.s) * at[0];
      const to = tail[j - 1]!.s + (tail[j]!.s - tail[j - 1]!.s) * at[1];
      return { from, to, gap: 0 };
    }
  }
  return null;
}

function nearestOfEnds(path: Path): Meeting {
  const { head, tail } = endsOf(path);
  let best: Meeting = { from: 0, to: path.length, gap: distance(path.points[0]!, path.points.at(-1)!) };
  let least = best.gap;
  for (const h of head) {
    for (const t of tail) {
      // past each other, not towards each other: an overshoot runs on the way the stroke began
      if (dot2(h.along, t.along) < SAME_WAY) continue;
      const gap = length2(sub2(h.p, t.p));
      const cost = gap + CUT_COST * (h.s + path.length - t.s);
      if (cost < least) {
        least = cost;
        best = { from: h.s, to: t.s, gap };
      }
    }
  }
  return best;
}

/** Parameters of the crossing of segments ab and cd, each in [0, 1]; null when they do not cross or are parallel. */
function crossing(a: Vec2, b: Vec2, c: Vec2, d: Vec2): Vec2 | null {
  const p = sub2(b, a);
  const q = sub2(d, c);
  const r = sub2(c, a);
  const area = p[0] * q[1] - p[1] * q[0];
  // written so that segments of no length do not cross; rounding makes parallel ones cross anywhere
  if (!(Math.abs(area) > 1e-9 * length2(p) * length2(q))) return null;
  const s = (r[0] * q[1] - r[1] * q[0]) / area;
  const t = (r[0] * p[1] - r[1] * p[0]) / area;
  return s >= 0 && s <= 1 && t >= 0 && t <= 1 ? [s, t] : null;
}

/** The ends of a cut path: the way from the last point to the first, and how it is drawn at both (unit length). */
function endsMeet(path: Path): { readonly gap: Vec2; readonly ending: Vec2; readonly beginning: Vec2 } {
  const arm = 0.03 * path.length;
  const at = (s: number) => toVec(inkAt(path, s));
  return {
    gap: sub2(at(0), at(path.length)),
    ending: unit(sub2(at(path.length), at(path.length - arm))),
    beginning: unit(sub2(at(arm), at(0))),
  };
}

/** The path with the corner that both ends point at, or null when they point at none. */
function meetAtCorner(path: Path): readonly Ink[] | null {
  const { gap, ending, beginning } = endsMeet(path);
  if (Math.abs(angle(ending, beginning)) < CORNER_AT_JOIN) return null;
  const sine = cross2(ending, beginning);
  // gap = ahead · ending + behind · beginning
  const ahead = cross2(gap, beginning) / sine;
  const behind = cross2(ending, gap) / sine;
  const most = FARTHEST_CORNER * length2(gap);
  // written so that parallel ends (not a number) have no corner
  if (!(ahead >= 0 && behind >= 0 && ahead <= most && behind <= most)) return path.points;
  const last = path.points[path.points.length - 1]!;
  const corner = { ...last, x: last.x + ahead * ending[0], y: last.y + ahead * ending[1] };
  const apart = [last, path.points[0]!].every((p) => distance(p, corner) > 1e-3 * path.length);
  return apart ? [...path.points, corner] : path.points;
}

/** Moves the ends towards each other by what a bridge in the direction of drawing cannot cover. */
function bendTogether(path: Path): readonly Ink[] {
  const shift = sidewaysGap(path);
  const size = length2(shift);
  if (size === 0 || size > MOST_BEND * path.length) return path.points;
  // a bend over eight times the shift turns each end by at most 1.5 / 16 radians
  const fade = Math.min(8 * size, 0.25 * path.length);
  return path.points.map((p, i) => {
    const s = path.lengths[i]!;
    const k = 0.5 * (ease(1 - s / fade) - ease(1 - (path.length - s) / fade));
    return { ...p, x: p.x - shift[0] * k, y: p.y - shift[1] * k };
  });
}

/** From the end to the start, less what lies straight ahead. */
function sidewaysGap(path: Path): Vec2 {
  const { gap, ending, beginning } = endsMeet(path);
  const ahead: Vec2 = [ending[0] + beginning[0], ending[1] + beginning[1]];
  const share = dot2(gap, ahead) / dot2(ahead, ahead);
  return share > 0 ? sub2(gap, scale2(ahead, share)) : gap;
}

function unit(v: Vec2): Vec2 {
  return scale2(v, 1 / (length2(v) || 1));
}

/** mm */
function sizeOf(path: Path): number {
  return Math.min(path.length, EXTENTS * diagonal(path.points));
}

function diagonal(points: readonly Ink[]): number {
  const xs = points.map((p) => p.x);
  const ys = points.map((p) => p.y);
  const extent = (values: readonly number[]) =>
    values.reduce((a, b) => Math.max(a, b)) - values.reduce((a, b) => Math.min(a, b));
  return length2([extent(xs), extent(ys)]);
}

function ease(t: number): number {
  const x = Math.min(Math.max(t, 0), 1);
  return x * x * (3 - 2 * x);
}
