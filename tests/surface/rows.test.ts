import fc from 'fast-check';
import { describe, expect, test } from 'vitest';
import { pieces, quadCount } from '../../src/surface/rows.ts';

describe('rows', () => {
  test('are even and about as many as wished', () => {
    expect(pieces([0, 0.25, 1], 8)).toEqual([
      [0, 0.125, 0.25],
      [0.25, 0.375, 0.5, 0.625, 0.75, 0.875, 1],
    ]);
  });

  test('every stop is a row to the last bit, every piece has its least (seed 3)', () => {
    const inner = fc.uniqueArray(fc.double({ min: 0.01, max: 0.99, noNaN: true }), { maxLength: 8 });
    fc.assert(
      fc.property(
        inner,
        fc.integer({ min: 1, max: 100 }),
        fc.integer({ min: 1, max: 4 }),
        (us, quads, least) => {
          const stops = [0, ...us.sort((a, b) => a - b), 1];
          const found = pieces(stops, quads, () => least);
          found.forEach((piece, i) => {
            expect([piece[0], piece.at(-1)]).toEqual([stops[i], stops[i + 1]]);
            expect(piece.length).toBeGreaterThan(least);
          });
          const count = found.reduce((sum, piece) => sum + piece.length - 1, 0);
          expect(Math.abs(count - quads)).toBeLessThanOrEqual(found.length * (least + 1));
        },
      ),
      { seed: 3 },
    );
  });

  test('numbers of quads are rounded and bounded below', () => {
    expect([quadCount('v', 7.6, 3), quadCount('v', 1, 3), quadCount('u', -5, 1)]).toEqual([8, 3, 1]);
    for (const wish of [Number.NaN, Infinity]) expect(() => quadCount('u', wish, 1)).toThrow(/u must be/);
  });
});
