import fc from 'fast-check';
import { describe, expect, test } from 'vitest';
import type { Vec2 } from '../../src/math/vec.ts';
import { reverseLevels, reverseSubdivide } from '../../src/stroke/reverse.ts';
import { fineCount, subdivide } from '../../src/stroke/subdivide.ts';

const point = fc.tuple(
  fc.double({ min: -1e3, max: 1e3, noNaN: true }),
  fc.double({ min: -1e3, max: 1e3, noNaN: true }),
) as fc.Arbitrary<Vec2>;

describe.each([
  [2, false],
  [2, true],
  [3, false],
  [3, true],
] as const)('reverse subdivision, degree %i, closed %s', (degree, closed) => {
  test('undoes one to three subdivisions (seed 7)', () => {
    fc.assert(
      fc.property(
        fc.array(point, { minLength: 4, maxLength: 20 }),
        fc.integer({ min: 1, max: 3 }),
        (coarse, levels) => {
          let fine: readonly Vec2[] = coarse;
          for (let i = 0; i < levels; i++) fine = subdivide(fine, degree, closed);
          const back = reverseLevels(fine, degree, closed, levels);
          back.forEach((p, i) => {
            expect(p[0]).toBeCloseTo(coarse[i]![0], 8);
            expect(p[1]).toBeCloseTo(coarse[i]![1], 8);
          });
        },
      ),
      { seed: 7, numRuns: 100 },
    );
  });

  test('refuses counts that no subdivision makes', () => {
    const fine = fineCount(6, degree, closed, 1);
    const line = (n: number) => Array.from({ length: n }, (_, i): Vec2 => [i, 0]);
    expect(() => reverseSubdivide(line(fine + 1), degree, closed)).toThrow(RangeError);
    expect(() => reverseSubdivide([], degree, closed)).toThrow(RangeError);
  });
});
