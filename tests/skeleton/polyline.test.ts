import { describe, expect, test } from 'vitest';
import { expandPolyline } from '../../src/skeleton/polyline.ts';

const points = [
  [0, 0, 0],
  [3, 0, 4],
  [3, 0, 4],
  [3, 6, 4],
] as const;

describe('polylines', () => {
  test('have the weights of their points at both ends of each segment; equal neighbours are skipped', () => {
    const segments = expandPolyline({ type: 'polyline', points, weights: [1, 2, 5, 5], closed: false });
    expect(segments).toEqual([
      { type: 'segment', a: [0, 0, 0], b: [3, 0, 4], weights: [1, 1 / 5] },
      { type: 'segment', a: [3, 0, 4], b: [3, 6, 4], weights: [5] },
    ]);
  });

  test('closed, the last point is joined to the first', () => {
    const segments = expandPolyline({ type: 'polyline', points, weights: [1, 2, 2, 5], closed: true });
    expect(segments).toHaveLength(3);
    expect(segments.at(-1)).toMatchObject({ a: [3, 6, 4], b: [0, 0, 0] });
    const [w0, slope] = segments.at(-1)!.weights;
    expect(w0! + slope! * Math.sqrt(61)).toBeCloseTo(1, 14);
  });

  test('what is no line is refused', () => {
    const line = { type: 'polyline', closed: false } as const;
    expect(() => expandPolyline({ ...line, points, weights: [1] })).toThrow(
      /4 points need as many weights, got 1/,
    );
    expect(() =>
      expandPolyline({
        ...line,
        points: [
          [1, 1, 1],
          [1, 1, 1],
        ],
        weights: [1, 2],
      }),
    ).toThrow(/apart/);
    expect(() => expandPolyline({ ...line, points: [], weights: [] })).toThrow(/apart/);
  });
});
