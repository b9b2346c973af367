import { expect, test } from 'vitest';
import { leastSquares } from '../../src/math/lstsq.ts';
import { random } from '../fixtures/random.ts';

test('a consistent system is solved, even a badly conditioned one', () => {
  // Hilbert's matrix, condition 5e5
  const rows = Array.from({ length: 5 }, (_, i) => Array.from({ length: 5 }, (_, j) => 1 / (i + j + 1)));
  const x = [1, -2, 3, -4, 5];
  const y = rows.map((row) => row.reduce((sum, a, j) => sum + a * x[j]!, 0));
  leastSquares(rows, y).forEach((value, i) => {
    expect(value).toBeCloseTo(x[i]!, 9);
  });
});

test('the residual is orthogonal to every column (seed 31)', () => {
  const next = random(31);
  const rows = Array.from({ length: 60 }, () => Array.from({ length: 7 }, () => next() - 0.5));
  const y = rows.map(() => next());
  const x = leastSquares(rows, y);
  const residual = rows.map((row, i) => row.reduce((sum, a, j) => sum + a * x[j]!, -y[i]!));
  for (let j = 0; j < 7; j++) {
    expect(Math.abs(rows.reduce((sum, row, i) => sum + row[j]! * residual[i]!, 0))).toBeLessThan(1e-13);
  }
});

test('what is not determined is refused', () => {
  expect(() => leastSquares([[1, 2]], [1])).toThrow(/1 rows .* 2 unknowns/);
  expect(() =>
    leastSquares(
      [
        [1, 2],
        [2, 4],
        [3, 6],
      ],
      [1, 2, 3],
    ),
  ).toThrow(/unknown 1 is not determined/);
});
