/**
 * Uniform B-splines of degree 2 and 3, clamped (open) or periodic (closed).
 *
 * Theory: de Boor's basis functions on integer knots, the end knots repeated when clamped (the thesis, equation 3.5).
 * t runs over [0, spans]. A periodic curve begins at the join next to its first control point: for degree 2 halfway
 * from point 0 to point 1, for degree 3 at the limit of point 0, which is where both subdivisions leave their first fine
 * point, so that all filters begin a closed stroke at the same place.
 * Departure: evaluated exactly instead of by subdividing; after four subdivisions the control points of a random net are
 * still 8e-3 away from the surface (measured).
 */
import type { Vec2 } from '../math/vec.ts';

export type Degree = 2 | 3;

/** Which spline: how many control points, how they are joined. */
export interface Basis {
  readonly degree: Degree;
  readonly closed: boolean;
  /** number of control points */
  readonly count: number;
}

/** The basis of these control points; RangeError below degree + 1 (open) or 3 (closed) points. */
export function basisOf(points: readonly Vec2[], degree: Degree, closed: boolean): Basis {
  const least = closed ? 3 : degree + 1;
  if (points.length < least) {
    const kind = closed ? 'closed' : 'open';
    throw new RangeError(
      `a ${kind} B-spline of degree ${degree} needs ${least} points, got ${points.length}`,
    );
  }
  return { degree, closed, count: points.length };
}

/** Number of polynomial pieces, each one unit of t long. */
export function spanCount(basis: Basis): number {
  return basis.closed ? basis.count : basis.count - basis.degree;
}

/** The control point that the k-th weight of a span belongs to. */
export function controlIndex(basis: Basis, span: number, k: number): number {
  if (!basis.closed) return span + k;
  // degree 3 centres its first span on points 0 and 1, so it begins one point earlier
  const first = basis.degree === 2 ? span : span - 1;
  return (first + k + basis.count) % basis.count;
}

/** The span that t falls into and its degree + 1 weights (they sum to 1). Open splines clamp t, closed ones wrap it. */
export function weightsAt(basis: Basis, t: number): { readonly span: number; readonly weights: number[] } {
  const spans = spanCount(basis);
  const inside = basis.closed ? t - Math.floor(t / spans) * spans : Math.min(Math.max(t, 0), spans);
  const span = Math.min(Math.floor(inside), spans - 1);
  return { span, weights: deBoorWeights(basis, span, inside) };
}

/** Position at t, in the unit of the points. */
export function splinePoint(points: readonly Vec2[], degree: Degree, closed: boolean, t: number): Vec2 {
  const basis = basisOf(points, degree, closed);
  const { span, weights } = weightsAt(basis, t);
  return combine(points, basis, span, weights);
}

/** Derivative with respect to t. */
export function splineDerivative(points: readonly Vec2[], degree: Degree, closed: boolean, t: number): Vec2 {
  const basis = basisOf(points, degree, closed);
  const { span } = weightsAt(basis, t);
  const spans = spanCount(basis);
  const inside = closed ? t - Math.floor(t / spans) * spans : Math.min(Math.max(t, 0), spans);
  return bezierPoint(hodograph(spanBezier(points, basis, span)), inside - span);
}

/** Where the curve passes at its joins: limit positions of the control polygon (open: spans + 1 points, closed: spans). */
export function limitPoints(points: readonly Vec2[], degree: Degree, closed: boolean): Vec2[] {
  const spans = spanCount(basisOf(points, degree, closed));
  return Array.from({ length: closed ? spans : spans + 1 }, (_, i) => splinePoint(points, degree, closed, i));
}

/** The Bézier points of one span: the blossom at (i, i, i), (i, i, i+1), … on the spline's knots. */
export function spanBezier(points: readonly Vec2[], basis: Basis, span: number): Vec2[] {
  const { degree } = basis;
  return Array.from({ length: degree + 1 }, (_, k) => {
    const args = Array.from({ length: degree }, (_, j) => (j < degree - k ? span : span + 1));
    return blossom(points, basis, span, args);
  });
}

/** All spans as Bézier curves, in order. */
export function splineBeziers(points: readonly Vec2[], degree: Degree, closed: boolean): Vec2[][] {
  const basis = basisOf(points, degree, closed);
  return Array.from({ length: spanCount(basis) }, (_, span) => spanBezier(points, basis, span));
}

/** Position on a Bézier curve of degree 0 to 3 by de Casteljau: the ends are met exactly. */
export function bezierPoint(b: readonly Vec2[], t: number): Vec2 {
  return [coordinate(b, 0, t), coordinate(b, 1, t)];
}

/** Without a list: curves are asked thousands of times for a surface. */
function coordinate(b: readonly Vec2[], k: 0 | 1, t: number): number {
  const s = 1 - t;
  const first = b[0]![k];
  if (b.length === 1) return first;
  let p = first * s + b[1]![k] * t;
  if (b.length === 2) return p;
  let q = b[1]![k] * s + b[2]![k] * t;
  p = p * s + q * t;
  if (b.length === 3) return p;
  const r = b[2]![k] * s + b[3]![k] * t;
  q = q * s + r * t;
  return p * s + q * t;
}

/** The control points of the derivative with respect to t, one fewer. */
export function hodograph(b: readonly Vec2[]): Vec2[] {
  const n = b.length - 1;
  if (n === 0) return [[0, 0]];
  return Array.from({ length: n }, (_, i): Vec2 => {
    const p = b[i]!;
    const q = b[i + 1]!;
    return [n * (q[0] - p[0]), n * (q[1] - p[1])];
  });
}

/** The j-th knot, counted so that a span i lies between knots i + degree and i + degree + 1. */
function knot(basis: Basis, j: number): number {
  const value = j - basis.degree;
  return basis.closed ? value : Math.min(Math.max(value, 0), spanCount(basis));
}

/** The weights of one span's polynomials at any t, also beyond the span. */
export function deBoorWeights(basis: Basis, span: number, t: number): number[] {
  const weights = [1];
  for (let d = 1; d <= basis.degree; d++) {
    let carried = 0;
    for (let k = 0; k < d; k++) {
      const right = knot(basis, span + basis.degree + k + 1);
      const left = knot(basis, span + basis.degree + k + 1 - d);
      const share = weights[k]! / (right - left);
      weights[k] = carried + (right - t) * share;
      carried = (t - left) * share;
    }
    weights[d] = carried;
  }
  return weights;
}

function blossom(points: readonly Vec2[], basis: Basis, span: number, args: readonly number[]): Vec2 {
  const { degree } = basis;
  const work = Array.from({ length: degree + 1 }, (_, k) => points[controlIndex(basis, span, k)]!);
  for (let d = 1; d <= degree; d++) {
    for (let k = 0; k <= degree - d; k++) {
      const left = knot(basis, span + k + d);
      const right = knot(basis, span + k + degree + 1);
      const a = (args[d - 1]! - left) / (right - left);
      const p = work[k]!;
      const q = work[k + 1]!;
      work[k] = [p[0] * (1 - a) + q[0] * a, p[1] * (1 - a) + q[1] * a];
    }
  }
  return work[0]!;
}

/** Σ weights · controls of a span. */
export function combine(
  points: readonly Vec2[],
  basis: Basis,
  span: number,
  weights: readonly number[],
): Vec2 {
  let x = 0;
  let y = 0;
  weights.forEach((w, k) => {
    const p = points[controlIndex(basis, span, k)]!;
    x += w * p[0];
    y += w * p[1];
  });
  return [x, y];
}
