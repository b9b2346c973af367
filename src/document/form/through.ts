/**
 * A smooth curve through circles in a row or a ring: cubic pieces whose slopes are those of the circle through a place and its neighbours' chords
 * (Catmull & Rom 1974, by the lengths of chords: centripetal enough, and a round of twelve is a circle within 0.2 %). A place at which the
 * row turns much more than the others is a corner, and stays one.
 */
import { cos, PI } from '../../math/trig.ts';
import { dot2, length2, sub2 } from '../../math/tuple.ts';
import type { Vec2 } from '../../math/vec.ts';
import type { MedialNode } from '../../skeleton/medial/axis.ts';
import type { Row } from './chains.ts';

/** radians: less is never a corner, nor is what is less than twice the turn of a ring of so many */
const CORNER = PI / 3;
/** of the radius: what a chord may be off the curve */
const OFF = 0.02;
const MOST_PIECES = 12;

/** x, y, radius */
type Place = readonly [number, number, number];

/** Rows of two stay straight. */
export function through({ nodes, closed }: Row): Row {
  const apart = nodes.filter((node, i) => {
    const before = i > 0 ? nodes[i - 1]! : closed && nodes.length > 1 ? nodes.at(-1)! : null;
    return !before || length2(sub2(node.at, before.at)) > 0;
  });
  if (apart.length < 3) return { nodes: apart, closed: false };
  const places = apart.map(({ at, radius }): Place => [at[0], at[1], radius]);
  const links = closed ? places.length : places.length - 1;
  const found = Array.from({ length: links }, (_, i) => piece(places, i, closed)).flat();
  const end = closed ? [] : [apart.at(-1)!];
  return { nodes: [...found, ...end], closed };
}

/** From the place `i` on to just before the next. */
function piece(places: readonly Place[], i: number, closed: boolean): readonly MedialNode[] {
  const [a, b] = [places[i]!, places[(i + 1) % places.length]!];
  const length = chord(a, b);
  const [p, q] = [slope(places, i, 1, closed), slope(places, i + 1, -1, closed)];
  const radius = Math.min(a[2], b[2]);
  // how far the middle of the piece is from its chord, or would be if both ends bent one way
  const bend = (length * (aside(p, a, b) + aside(q, a, b))) / 8;
  const count = Math.min(Math.max(Math.ceil(Math.sqrt(bend / (OFF * radius))), 1), MOST_PIECES);
  return Array.from({ length: count }, (_, k) => {
    const [x, y, r] = hermite(a, b, p, q, length, k / count);
    return { at: [x, y] as Vec2, radius: within(r, a[2], b[2]) };
  });
}

/** per mm of chord, at the place `i` when it is left (1) or reached (−1) */
function slope(places: readonly Place[], i: number, side: 1 | -1, closed: boolean): Place {
  const n = places.length;
  const at = places[i % n]!;
  const before = closed || i > 0 ? places[(i - 1 + n) % n]! : null;
  const after = closed || i < n - 1 ? places[(i + 1) % n]! : null;
  const [back, on] = [before && rate(before, at), after && rate(at, after)];
  if (!back || !on || isCorner(back, on, n)) return (side > 0 ? on : back) ?? back ?? on!;
  const [h, k] = [chord(before!, at), chord(at, after!)];
  const mixed = (axis: 0 | 1 | 2) => (back[axis] * k + on[axis] * h) / (h + k);
  return [mixed(0), mixed(1), mixed(2)];
}

function isCorner(back: Place, on: Place, count: number): boolean {
  const turn = Math.max(CORNER, (4 * PI) / count);
  return turn < PI && back[0] * on[0] + back[1] * on[1] < cos(turn);
}

function rate(a: Place, b: Place): Place {
  const per = 1 / chord(a, b);
  return [(b[0] - a[0]) * per, (b[1] - a[1]) * per, (b[2] - a[2]) * per];
}

const chord = (a: Place, b: Place): number => length2([b[0] - a[0], b[1] - a[1]]);

/** of a slope, across the chord */
function aside(slope: Place, a: Place, b: Place): number {
  const along = rate(a, b);
  return Math.abs(dot2([slope[0], slope[1]], [-along[1], along[0]]));
}

function hermite(a: Place, b: Place, p: Place, q: Place, length: number, t: number): Place {
  const [s, u] = [t * t, t * t * t];
  const of = (axis: 0 | 1 | 2) =>
    (2 * u - 3 * s + 1) * a[axis] +
    (u - 2 * s + t) * length * p[axis] +
    (3 * s - 2 * u) * b[axis] +
    (u - s) * length * q[axis];
  return [of(0), of(1), of(2)];
}

/** No radius beyond those that a person set: it might be none at all. */
const within = (r: number, a: number, b: number): number =>
  Math.min(Math.max(r, Math.min(a, b)), Math.max(a, b));
