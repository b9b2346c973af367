/**
 * A cross section in the frame of its chord (thesis 5.4.2, t(v) = (x(v), z(v))): x runs from −1 at q_l to 1 at q_r, y out of the
 * drawing plane towards the person, both in half chords. Convex (drawn below a chord that runs left to right) is y > 0.
 */
import { cos, PI, sin } from '../math/trig.ts';
import { cross2, distance2, dot2, length2, scale2, sub2 } from '../math/tuple.ts';
import type { Vec2 } from '../math/vec.ts';
import type { Curve } from '../stroke/curve.ts';

export interface Outline {
  /** v = 1 is v = 0: a front and a back. Open ones run from q_l (v = 0) to q_r (v = 1); of closed ones q_r is at v = ½ */
  readonly closed: boolean;
  /** ascending v at which the tangent jumps: creases along the surface. Open: inside (0, 1); closed: in [0, 1) */
  readonly corners: readonly number[];
  /** v in [0, 1] */
  point(v: number): Vec2;
  /** d point / dv; at a corner `side` says whether the one arriving (−1) or the one leaving (1) */
  derivative(v: number, side: -1 | 1): Vec2;
}

/** Flat: the chord itself. */
export const straight: Outline = {
  closed: false,
  corners: [],
  point: (v) => [2 * v - 1, 0],
  derivative: () => [2, 0],
};

/** The convex half circle of rotational surfaces, its ends and its middle exact. */
export const roundHalf: Outline = {
  closed: false,
  corners: [],
  point: (v) => {
    if (v === 0.5) return [0, 1];
    return v <= 0 ? [-1, 0] : v >= 1 ? [1, 0] : [-cos(PI * v), sin(PI * v)];
  },
  derivative: (v) => [PI * sin(PI * v), PI * cos(PI * v)],
};

/** How a stroke became a section. */
export interface Drawn {
  /** its end is at q_l */
  readonly reversed: boolean;
  /** on the drawing plane, to be turned by 90° about its chord: what lies to the right of q_l → q_r comes out. Else y is out already */
  readonly across: boolean;
}

/** ends nearer than this part of the stroke's length have no chord to speak of, not even a direction */
const LEAST_CHORD = 0.01;
/** a stroke reaches at most so many chords: one whose ends nearly meet would tower over its form without end */
const MOST_REACH = 4;

/**
 * A stroke by its arc length, moved, turned and scaled so that its ends are (−1, 0) and (1, 0); the chord where they meet. Where the chord
 * is shorter than a quarter of the stroke's reach that quarter is the scale, and the ends are drawn apart evenly along the stroke.
 */
export function outlineOf(curve: Curve, { reversed, across }: Drawn): Outline {
  const onCurve = (v: number): number => (reversed ? 1 - v : v);
  const start = curve.point(onCurve(0));
  const way = sub2(curve.point(onCurve(1)), start);
  const chord = length2(way);
  if (!(chord > LEAST_CHORD * curve.length)) return straight;
  const scale = Math.max(chord, reachOf(curve, start, chord) / MOST_REACH);
  const k = 2 / (scale * chord);
  const apart = 2 - (2 * chord) / scale;
  const up = across ? -k : k;
  const turned = (p: Vec2): Vec2 => [k * dot2(p, way), up * cross2(way, p)];
  const pace = reversed ? -curve.length : curve.length;
  return {
    closed: false,
    corners: curve.corners.map(onCurve).sort((a, b) => a - b),
    point: (v) => {
      if (v <= 0 || v >= 1) return v <= 0 ? [-1, 0] : [1, 0];
      const [x, y] = turned(sub2(curve.point(onCurve(v)), start));
      return [x + apart * v - 1, y];
    },
    derivative: (v, side) => {
      const tangent = curve.tangent(onCurve(v), reversed ? (side === 1 ? -1 : 1) : side);
      const [dx, dy] = scale2(turned(tangent), pace);
      return [dx + apart, dy];
    },
  };
}

/** From its start to the farthest of its points; only where that may be far in chords. */
function reachOf(curve: Curve, start: Vec2, chord: number): number {
  if (MOST_REACH * chord >= curve.length) return 0;
  const points = Array.from({ length: LOOKS }, (_, i) => curve.point(i / LOOKS));
  return Math.max(...points.map((p) => distance2(p, start)));
}

/** places at which a stroke is looked at for its reach */
const LOOKS = 64;

/** The end of a stroke that belongs at q_l is the nearer one. */
export function isReversed(curve: Curve, left: Vec2, right: Vec2): boolean {
  const along = distance2(curve.point(0), left) + distance2(curve.point(1), right);
  return distance2(curve.point(1), left) + distance2(curve.point(0), right) < along;
}

/** The stretch of v from … to as an open outline of its own. */
export function restricted(outline: Outline, from: number, to: number): Outline {
  const span = to - from;
  return {
    closed: false,
    corners: outline.corners.map((v) => (v - from) / span).filter((v) => v > 0 && v < 1),
    point: (v) => outline.point(from + v * span),
    derivative: (v, side) => scale2(outline.derivative(from + v * span, side), span),
  };
}

/** half chords: a back nearer to its front lies on it */
const NO_GAP = 1e-4;

/** A closed outline whose back lies on its front, point by point: an eight has no area either, yet encloses something. */
export const isBackless = ({ closed, point }: Outline): boolean =>
  closed &&
  Array.from({ length: LOOKS }, (_, i) => i / LOOKS / 2).every(
    (v) => distance2(point(v), point(1 - v)) < NO_GAP,
  );
