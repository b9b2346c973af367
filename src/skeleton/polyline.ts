/**
 * A line through points with a weight at each, open or closed: a segment with a linear weight between neighbours (Jin & Tai;
 * Tai et al. (7), whose weights at the ends are w₀ and w₁). Neighbours meet without a seam: splitting a segment leaves the field.
 */

import type { Vec3 } from '../math/vec.ts';
import { distance3 } from './curve.ts';
import { FieldError } from './skeleton.ts';
import type { SegmentSkel } from './skels.ts';

export interface PolylineSkel {
  readonly type: 'polyline';
  readonly points: readonly Vec3[];
  /** one a point */
  readonly weights: readonly number[];
  readonly closed: boolean;
}

/** FieldError when the numbers of points and weights differ, or no two points are apart. */
export function expandPolyline({ points, weights, closed }: PolylineSkel): SegmentSkel[] {
  if (points.length !== weights.length) {
    throw new FieldError(`${points.length} points need as many weights, got ${weights.length}`);
  }
  const last = closed ? points.length : points.length - 1;
  const segments = Array.from({ length: Math.max(last, 0) }, (_, i) => {
    const j = (i + 1) % points.length;
    return linearSegment(points[i]!, points[j]!, weights[i]!, weights[j]!);
  }).filter((segment) => segment !== null);
  if (segments.length === 0) throw new FieldError('a polyline needs two points that are apart');
  return segments;
}

/** Weight w0 at a, w1 at b; null when the ends are the same. */
export function linearSegment(a: Vec3, b: Vec3, w0: number, w1: number): SegmentSkel | null {
  const length = distance3(a, b);
  if (length === 0) return null;
  return { type: 'segment', a, b, weights: w0 === w1 ? [w0] : [w0, (w1 - w0) / length] };
}
