import { describe, expect, test } from 'vitest';
import type { Vec3 } from '../../src/math/vec.ts';
import { clampedKnots, expandNurbs, type NurbsSkel } from '../../src/skeleton/nurbs.ts';
import { random } from '../fixtures/random.ts';
import { type Curve, curveField, sumField } from './curves.ts';

const curve: NurbsSkel = {
  type: 'nurbs',
  points: [
    [0, 0, 0],
    [2, 3, 0],
    [5, 1, 1],
    [6, -2, 3],
    [9, 0, 2],
    [10, 2, 0],
  ],
  weights: [1, 2, 0.5, 1, 3, 1],
  density: 8,
};

const vertices = (skel: NurbsSkel): Vec3[] => {
  const segments = expandNurbs(skel);
  return [...segments.map(({ a }) => a), segments.at(-1)!.b];
};
const startWeights = (skel: NurbsSkel) => expandNurbs(skel).map(({ weights }) => weights[0]!);

/** The basis function by its definition, half open. */
function cox(knots: readonly number[], i: number, degree: number, t: number): number {
  if (degree === 0) return knots[i]! <= t && t < knots[i + 1]! ? 1 : 0;
  const part = (from: number, over: number, n: number) =>
    over === 0 ? 0 : (from / over) * cox(knots, n, degree - 1, t);
  const [a, b, c, d] = [knots[i]!, knots[i + degree]!, knots[i + 1]!, knots[i + degree + 1]!];
  return part(t - a, b - a, i) + part(d - t, d - c, i + 1);
}

describe('NURBS skeletons', () => {
  test('density segments a span, through both ends', () => {
    const points = vertices(curve);
    expect(points).toHaveLength(3 * 8 + 1);
    expect(points[0]).toEqual(curve.points[0]);
    expect(points.at(-1)).toEqual(curve.points.at(-1));
    expect(clampedKnots(6)).toEqual([0, 0, 0, 0, 1, 2, 3, 3, 3, 3]);
  });

  test('four points are a Bézier curve (de Casteljau)', () => {
    const points = curve.points.slice(0, 4);
    const found = vertices({ ...curve, points, weights: [1, 1, 1, 1], density: 10 });
    found.forEach((p, i) => {
      const t = i / 10;
      const line = (a: Vec3, b: Vec3): Vec3 => a.map((x, k) => x + t * (b[k]! - x)) as unknown as Vec3;
      let work = points;
      while (work.length > 1) work = work.slice(1).map((b, k) => line(work[k]!, b));
      work[0]!.forEach((x, k) => {
        expect(p[k]).toBeCloseTo(x, 13);
      });
    });
  });

  test('any knots and rational weights: the sums of Cox’s basis functions (seed 87)', () => {
    const next = random(87);
    for (const count of [4, 5, 7, 9]) {
      const points = Array.from({ length: count }, (): Vec3 => [9 * next(), 9 * next(), 9 * next()]);
      const [rational, weights] = [0, 1].map(() => points.map(() => 0.2 + 3 * next()));
      const inner = Array.from({ length: count - 4 }, () => 0.1 + 5 * next()).sort((a, b) => a - b);
      if (count === 9) inner[2] = inner[1]!;
      const knots = [0, 0, 0, 0, ...inner, 6, 6, 6, 6];
      const skel = { ...curve, points, weights: weights!, rational: rational!, knots, density: 3 };
      const ends = [...new Set(knots)];
      const spans = ends.slice(1).map((to, i) => [ends[i]!, to] as const);
      const ts = spans.flatMap(([from, to]) => [0, 1, 2].map((i) => from + ((to - from) * i) / 3));
      const found = vertices(skel);
      ts.forEach((t, k) => {
        const basis = points.map((_, i) => rational![i]! * cox(knots, i, 3, t));
        const whole = basis.reduce((sum, b) => sum + b, 0);
        const mix = (of: (i: number) => number) => basis.reduce((sum, b, i) => sum + (b / whole) * of(i), 0);
        for (const axis of [0, 1, 2] as const) {
          expect(found[k]![axis]).toBeCloseTo(
            mix((i) => points[i]![axis]),
            12,
          );
        }
        expect(startWeights(skel)[k]).toBeCloseTo(
          mix((i) => weights![i]!),
          12,
        );
      });
    }
  });

  test('rational weights make an exact quarter of a circle', () => {
    const w = 1 + Math.SQRT2;
    const along = Math.SQRT2 / w;
    const quarter = vertices({
      ...curve,
      points: [
        [5, 0, 0],
        [5, 5 * along, 0],
        [5 * along, 5, 0],
        [0, 5, 0],
      ],
      weights: [1, 1, 1, 1],
      rational: [1, w / 3, w / 3, 1],
      density: 20,
    });
    for (const [x, y] of quarter) expect(Math.sqrt(x * x + y * y)).toBeCloseTo(5, 13);
  });

  test('the field weight follows the curve like a coordinate', () => {
    const weights = curve.points.map(([x]) => x);
    const found = startWeights({ ...curve, weights, rational: [1, 2, 1, 0.5, 1, 1] });
    const points = vertices({ ...curve, weights, rational: [1, 2, 1, 0.5, 1, 1] });
    found.forEach((w, i) => {
      expect(w).toBeCloseTo(points[i]![0], 13);
    });
  });

  test('more knots in one place make a corner there, four would tear it apart', () => {
    const points = vertices({ ...curve, knots: [0, 0, 0, 0, 1, 1, 2, 2, 2, 2], density: 4 });
    expect(points).toHaveLength(9);
    const seven = {
      ...curve,
      points: [...curve.points, [11, 0, 0] as const],
      weights: [1, 1, 1, 1, 1, 1, 1],
    };
    const corner = vertices({ ...seven, knots: [0, 0, 0, 0, 1, 1, 1, 2, 2, 2, 2], density: 4 });
    expect(corner[4]).toEqual(seven.points[3]);
    const eight = {
      ...seven,
      points: [...seven.points, [12, 0, 0] as const],
      weights: [...seven.weights, 1],
    };
    expect(() => expandNurbs({ ...eight, knots: [0, 0, 0, 0, 1, 1, 1, 1, 2, 2, 2, 2] })).toThrow(/tear/);
  });

  test('the field converges to that of the curve as 1/density²', () => {
    const points = curve.points.slice(0, 4);
    const weights = [1, 2, 0.5, 1];
    const bernstein = (t: number) => [(1 - t) ** 3, 3 * t * (1 - t) ** 2, 3 * t * t * (1 - t), t ** 3];
    const slope = (t: number) => [
      -3 * (1 - t) ** 2,
      3 * (1 - t) * (1 - 3 * t),
      3 * t * (2 - 3 * t),
      3 * t * t,
    ];
    const mix = (b: readonly number[], of: (k: number) => number) =>
      b.reduce((sum, x, k) => sum + x * of(k), 0);
    const truth: Curve = {
      at: (t) => [0, 1, 2].map((i) => mix(bernstein(t), (k) => points[k]![i]!)) as unknown as Vec3,
      speed: (t) => Math.hypot(...[0, 1, 2].map((i) => mix(slope(t), (k) => points[k]![i]!))),
      weight: (t) => mix(bernstein(t), (k) => weights[k]!),
    };
    const at: Vec3 = [2.5, 1, 1];
    const exact = curveField(truth, 'cauchy', { s: 0.8 }, at, 20);
    const error = (density: number) => {
      const segments = expandNurbs({ ...curve, points, weights, density });
      return Math.abs(sumField(segments, 'cauchy', { s: 0.8 })(at) - exact);
    };
    expect(error(8)).toBeLessThan(0.05);
    expect(error(8) / error(32)).toBeGreaterThan(12);
    expect(error(128)).toBeLessThan(2e-4);
  });

  test.each<[Partial<NurbsSkel>, RegExp]>([
    [{ points: curve.points.slice(0, 3) }, /needs 4 control points, got 3/],
    [{ weights: [1] }, /as many weights/],
    [{ rational: [1, 1, 0, 1, 1, 1] }, /rational must be 6 numbers above 0/],
    [{ density: 0 }, /density/],
    [{ density: 2.5 }, /density/],
    [{ knots: [0, 0, 0, 1, 1, 2, 3, 3, 3, 3] }, /knots/],
    [{ knots: [0, 0, 0, 0, 2, 1, 3, 3, 3, 3] }, /knots/],
    [{ knots: [0, 0, 0, 0, 1, 3, 3, 3, 3] }, /knots must be 10 numbers/],
    [{ knots: [0, 0, 0, 0, 0, 1, 3, 3, 3, 3] }, /tear a curve apart/],
  ])('%j is refused', (change, message) => {
    expect(() => expandNurbs({ ...curve, ...change })).toThrow(message);
  });
});
