import fc from 'fast-check';
import { describe, expect, test } from 'vitest';
import { distance2 } from '../../src/math/tuple.ts';
import { type Pair, pairCurves } from '../../src/surface/pair.ts';
import { circle, halfCircle, line, smoothStroke } from './curves.ts';

/** Largest error of the derivatives against central differences between stops, relative to the length. */
function derivativeError(pair: Pair): number {
  let most = 0;
  for (let u = 0.0037; u < 1; u += 0.0173) {
    if (pair.stops.some((stop) => Math.abs(stop.u - u) < 1e-4)) continue;
    const [a, here, b] = [pair.at(u - 1e-5, 1), pair.at(u, 1), pair.at(u + 1e-5, 1)];
    for (const [side, derivative] of [
      ['left', 'dLeft'],
      ['right', 'dRight'],
    ] as const) {
      const slope = [(b[side][0] - a[side][0]) / 2e-5, (b[side][1] - a[side][1]) / 2e-5] as const;
      most = Math.max(most, distance2(slope, here[derivative]) / pair.length);
    }
  }
  return most;
}

describe('pairs', () => {
  test('matched corners share one stop, a corner alone has its own', () => {
    const pair = pairCurves(
      line([-10, 0], [-10, 27], [-40, 60], [-40, 100]),
      line([10, 0], [10, 33], [40, 60], [90, 60]),
    );
    expect(pair.stops).toHaveLength(4);
    const at = pair.at(pair.stops[1]!.u, 1);
    expect([at.left, at.right].map(([, y]) => Math.round(y)).sort()).toEqual([27, 33]);
  });

  test('u runs evenly by the mean length of the sides, corners or not', () => {
    const pair = pairCurves(line([-10, 0], [-10, 30], [-40, 60]), line([10, 0], [10, 40], [40, 50]));
    const mean = (from: number, to: number): number => {
      const [a, b] = [pair.at(from, 1), pair.at(to, -1)];
      return (distance2(a.left, b.left) + distance2(a.right, b.right)) / 2;
    };
    const corner = pair.stops[1]!.u;
    expect(mean(0, corner) / corner).toBeCloseTo(pair.length, 6);
    expect(mean(corner, 1) / (1 - corner)).toBeCloseTo(pair.length, 6);
    expect(mean(0, corner / 2)).toBeCloseTo(mean(corner / 2, corner), 6);
  });

  test('sides of a crossing are in one point there', () => {
    const pair = pairCurves(line([-20, 50], [15, -50]), line([20, 55], [-25, -50]));
    const crossing = pair.stops.find(({ pole }) => pole)!;
    const { left, right } = pair.at(crossing.u, 1);
    expect(distance2(left, right)).toBeLessThan(1e-9);
  });

  test('ends that nearly meet are made to meet, and the sides far from them stay', () => {
    const pair = pairCurves(halfCircle(50, -1, -1), halfCircle(50, 1, 1));
    expect(pair.stops.map(({ pole }) => pole)).toEqual([true, true]);
    for (const u of [0, 1]) expect(distance2(pair.at(u, 1).left, pair.at(u, 1).right)).toBeLessThan(1e-12);
    expect(Math.abs(pair.at(0.5, 1).left[0])).toBeCloseTo(51, 9);
    expect(derivativeError(pair)).toBeLessThan(1e-3);
  });

  test('ends of a rod stay apart', () => {
    const pair = pairCurves(line([-1, 0], [-1, 100]), line([1, 0], [1, 100]));
    expect(pair.stops.some(({ pole }) => pole)).toBe(false);
  });

  test('a closed pair ends where it begins', () => {
    const pair = pairCurves(circle(0, 0, 10), circle(3, 0, 30, -1, 2));
    expect(pair.closed).toBe(true);
    expect(distance2(pair.at(0, 1).left, pair.at(1, -1).left)).toBeLessThan(1e-9);
    expect(distance2(pair.at(0, 1).right, pair.at(1, -1).right)).toBeLessThan(1e-9);
  });

  test('random strokes: stops ascend, derivatives fit (seed 53)', () => {
    fc.assert(
      fc.property(smoothStroke(1), smoothStroke(1), (a, b) => {
        const pair = pairCurves(a, b);
        const us = pair.stops.map(({ u }) => u);
        expect([us[0], us.at(-1)]).toEqual([0, 1]);
        expect(us.every((u, i) => i === 0 || u > us[i - 1]!)).toBe(true);
        expect(derivativeError(pair)).toBeLessThan(1e-2);
      }),
      { seed: 53, numRuns: 40 },
    );
  }, 30_000);
});
