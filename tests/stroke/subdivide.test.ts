import { describe, expect, test } from 'vitest';
import type { Vec2 } from '../../src/math/vec.ts';
import { type Degree, spanCount, splinePoint } from '../../src/stroke/bspline.ts';
import { admissibleCount, coarseCount, fineCount, subdivide } from '../../src/stroke/subdivide.ts';
import { normal } from '../fixtures/random.ts';

const net = (count: number, seed: number): Vec2[] => {
  const n = normal(seed);
  return Array.from({ length: count }, (): Vec2 => [n(), n()]);
};

describe.each([2, 3] as const)('subdivision of degree %i', (degree: Degree) => {
  for (const closed of [false, true]) {
    for (const count of [closed ? 3 : degree + 1, 5, 6, 7, 12]) {
      test(`${closed ? 'closed' : 'open'}, ${count} points: the curve stays where it is (seed ${count})`, () => {
        const coarse = net(count, count);
        const fine = subdivide(coarse, degree, closed);
        expect(fine).toHaveLength(fineCount(count, degree, closed, 1));
        const spans = spanCount({ degree, closed, count });
        for (let t = 0; t < spans; t += 0.11) {
          const a = splinePoint(coarse, degree, closed, t);
          const b = splinePoint(fine, degree, closed, 2 * t);
          expect(b[0]).toBeCloseTo(a[0], 12);
          expect(b[1]).toBeCloseTo(a[1], 12);
        }
      });
    }
  }

  test('counts: fine and coarse are inverse, admissible ones are the next', () => {
    for (const closed of [false, true]) {
      for (let levels = 0; levels <= 6; levels++) {
        for (let n = 4; n < 40; n++) {
          const fine = fineCount(n, degree, closed, levels);
          expect(coarseCount(fine, degree, closed, levels)).toBe(n);
          expect(admissibleCount(fine, degree, closed, levels)).toBe(fine);
          const next = fineCount(n + 1, degree, closed, levels);
          expect(admissibleCount(fine + 1, degree, closed, levels)).toBe(next);
          if (levels > 0) expect(coarseCount(fine + 1, degree, closed, levels)).toBeNull();
        }
      }
    }
  });
});

test('counts as derived: closed 2ᴸN, open quadratic 2ᴸ(N−2)+2, open cubic 2ᴸ(N−3)+3', () => {
  expect(fineCount(8, 2, false, 3)).toBe(50);
  expect(fineCount(8, 3, false, 3)).toBe(43);
  expect(fineCount(8, 2, true, 3)).toBe(64);
});

test('too few points are refused', () => {
  expect(() => subdivide(net(2, 1), 2, false)).toThrow(RangeError);
  expect(() => subdivide(net(3, 1), 3, false)).toThrow(RangeError);
  expect(() => subdivide(net(2, 1), 3, true)).toThrow(RangeError);
});
