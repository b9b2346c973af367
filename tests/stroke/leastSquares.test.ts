import { describe, expect, test } from 'vitest';
import type { Vec2 } from '../../src/math/vec.ts';
import { type Basis, spanCount, splinePoint, weightsAt } from '../../src/stroke/bspline.ts';
import { fitLeastSquares } from '../../src/stroke/leastSquares.ts';
import { normal } from '../fixtures/random.ts';

const noise = (count: number, seed: number): Vec2[] => {
  const n = normal(seed);
  return Array.from({ length: count }, (): Vec2 => [n(), n()]);
};

function residual(fine: readonly Vec2[], controls: readonly Vec2[], basis: Basis): number {
  const step = spanCount(basis) / (basis.closed ? fine.length : fine.length - 1);
  return fine.reduce((sum, f, i) => {
    const p = splinePoint(controls, basis.degree, basis.closed, i * step);
    return sum + (p[0] - f[0]) ** 2 + (p[1] - f[1]) ** 2;
  }, 0);
}

describe.each([
  [2, false],
  [2, true],
  [3, false],
  [3, true],
] as const)('least squares of degree %i, closed %s', (degree, closed) => {
  for (const count of [degree + 1, degree + 2, 8, 30]) {
    if (closed && count < 3) continue;
    test(`${count} control points: curves of its own kind come back (seed ${count})`, () => {
      const controls = noise(count, count);
      const basis: Basis = { degree, closed, count };
      const fine = Array.from({ length: 6 * count }, (_, i) =>
        splinePoint(controls, degree, closed, (i * spanCount(basis)) / (closed ? 6 * count : 6 * count - 1)),
      );
      const back = fitLeastSquares(fine, degree, closed, count);
      for (const [i, p] of back.entries()) {
        expect(p[0]).toBeCloseTo(controls[i]![0], 9);
        expect(p[1]).toBeCloseTo(controls[i]![1], 9);
      }
    });
  }

  test('no other control points are nearer to noise: every nudge makes it worse (seed 3)', () => {
    const fine = noise(60, 3);
    const basis: Basis = { degree, closed, count: 10 };
    const best = fitLeastSquares(fine, degree, closed, 10);
    const least = residual(fine, best, basis);
    for (let k = closed ? 0 : 1; k < (closed ? 10 : 9); k++) {
      for (const nudge of [-1e-3, 1e-3]) {
        const moved = best.map((p, i): Vec2 => (i === k ? [p[0] + nudge, p[1] - nudge] : p));
        expect(residual(fine, moved, basis)).toBeGreaterThan(least);
      }
    }
  });

  test('noise is damped as theory says: the gain is the root of unknowns over points (seed 5)', () => {
    const fine = noise(4000, 5);
    const basis: Basis = { degree, closed, count: 400 };
    const fit = fitLeastSquares(fine, degree, closed, 400);
    const step = spanCount(basis) / 4000;
    const power = fine.reduce((sum, _, i) => sum + splinePoint(fit, degree, closed, i * step)[0] ** 2, 0);
    expect(Math.sqrt(power / 4000)).toBeCloseTo(Math.sqrt(0.1), 1);
    expect(weightsAt(basis, 0).span).toBe(0);
  });
});

test('open ends are pinned exactly', () => {
  const fine = noise(50, 9);
  for (const degree of [2, 3] as const) {
    const fit = fitLeastSquares(fine, degree, false, 8);
    expect(fit[0]).toEqual(fine[0]);
    expect(fit[7]).toEqual(fine[49]);
  }
});

test('fewer points than unknowns are refused', () => {
  expect(() => fitLeastSquares(noise(5, 1), 2, false, 6)).toThrow(RangeError);
});
