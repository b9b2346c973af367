import { describe, expect, test } from 'vitest';
import { solveBanded, solveCyclicBanded } from '../../src/math/banded.ts';
import { random } from '../fixtures/random.ts';

/** Gaussian elimination with pivoting: the independent truth. */
function solveDense(matrix: readonly (readonly number[])[], y: readonly number[]): number[] {
  const n = y.length;
  const a = matrix.map((row, i) => [...row, y[i]!]);
  for (let c = 0; c < n; c++) {
    const p = a
      .slice(c)
      .reduce((best, row, k) => (Math.abs(row[c]!) > Math.abs(a[best]![c]!) ? c + k : best), c);
    [a[c], a[p]] = [a[p]!, a[c]!];
    for (let r = c + 1; r < n; r++) {
      const k = a[r]![c]! / a[c]![c]!;
      for (let j = c; j <= n; j++) a[r]![j]! -= k * a[c]![j]!;
    }
  }
  const x = new Array<number>(n).fill(0);
  for (let i = n - 1; i >= 0; i--) {
    let sum = a[i]![n]!;
    for (let j = i + 1; j < n; j++) sum -= a[i]![j]! * x[j]!;
    x[i] = sum / a[i]![i]!;
  }
  return x;
}

/** Diagonally dominant, hence positive definite; entries outside an open band are noise that must be ignored. */
function system(n: number, bandwidth: number, seed: number) {
  const next = random(seed);
  const rows = Array.from({ length: n }, () =>
    Array.from({ length: bandwidth + 1 }, (_, d) => (d === 0 ? 2 * bandwidth + 1 + next() : 2 * next() - 1)),
  );
  return { rows, y: Array.from({ length: n }, () => 2 * next() - 1) };
}

function dense(rows: readonly (readonly number[])[], cyclic: boolean): number[][] {
  const n = rows.length;
  const full = Array.from({ length: n }, () => new Array<number>(n).fill(0));
  rows.forEach((row, i) => {
    row.forEach((value, d) => {
      if (i - d < 0 && !cyclic) return;
      const j = (((i - d) % n) + n) % n;
      full[i]![j]! += value;
      if (d > 0) full[j]![i]! += value;
    });
  });
  return full;
}

describe('banded systems', () => {
  for (const cyclic of [false, true]) {
    for (const bandwidth of [0, 1, 2, 3]) {
      for (const n of [1, 2, 3, 4, 5, 6, 7, 8, 20]) {
        if (cyclic && n === 1) continue;
        test(`${cyclic ? 'cyclic' : 'open'}, ${n} unknowns, bandwidth ${bandwidth} (seed ${n})`, () => {
          const { rows, y } = system(n, bandwidth, n);
          const x = (cyclic ? solveCyclicBanded : solveBanded)(rows, [y])[0]!;
          const truth = solveDense(dense(rows, cyclic), y);
          for (const [i, value] of x.entries()) expect(value).toBeCloseTo(truth[i]!, 12);
        });
      }
    }
  }

  test('solves several right-hand sides at once and leaves its input alone', () => {
    const { rows, y } = system(12, 2, 5);
    const before = structuredClone(rows);
    const [x, doubled] = solveCyclicBanded(rows, [y, y.map((v) => 2 * v)]);
    for (const [i, value] of x!.entries()) expect(doubled![i]).toBeCloseTo(2 * value, 12);
    expect(rows).toEqual(before);
    expect(solveBanded([], [[]])).toEqual([[]]);
  });

  test('refuses what is not positive definite', () => {
    expect(() =>
      solveBanded(
        [
          [1, 0],
          [1, 2],
        ],
        [[1, 1]],
      ),
    ).toThrow(RangeError);
    expect(() => solveBanded([[Number.NaN]], [[1]])).toThrow(RangeError);
  });
});
