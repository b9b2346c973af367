import { describe, expect, test } from 'vitest';
import type { Vec2 } from '../../src/math/vec.ts';
import { type Degree, splineDerivative, splinePoint } from '../../src/stroke/bspline.ts';
import { fitFair } from '../../src/stroke/fair.ts';
import { fitLeastSquares } from '../../src/stroke/leastSquares.ts';
import { normal } from '../fixtures/random.ts';

const RADIUS = 40;
const COUNT = 30;
const POINTS = 8 * COUNT;

/** Even points of a circle or of its upper half, each `noise` beside it. */
function arc(closed: boolean, noise: number, seed: number): Vec2[] {
  const n = normal(seed);
  return Array.from({ length: POINTS }, (_, i): Vec2 => {
    const angle = closed ? (2 * Math.PI * i) / POINTS : (Math.PI * i) / (POINTS - 1);
    return [RADIUS * Math.cos(angle) + noise * n(), RADIUS * Math.sin(angle) + noise * n()];
  });
}

/** Root mean square of curvature × radius − 1 along the middle of the curve: 0 on a circle. */
function unfairness(controls: readonly Vec2[], degree: Degree, closed: boolean): number {
  const spans = closed ? controls.length : controls.length - degree;
  const step = 0.05;
  let sum = 0;
  let count = 0;
  for (let t = 3; t < spans - 3; t += step) {
    const a = splineDerivative(controls, degree, closed, t);
    const b = splineDerivative(controls, degree, closed, t + step);
    const turn = Math.atan2(a[0] * b[1] - a[1] * b[0], a[0] * b[0] + a[1] * b[1]);
    sum += ((turn / (step * Math.hypot(...a))) * RADIUS - 1) ** 2;
    count++;
  }
  return Math.sqrt(sum / count);
}

describe.each([false, true])('fair least squares, closed %s', (closed) => {
  test('a clean line stays what it is', () => {
    const fine = arc(closed, 0, 1);
    const fair = fitFair(fine, closed, COUNT, 0.25);
    const plain = fitLeastSquares(fine, 3, closed, COUNT);
    for (const [i, p] of fair.entries())
      expect(Math.hypot(p[0] - plain[i]![0], p[1] - plain[i]![1])).toBeLessThan(0.01);
  });

  test.each([1, 2, 3, 4])(
    'a trembling line bends a fifth as unevenly as without fairing (seed %i)',
    (seed) => {
      const fine = arc(closed, 0.15, seed);
      const before = unfairness(fitLeastSquares(fine, 2, closed, COUNT), 2, closed);
      const after = unfairness(fitFair(fine, closed, COUNT, 0.25), 3, closed);
      expect(after).toBeLessThan(before / 5);
    },
  );

  test.each([0.02, 0.1, 0.25])('moves by %f at the most (seed 7)', (most) => {
    const fine = arc(closed, 0.3, 7);
    const fair = fitFair(fine, closed, COUNT, most);
    const plain = fitLeastSquares(fine, 3, closed, COUNT);
    const spans = closed ? COUNT : COUNT - 3;
    for (let i = 0; i < POINTS; i++) {
      const t = (i * spans) / (closed ? POINTS : POINTS - 1);
      const a = splinePoint(fair, 3, closed, t);
      const b = splinePoint(plain, 3, closed, t);
      expect(Math.hypot(a[0] - b[0], a[1] - b[1])).toBeLessThanOrEqual(most + 1e-12);
    }
  });

  test('0 is plain least squares', () => {
    const fine = arc(closed, 0.3, 9);
    expect(fitFair(fine, closed, COUNT, 0)).toEqual(fitLeastSquares(fine, 3, closed, COUNT));
  });
});

test('a wave of 16 mm keeps its height (seed 5)', () => {
  const n = normal(5);
  const fine = Array.from(
    { length: 360 },
    (_, i): Vec2 => [i / 1.5, 3 * Math.sin((2 * Math.PI * i) / 1.5 / 16) + 0.1 * n()],
  );
  const fair = fitFair(fine, false, 45, 0.25);
  const top = Math.max(
    ...Array.from({ length: 2000 }, (_, i) => splinePoint(fair, 3, false, 4 + (34 * i) / 2000)[1]),
  );
  const plain = fitLeastSquares(fine, 3, false, 45);
  const plainTop = Math.max(
    ...Array.from({ length: 2000 }, (_, i) => splinePoint(plain, 3, false, 4 + (34 * i) / 2000)[1]),
  );
  expect(top).toBeGreaterThan(0.92 * plainTop);
});
