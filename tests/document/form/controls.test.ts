import { describe, expect, test } from 'vitest';
import { controlsOf, evenKnots, grevilles, knotsFor } from '../../../src/document/form/controls.ts';
import type { Vec2 } from '../../../src/math/vec.ts';
import { nurbsPolyline } from '../../../src/skeleton/nurbs.ts';

describe('control points', () => {
  test('of a cubic are its own, whatever knots it has', () => {
    const knots = [0, 0, 0, 0, 0.2, 0.7, 1, 1, 1, 1];
    const own: readonly Vec2[] = [
      [0, 0],
      [10, 20],
      [30, -10],
      [40, 10],
      [55, 5],
      [60, 0],
    ];
    const fine = nurbsPolyline({
      type: 'nurbs',
      points: own.map(([x, y]) => [x, y, 0] as const),
      weights: own.map(() => 1),
      knots,
      density: 200,
    }).points;
    // each piece has as many points, however much of u it takes
    const point = (u: number): Vec2 => {
      const piece = u < 0.2 ? 0 : u < 0.7 ? 1 : 2;
      const [from, to] = [
        [0, 0.2],
        [0.2, 0.7],
        [0.7, 1],
      ][piece] as [number, number];
      const x = 200 * (piece + (u - from) / (to - from));
      const i = Math.min(Math.floor(x), 599);
      const [a, b] = [fine[i]!, fine[i + 1]!];
      return [a[0] + (x - i) * (b[0] - a[0]), a[1] + (x - i) * (b[1] - a[1])];
    };
    const found = controlsOf(point, knots);
    expect(found).toHaveLength(6);
    found.forEach((p, i) => {
      expect(Math.hypot(p[0] - own[i]![0], p[1] - own[i]![1])).toBeLessThan(0.01);
    });
  });

  test('ends are those of the stroke', () => {
    const point = (u: number): Vec2 => [60 * u, 20 * Math.sin(9 * u)];
    const found = controlsOf(point, null);
    expect([found[0], found.at(-1)]).toEqual([point(0), point(1)]);
  });

  test('knots that do not fit are none', () => {
    expect(knotsFor(null, 4)).toBeNull();
    expect(knotsFor([3, 3, 3, 3, 7, 7, 7, 7], 4)).toEqual([0, 0, 0, 0, 1, 1, 1, 1]);
    for (const bad of [
      [0, 0, 0, 1, 1, 1, 1, 1],
      [0, 0, 0, 0, 0, 0, 0, 0],
      [0, 0, 0, 0, 1, 1, 1],
      [1, 1, 1, 1, 0, 0, 0, 0],
    ])
      expect(knotsFor(bad, 4)).toBeNull();
  });

  test('Greville abscissae rise from 0 to 1', () => {
    const places = grevilles(evenKnots(7));
    expect([places[0], places.at(-1)]).toEqual([0, 1]);
    places.slice(1).forEach((u, i) => {
      expect(u).toBeGreaterThan(places[i]!);
    });
  });
});
