import { describe, expect, test } from 'vitest';
import type { Degree } from '../../src/stroke/bspline.ts';
import { type Row, reverseRow, subdivisionRow } from '../../src/stroke/masks.ts';
import { fineCount } from '../../src/stroke/subdivide.ts';
import { type Fraction, fraction, plus, times } from '../fixtures/fraction.ts';
import { random } from '../fixtures/random.ts';

const ZERO = fraction(0);

function apply(row: Row, points: readonly Fraction[]): Fraction {
  const n = points.length;
  return row.weights.reduce((sum, [numerator, denominator], k) => {
    const p = points[(((row.from + k) % n) + n) % n]!;
    return plus(sum, times(fraction(numerator, denominator), p));
  }, ZERO);
}

/** Random whole numbers: one row that is wrong by anything at all shows. */
function numbers(count: number, seed: number): Fraction[] {
  const next = random(seed);
  return Array.from({ length: count }, () => fraction(Math.floor(next() * 2_000_003) - 1_000_001));
}

const cases: readonly (readonly [Degree, boolean, readonly number[]])[] = [
  [2, false, [3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 25]],
  [2, true, [3, 4, 5, 8, 13]],
  [3, false, [4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 25]],
  [3, true, [3, 4, 5, 8, 13]],
];

describe('masks in exact rational arithmetic', () => {
  for (const [degree, closed, counts] of cases) {
    for (const count of counts) {
      const kind = `${closed ? 'closed' : 'open'}, degree ${degree}, ${count} points`;
      test(`${kind}: reverse undoes subdivision exactly (seed ${count})`, () => {
        const coarse = numbers(count, count);
        const fine = Array.from({ length: fineCount(count, degree, closed, 1) }, (_, i) =>
          apply(subdivisionRow(degree, closed, count, i), coarse),
        );
        const back = coarse.map((_, j) => apply(reverseRow(degree, closed, count, j), fine));
        expect(back).toEqual(coarse);
      });

      test(`${kind}: weights sum to 1`, () => {
        const ones = (n: number) => Array.from({ length: n }, () => fraction(1));
        const fine = fineCount(count, degree, closed, 1);
        for (let i = 0; i < fine; i++) {
          expect(apply(subdivisionRow(degree, closed, count, i), ones(count))).toEqual(fraction(1));
        }
        for (let j = 0; j < count; j++) {
          expect(apply(reverseRow(degree, closed, count, j), ones(fine))).toEqual(fraction(1));
        }
      });
    }
  }

  test('open rows stay inside their points and pin both ends', () => {
    for (const [degree, closed, counts] of cases) {
      if (closed) continue;
      for (const count of counts) {
        const fine = fineCount(count, degree, closed, 1);
        for (let j = 0; j < count; j++) {
          const row = reverseRow(degree, closed, count, j);
          expect(row.from).toBeGreaterThanOrEqual(0);
          expect(row.from + row.weights.length).toBeLessThanOrEqual(fine);
        }
        expect(reverseRow(degree, closed, count, 0)).toEqual({ from: 0, weights: [[1, 1]] });
        expect(reverseRow(degree, closed, count, count - 1)).toEqual({ from: fine - 1, weights: [[1, 1]] });
      }
    }
  });

  test('the misprint 23/96 of the thesis would not do: its weights sum to more than 1', () => {
    const { weights } = reverseRow(3, true, 8, 3);
    const sum = weights.reduce((total, [n, d]) => plus(total, fraction(n, d)), ZERO);
    expect(sum).toEqual(fraction(1));
    expect(plus(sum, fraction(23 * 100, 96 * 196))).not.toEqual(fraction(1));
  });
});
