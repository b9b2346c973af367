/**
 * Which point of one stroke belongs to which of the other, roughly: directions and starts. Strokes may be drawn
 * in any order and direction.
 *
 * The mean chord decides. Its square, the obvious choice, is blind: ∫ |l − r|² is the same for both directions
 * of two legs of a right angle, and for every start on two equal circles side by side. The mean of the length
 * itself prefers ends that meet, and makes two equal circles a torus of revolution. Where it ties (a symmetric
 * X) the strokes keep the directions in which they were drawn.
 */
import { add2, cross2, distance2, mix2, scale2 } from '../math/tuple.ts';
import type { Vec2 } from '../math/vec.ts';
import type { Curve } from '../stroke/curve.ts';
import { crossings, type Match } from './crossings.ts';
import { type Opening, openSide, type Side } from './side.ts';

export interface Sides {
  readonly left: Side;
  readonly right: Side;
  /** the surface runs round: u = 1 is u = 0 */
  readonly closed: boolean;
  /** both sides of a closed pair begin in a crossing */
  readonly pinched: boolean;
}

/** samples a stroke for sums over it */
const SAMPLES = 128;
/** chords this much alike (relative) are a tie */
const TIE = 1e-9;
/** corners of closed strokes farther apart than this part of the length do not fix the start */
const CORNERS_APART = 0.1;
/** outlines that differ by less than this part of their size are one */
const SHRINK = 0.02;
const HEAD: Opening = { start: 0, reversed: false };

/** Orders, turns and opens two strokes. */
export function align(first: Curve, second: Curve): Sides {
  return first.closed && second.closed ? alignClosed(first, second) : alignOpen(first, second);
}

/** Left is on the left when walking along u. A closed stroke is opened where it is nearest to the open one's start. */
function alignOpen(first: Curve, second: Curve): Sides {
  const head = openSide(first, {
    start: first.closed ? nearest(first, second.point(0)) : 0,
    reversed: false,
  });
  const start = second.closed ? nearest(second, first.point(0)) : 0;
  const along = openSide(second, { start, reversed: false });
  const against = openSide(second, { start, reversed: true });
  const other = meanChord(head, against) < meanChord(head, along) * (1 - TIE) ? against : along;
  const swap = area([...walk(head), ...walk(other).reverse()]) > 0;
  const [left, right] = swap ? [other, head] : [head, other];
  return { left, right, closed: false, pinched: false };
}

/**
 * Nested strokes run in the same sense (a ring), those side by side mirrored (a torus). Where they cross, both
 * begin in a crossing; otherwise in a pair of corners, if there is one.
 */
function alignClosed(left: Curve, right: Curve): Sides {
  const outlines = [left, right].map((curve) => walk(openSide(curve, HEAD))) as [Vec2[], Vec2[]];
  const nested = mostlyInside(outlines[0], outlines[1]) || mostlyInside(outlines[1], outlines[0]);
  const sameSense = area(outlines[0]) > 0 === area(outlines[1]) > 0;
  const reversed = nested !== sameSense;
  const shift = bestShift(outlines[0], right, reversed);
  const l = openSide(left, HEAD);
  const r = openSide(right, { start: shift, reversed });
  const crossing = nearestMatch(crossings(l, r), 1);
  const corners = l.corners.flatMap((a) => r.corners.map((b) => ({ a, b })));
  const start = crossing ?? nearestMatch(corners, CORNERS_APART) ?? { a: 0, b: 0 };
  return {
    left: openSide(left, { start: start.a, reversed: false }),
    right: openSide(right, { start: shift + (reversed ? -start.b : start.b), reversed }),
    closed: true,
    pinched: crossing !== null,
  };
}

/** The match whose parameters differ least, going round; null when all differ by more than `most`. */
function nearestMatch(matches: readonly Match[], most: number): Match | null {
  const distance = ({ a, b }: Match): number => Math.abs(a - b - Math.round(a - b));
  const sorted = matches.filter((match) => distance(match) <= most).sort((x, y) => distance(x) - distance(y));
  return sorted[0] ?? null;
}

/** Where to open `curve` so that the mean chord to the outline is least: all shifts, then parabolas between them. */
function bestShift(outline: readonly Vec2[], curve: Curve, reversed: boolean): number {
  const sign = reversed ? -1 : 1;
  const points = walk(openSide(curve, HEAD));
  const sums = points.map((_, shift) =>
    outline.reduce((sum, p, i) => {
      const j = (reversed ? shift - i - 1 : shift + i) % SAMPLES;
      return sum + distance2(p, points[(j + SAMPLES) % SAMPLES]!);
    }, 0),
  );
  const at = (shift: number): number =>
    outline.reduce((sum, p, i) => sum + distance2(p, curve.point(shift + (sign * (i + 0.5)) / SAMPLES)), 0);
  let best = sums.indexOf(Math.min(...sums)) / SAMPLES;
  for (let step = 1 / SAMPLES; step > 1e-5; step /= 16)
    best += step * lowest(at(best - step), at(best), at(best + step));
  return best;
}

/** Where the parabola through values at −1, 0 and 1 is least, kept inside; 0 when it has no least. */
function lowest(before: number, here: number, after: number): number {
  const bend = before - 2 * here + after;
  return bend > 0 ? Math.min(Math.max((before - after) / (2 * bend), -1), 1) : 0;
}

function meanChord(l: Side, r: Side): number {
  const other = walk(r);
  return walk(l).reduce((sum, p, i) => sum + distance2(p, other[i]!), 0) / SAMPLES;
}

/** Points in the middle of even stretches (so that reversing a side reverses them). */
function walk(side: Side): Vec2[] {
  return Array.from({ length: SAMPLES }, (_, i) => side.point((i + 0.5) / SAMPLES));
}

/** Signed area of the polygon, positive when counter-clockwise. */
function area(polygon: readonly Vec2[]): number {
  const last = polygon[polygon.length - 1]!;
  return polygon.reduce((sum, p, i) => sum + cross2(polygon[i - 1] ?? last, p) / 2, 0);
}

/** Most of the outline, shrunk a little (so that a stroke drawn twice is nested), lies inside the polygon. */
function mostlyInside(outline: readonly Vec2[], polygon: readonly Vec2[]): boolean {
  const middle = scale2(outline.reduce(add2), 1 / outline.length);
  const shrunk = outline.map((p) => mix2(p, middle, SHRINK));
  return 2 * shrunk.filter((p) => inside(p, polygon)).length > outline.length;
}

/** Even–odd rule. */
function inside([x, y]: Vec2, polygon: readonly Vec2[]): boolean {
  let odd = false;
  polygon.forEach(([qx, qy], i) => {
    const [px, py] = polygon[(i + polygon.length - 1) % polygon.length]!;
    if (py > y !== qy > y && x < px + ((y - py) / (qy - py)) * (qx - px)) odd = !odd;
  });
  return odd;
}

/** The curve's parameter nearest to `p`, to one sample. */
function nearest(curve: Curve, p: Vec2): number {
  const distances = Array.from({ length: SAMPLES }, (_, i) => distance2(p, curve.point(i / SAMPLES)));
  return distances.indexOf(Math.min(...distances)) / SAMPLES;
}
