import { describe, expect, it } from 'vitest';
import { boundedLeastSquares } from '../../src/math/boundedLeastSquares.ts';
import { leastSquares } from '../../src/math/lstsq.ts';
import { random } from '../fixtures/random.ts';

function problem(seed: number, rows: number, n: number) {
  const next = random(seed);
  return {
    rows: Array.from({ length: rows }, () => Array.from({ length: n }, () => next() - 0.3)),
    y: Array.from({ length: rows }, () => 2 * next() - 1),
  };
}

describe('boundedLeastSquares', () => {
  it.each([1, 2, 3])('is least squares where no bound is reached (seed %i)', (seed) => {
    const { rows, y } = problem(seed, 40, 8);
    const none = Array.from({ length: 8 }, () => Infinity);
    const { x } = boundedLeastSquares(
      rows,
      y,
      none.map((v) => -v),
      none,
      none.map(() => 0),
    );
    for (const [i, value] of leastSquares(rows, y).entries()) expect(x[i]!).toBeCloseTo(value, 6);
  });

  it.each([4, 5, 6, 7])('meets the conditions of Karush, Kuhn and Tucker (seed %i)', (seed) => {
    const { rows, y } = problem(seed, 30, 12);
    const [low, high] = [rows[0]!.map(() => -0.05), rows[0]!.map(() => 0.1)];
    const { x } = boundedLeastSquares(
      rows,
      y,
      low,
      high,
      rows[0]!.map(() => 0),
    );
    const rest = rows.map((row, i) => row.reduce((sum, a, j) => sum + a * x[j]!, 0) - y[i]!);
    x.forEach((value, j) => {
      const slope = rows.reduce((sum, row, i) => sum + row[j]! * rest[i]!, 0);
      expect(value).toBeGreaterThanOrEqual(low[j]!);
      expect(value).toBeLessThanOrEqual(high[j]!);
      if (value > low[j]!) expect(slope).toBeLessThan(1e-6);
      if (value < high[j]!) expect(slope).toBeGreaterThan(-1e-6);
    });
  });

  it('leaves an unknown that no row has where it was, within its bounds', () => {
    const { x } = boundedLeastSquares([[1, 0, 0]], [2], [0, 0, 3], [9, 9, 9], [0, 1, 1]);
    expect(x).toEqual([2, 1, 3]);
  });
});
