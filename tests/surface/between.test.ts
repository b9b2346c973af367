import { describe, expect, test } from 'vitest';
import { mixOf } from '../../src/surface/between.ts';

/** What becomes of one number of a section. */
function mixed(
  mix: ReturnType<typeof mixOf>,
  values: readonly number[],
  u: number,
  side: -1 | 1 = 1,
): number {
  return mix(u, side).reduce((sum, { section, weight }) => sum + weight * values[section]!, 0);
}

function rate(mix: ReturnType<typeof mixOf>, values: readonly number[], u: number, side: -1 | 1 = 1): number {
  return mix(u, side).reduce((sum, share) => sum + share.rate * values[share.section]!, 0);
}

const US = [0.1, 0.25, 0.3, 0.7, 0.95];
const FORMS = [
  [1, 0, 2],
  [1.5, -1, 2],
  [2, 1, 2],
  [2.2, 0.5, 5],
  [0, 0.5, 2],
];
const GRID = Array.from({ length: 401 }, (_, i) => i / 400);

for (const between of ['cubic', 'linear'] as const) {
  for (const closed of [false, true]) {
    describe(`${between}, ${closed ? 'closed' : 'open'}`, () => {
      const mix = mixOf(US, FORMS, between, closed);

      test('every section is itself at its own u, from both sides', () => {
        US.forEach((u, k) => {
          for (const side of [-1, 1] as const) {
            FORMS[k]!.forEach((x, n) => {
              expect(
                mixed(
                  mix,
                  FORMS.map((form) => form[n]!),
                  u,
                  side,
                ),
              ).toBe(x);
            });
          }
        });
      });

      test('weights sum to 1 and rates to 0; rates are the derivatives', () => {
        for (const u of GRID) {
          expect(
            mixed(
              mix,
              US.map(() => 1),
              u,
            ),
          ).toBeCloseTo(1, 14);
          expect(
            rate(
              mix,
              US.map(() => 1),
              u,
            ),
          ).toBeCloseTo(0, 10);
          if (US.some((own) => Math.abs(own - u) < 1e-5) || u < 1e-5 || u > 1 - 1e-5) continue;
          const values = FORMS.map(([x]) => x!);
          const difference = (mixed(mix, values, u + 1e-6) - mixed(mix, values, u - 1e-6)) / 2e-6;
          expect(rate(mix, values, u)).toBeCloseTo(difference, 6);
        }
      });

      test('equal sections are constant', () => {
        const same = mixOf(
          US,
          US.map(() => [3, 4]),
          between,
          closed,
        );
        for (const u of GRID)
          expect(
            mixed(
              same,
              US.map(() => 3),
              u,
            ),
          ).toBeCloseTo(3, 14);
      });
    });
  }
}

test('constant beyond the first and the last section of an open surface', () => {
  const mix = mixOf(US, FORMS, 'cubic', false);
  for (const u of [0, 0.05]) expect(mix(u, 1)).toEqual([{ section: 0, weight: 1, rate: 0 }]);
  for (const u of [0.96, 1]) expect(mix(u, 1)).toEqual([{ section: 4, weight: 1, rate: 0 }]);
});

test('a ring goes on from the last to the first', () => {
  for (const between of ['cubic', 'linear'] as const) {
    const mix = mixOf([0.2, 0.8], [[0], [1]], between, true);
    expect(mixed(mix, [0, 1], 0)).toBeCloseTo(0.5, 14);
    expect(mixed(mix, [0, 1], 1)).toBeCloseTo(0.5, 14);
    // a quarter of the way between the two, on both sides
    expect(mixed(mix, [0, 1], 0.1)).toBeCloseTo(mixed(mix, [0, 1], 0.35), 12);
  }
});

describe('cubic', () => {
  test('has no jump in speed at sections', () => {
    for (const closed of [false, true]) {
      const mix = mixOf(US, FORMS, 'cubic', closed);
      for (const u of US) {
        for (const n of [0, 1, 2]) {
          const values = FORMS.map((form) => form[n]!);
          expect(rate(mix, values, u, -1)).toBeCloseTo(rate(mix, values, u, 1), 12);
        }
      }
    }
  });

  test('rising sections rise between, without overshooting, whatever their distances', () => {
    for (const us of [US, [0, 0.01, 0.5, 0.51, 1], [0.2, 0.4, 0.6, 0.8, 0.81]]) {
      for (const heights of [
        [0, 0, 1, 1, 1],
        [0, 0.001, 1, 1.001, 2],
        [0, 1, 1.01, 5, 5.01],
      ]) {
        const mix = mixOf(
          us,
          heights.map((h) => [h, 2 * h]),
          'cubic',
          false,
        );
        let before = -Infinity;
        for (const u of GRID) {
          const h = mixed(mix, heights, u);
          expect(h).toBeGreaterThanOrEqual(before - 1e-12);
          before = h;
        }
      }
    }
  });

  test('a peak stays the highest', () => {
    const heights = [0, 1, 0.2, 0.9, 0];
    const mix = mixOf(
      US,
      heights.map((h) => [h]),
      'cubic',
      false,
    );
    for (const u of GRID) {
      expect(mixed(mix, heights, u)).toBeLessThanOrEqual(1 + 1e-12);
      expect(mixed(mix, heights, u)).toBeGreaterThanOrEqual(-1e-12);
    }
  });

  test('even steps are a straight way between', () => {
    const us = [0, 0.25, 0.5, 0.75, 1];
    const mix = mixOf(
      us,
      us.map((u) => [u]),
      'cubic',
      false,
    );
    for (const u of [0.3, 0.4, 0.6]) expect(mixed(mix, us, u)).toBeCloseTo(u, 12);
  });
});
