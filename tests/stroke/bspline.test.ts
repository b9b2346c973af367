import { describe, expect, test } from 'vitest';
import type { Vec2 } from '../../src/math/vec.ts';
import {
  basisOf,
  bezierPoint,
  type Degree,
  limitPoints,
  spanCount,
  splineBeziers,
  splineDerivative,
  splinePoint,
  weightsAt,
} from '../../src/stroke/bspline.ts';
import { normal } from '../fixtures/random.ts';

const net = (count: number, seed: number): Vec2[] => {
  const n = normal(seed);
  return Array.from({ length: count }, (): Vec2 => [n(), n()]);
};

/** Cox and de Boor's recursion as the thesis prints it (equation 3.5, with 0/0 = 0): the independent truth. */
function coxDeBoor(knots: readonly number[], k: number, order: number, t: number): number {
  if (order === 1) return t >= knots[k]! && t < knots[k + 1]! ? 1 : 0;
  const share = (x: number, width: number) => (width === 0 ? 0 : x / width);
  return (
    share(t - knots[k]!, knots[k + order - 1]! - knots[k]!) * coxDeBoor(knots, k, order - 1, t) +
    share(knots[k + order]! - t, knots[k + order]! - knots[k + 1]!) * coxDeBoor(knots, k + 1, order - 1, t)
  );
}

const near = (a: Vec2, b: Vec2, digits = 12) => {
  expect(a[0]).toBeCloseTo(b[0], digits);
  expect(a[1]).toBeCloseTo(b[1], digits);
};

describe.each([2, 3] as const)('B-splines of degree %i', (degree: Degree) => {
  for (const count of [degree + 1, degree + 2, 5, 6, 7, 12]) {
    test(`clamped, ${count} points: equals the recursion of the thesis (seed ${count})`, () => {
      const points = net(count, count);
      const spans = count - degree;
      const knots = Array.from({ length: count + degree + 1 }, (_, i) =>
        Math.min(Math.max(i - degree, 0), spans),
      );
      for (let t = 0; t < spans; t += 0.07) {
        const truth = points.reduce<Vec2>(
          (sum, p, k) => {
            const w = coxDeBoor(knots, k, degree + 1, t);
            return [sum[0] + w * p[0], sum[1] + w * p[1]];
          },
          [0, 0],
        );
        near(splinePoint(points, degree, false, t), truth);
      }
    });
  }

  test.each([false, true])('weights sum to 1 and reproduce lines (closed: %s)', (closed) => {
    const basis = basisOf(net(9, 1), degree, closed);
    for (let t = -1; t < spanCount(basis) + 1; t += 0.13) {
      const { weights } = weightsAt(basis, t);
      expect(weights.reduce((a, b) => a + b)).toBeCloseTo(1, 14);
      expect(Math.min(...weights)).toBeGreaterThanOrEqual(0);
    }
  });

  test('open ends are the end points, exactly; beyond them t is clamped', () => {
    const points = net(8, 4);
    const spans = 8 - degree;
    const beziers = splineBeziers(points, degree, false);
    expect(bezierPoint(beziers[0]!, 0)).toEqual(points[0]);
    expect(bezierPoint(beziers[spans - 1]!, 1)).toEqual(points[7]);
    near(splinePoint(points, degree, false, -3), points[0]!);
    near(splinePoint(points, degree, false, spans + 3), points[7]!);
  });

  test.each([false, true])(
    'spans meet with equal tangents; Bézier form and basis agree (closed: %s)',
    (closed) => {
      const points = net(7, 6);
      const spans = spanCount(basisOf(points, degree, closed));
      for (let i = 0; i <= spans; i++) {
        if (!closed && (i === 0 || i === spans)) continue;
        const before = splineDerivative(points, degree, closed, i - 1e-9);
        near(splineDerivative(points, degree, closed, i), before, 7);
      }
      splineBeziers(points, degree, closed).forEach((b, i) => {
        for (const t of [0, 0.25, 0.5, 0.99])
          near(bezierPoint(b, t), splinePoint(points, degree, closed, i + t));
      });
    },
  );

  test.each([false, true])('the derivative is the slope of the curve (closed: %s)', (closed) => {
    const points = net(8, 9);
    for (let t = 0.05; t < 5; t += 0.1) {
      const [a, b] = [
        splinePoint(points, degree, closed, t - 1e-5),
        splinePoint(points, degree, closed, t + 1e-5),
      ];
      near(splineDerivative(points, degree, closed, t), [(b[0] - a[0]) / 2e-5, (b[1] - a[1]) / 2e-5], 5);
    }
  });

  test('a closed curve turns with its points: shifting them by one shifts t by one', () => {
    const points = net(6, 8);
    const shifted = [...points.slice(1), points[0]!];
    for (let t = 0; t < 6; t += 0.3) {
      near(splinePoint(shifted, degree, true, t), splinePoint(points, degree, true, t + 1));
    }
  });

  test('too few points are refused', () => {
    expect(() => splinePoint(net(degree, 1), degree, false, 0)).toThrow(RangeError);
    expect(() => splinePoint(net(2, 1), degree, true, 0)).toThrow(RangeError);
  });
});

test('limit points of a clamped cubic are the known masks', () => {
  const c = net(9, 2);
  const mask = (i: number, weights: readonly number[]): Vec2 => [
    weights.reduce((sum, w, k) => sum + w * c[i + k]![0], 0),
    weights.reduce((sum, w, k) => sum + w * c[i + k]![1], 0),
  ];
  const limits = limitPoints(c, 3, false);
  expect(limits).toHaveLength(7);
  near(limits[0]!, c[0]!);
  near(limits[1]!, mask(1, [1 / 4, 7 / 12, 1 / 6]));
  near(limits[2]!, mask(2, [1 / 6, 2 / 3, 1 / 6]));
  near(limits[3]!, mask(3, [1 / 6, 2 / 3, 1 / 6]));
  near(limits[5]!, mask(5, [1 / 6, 7 / 12, 1 / 4]));
  near(splineDerivative(c, 3, false, 0), mask(0, [-3, 3]));
  near(splineDerivative(c, 3, false, 1), mask(1, [-3 / 4, 1 / 4, 1 / 2]));
  near(splineDerivative(c, 3, false, 2), mask(2, [-1 / 2, 0, 1 / 2]));
  near(limitPoints(c, 3, true)[0]!, mask(0, [2 / 3, 1 / 6, 0, 0, 0, 0, 0, 0, 1 / 6]));
});
