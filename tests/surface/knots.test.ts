import { describe, expect, test } from 'vitest';
import { knotPieces, knotsOf } from '../../src/surface/knots.ts';

describe('knots', () => {
  test('are even between breaks, and shared out by length', () => {
    const pieces = knotPieces([0, 0.25, 1], [], 16);
    expect(pieces.map(({ spans }) => spans)).toEqual([4, 12]);
    expect(knotsOf(pieces[0]!)).toEqual([0, 0.0625, 0.125, 0.1875, 0.25]);
    for (const [k, u] of knotsOf(pieces[1]!, 1).entries()) expect(u).toBeCloseTo(0.25 + k / 32, 15);
  });

  test('every place is one, to the last bit, however many there are', () => {
    for (const spans of [1, 2, 7, 16, 100]) {
      for (const places of [[0.3], [0.1, 0.11, 0.12, 0.9], [0.33, 0.34, 0.66, 0.67, 0.999]]) {
        const [piece] = knotPieces([0, 1], places, spans);
        const us = knotsOf(piece!);
        for (const place of places.filter((p) => p < 0.998)) expect(us).toContain(place);
        for (const [k, u] of us.entries()) expect(u).toBeGreaterThan(us[k - 1] ?? -1);
        expect(piece!.spans).toBeGreaterThanOrEqual(spans);
      }
    }
  });

  test('each piece gets at least what it asks for, and ends on its breaks', () => {
    const breaks = [0, 1 / 3, 0.34, 1];
    const pieces = knotPieces(breaks, [], 4, (i) => (i === 1 ? 3 : 1));
    expect(pieces[1]!.spans).toBe(3);
    pieces.forEach((piece, i) => {
      const us = knotsOf(piece, 2);
      expect([us[0], us[us.length - 1]]).toEqual([breaks[i], breaks[i + 1]]);
    });
  });

  test('halving keeps the knots there are', () => {
    const [piece] = knotPieces([0, 1], [0.3, 0.7], 16);
    const fine = knotsOf(piece!, 3);
    for (const [k, u] of knotsOf(piece!).entries()) expect(fine[8 * k]).toBe(u);
  });
});
