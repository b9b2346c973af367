/**
 * Clamped cubic NURBS curve as a skeleton (Jin & Tai, "NURBS curve skeletons"): each polynomial piece is cut into `density`
 * segments, points by de Boor's algorithm in homogeneous coordinates. The field weight is one more coordinate of the control
 * points, so that it is subdivided with the curve; between cuts it is linear.
 */
import type { Vec3 } from '../math/vec.ts';
import { expandPolyline, type PolylineSkel } from './polyline.ts';
import { FieldError } from './skeleton.ts';
import type { SegmentSkel } from './skels.ts';

export interface NurbsSkel {
  readonly type: 'nurbs';
  /** control points, at least 4 */
  readonly points: readonly Vec3[];
  /** of the field, one a control point */
  readonly weights: readonly number[];
  /** of the curve (rational), above 0, one a control point; all 1 when left out */
  readonly rational?: readonly number[];
  /** points + 4, not falling, the first and last four alike; evenly spaced when left out */
  readonly knots?: readonly number[];
  /** segments a polynomial piece, 1–256 */
  readonly density: number;
}

const DEGREE = 3;

/** FieldError for numbers that do not fit together. */
export function expandNurbs(skel: NurbsSkel): SegmentSkel[] {
  return expandPolyline(nurbsPolyline(skel));
}

/** The points at which the curve is cut, with their weights; FieldError for numbers that do not fit together. */
export function nurbsPolyline(skel: NurbsSkel): PolylineSkel {
  const knots = skel.knots ?? clampedKnots(skel.points.length);
  check(skel, knots);
  const controls = skel.points.map((p, i) => {
    const h = skel.rational?.[i] ?? 1;
    return [p[0] * h, p[1] * h, p[2] * h, skel.weights[i]! * h, h];
  });
  const vertices: number[][] = [];
  for (let span = DEGREE; span < skel.points.length; span++) {
    const [from, to] = [knots[span]!, knots[span + 1]!];
    if (from === to) continue;
    for (let i = vertices.length === 0 ? 0 : 1; i <= skel.density; i++) {
      vertices.push(deBoor(controls, knots, span, from + ((to - from) * i) / skel.density));
    }
  }
  return {
    type: 'polyline',
    points: vertices.map(([x, y, z, , h]): Vec3 => [x! / h!, y! / h!, z! / h!]),
    weights: vertices.map(([, , , w, h]) => w! / h!),
    closed: false,
  };
}

/** 0, 0, 0, 0, 1, 2 … n − 3 four times. */
export function clampedKnots(count: number): number[] {
  const last = count - DEGREE;
  return Array.from({ length: count + DEGREE + 1 }, (_, i) => Math.min(Math.max(i - DEGREE, 0), last));
}

function deBoor(
  controls: readonly (readonly number[])[],
  knots: readonly number[],
  span: number,
  t: number,
): number[] {
  const work = Array.from({ length: DEGREE + 1 }, (_, k) => [...controls[span - DEGREE + k]!]);
  for (let d = 1; d <= DEGREE; d++) {
    for (let k = DEGREE; k >= d; k--) {
      const left = knots[span - DEGREE + k]!;
      const right = knots[span + 1 + k - d]!;
      const a = (t - left) / (right - left);
      work[k] = work[k]!.map((x, c) => (1 - a) * work[k - 1]![c]! + a * x);
    }
  }
  return work[DEGREE]!;
}

function check({ points, weights, rational, density }: NurbsSkel, knots: readonly number[]): void {
  const n = points.length;
  if (n < DEGREE + 1) throw new FieldError(`a cubic curve needs 4 control points, got ${n}`);
  if (weights.length !== n)
    throw new FieldError(`${n} control points need as many weights, got ${weights.length}`);
  if (rational && !(rational.length === n && rational.every((h) => h > 0 && h < Infinity))) {
    throw new FieldError(`rational must be ${n} numbers above 0`);
  }
  if (!(Number.isInteger(density) && density >= 1 && density <= 256)) {
    throw new FieldError(`density must be a whole number from 1 to 256, got ${density}`);
  }
  const clamped = [0, n].every((i) => knots.slice(i, i + 4).every((knot) => knot === knots[i]));
  const rising = knots.every((knot, i) => Number.isFinite(knot) && (i === 0 || knot >= knots[i - 1]!));
  if (knots.length !== n + 4 || !clamped || !rising || knots[0] === knots[n]) {
    throw new FieldError(`knots must be ${n + 4} numbers that do not fall, the first and last four alike`);
  }
  if (knots.some((knot, i) => i > 0 && i < n && knot === knots[i + 3])) {
    throw new FieldError('more than three knots in one place tear a curve apart');
  }
}
