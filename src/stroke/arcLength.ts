/**
 * Curves by arc length: what surfaces see of a stroke.
 *
 * Departure: the thesis steps evenly in the spline's own parameter (chapter 4), which is even only when the control points
 * are; two strokes then pair points that do not belong together. How: `bezierCurve.ts`.
 */

import { atan2, PI } from '../math/trig.ts';
import { cross2, dot2, length2, sub2 } from '../math/tuple.ts';
import type { Vec2 } from '../math/vec.ts';
import { type Bezier, bezierCurve } from './bezierCurve.ts';
import { splineBeziers } from './bspline.ts';
import type { Curve } from './curve.ts';
import type { FilteredStroke } from './filter.ts';

export { functionCurve } from './functionCurve.ts';

/** a polyline turns this far at a corner of polylineCurve, radians */
const POLYLINE_CORNER = PI / 6;

/** The curve of a filtered stroke. */
export function curveOf(stroke: FilteredStroke): Curve {
  const pieces = stroke.pieces.map((points) => splineBeziers(points, stroke.degree, stroke.periodic));
  return bezierCurve(pieces, stroke.closed, stroke.periodic, evenProfile(stroke.pressure, stroke.closed));
}

/** The polyline itself as a curve, pressure 0.5; corners where it turns by more than 30°. A closed one repeats no point. */
export function polylineCurve(points: readonly Vec2[], closed: boolean): Curve {
  const distinct = points.filter((p, i) => i === 0 || length2(sub2(p, points[i - 1]!)) > 0);
  const ring = closed && distinct.length > 1 ? [...distinct, distinct[0]!] : distinct;
  const edges = ring.slice(1).map((q, i): Bezier => [ring[i]!, q]);
  if (edges.length === 0) return bezierCurve([[[points[0]!, points[0]!]]], closed, false, () => 0.5);
  const pieces: Bezier[][] = [[]];
  edges.forEach((edge, i) => {
    if (i > 0 && turns(edges[i - 1]!, edge)) pieces.push([]);
    pieces[pieces.length - 1]!.push(edge);
  });
  const smoothStart = closed && !turns(edges[edges.length - 1]!, edges[0]!);
  return bezierCurve(pieces, closed, smoothStart, () => 0.5);
}

/** Values spread evenly over u, joined by straight lines; a closed profile does not repeat its first. */
function evenProfile(values: readonly number[], closed: boolean): (u: number) => number {
  const last = closed ? values.length : values.length - 1;
  return (u) => {
    const x = u * last;
    const i = Math.min(Math.floor(x), last - 1);
    const before = values[Math.max(i, 0)] ?? 0.5;
    const after = values[closed ? (i + 1) % values.length : i + 1] ?? before;
    return before + (after - before) * (x - i);
  };
}

function turns(a: Bezier, b: Bezier): boolean {
  const p = sub2(a[1]!, a[0]!);
  const q = sub2(b[1]!, b[0]!);
  return Math.abs(atan2(cross2(p, q), dot2(p, q))) > POLYLINE_CORNER;
}
