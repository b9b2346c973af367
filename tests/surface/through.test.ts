import { describe, expect, test } from 'vitest';
import { limitMask, slopeMask } from '../../src/surface/bspline.ts';
import { masked } from '../../src/surface/net.ts';
import { clampedThrough, netOfRows, periodicThrough, turned } from '../../src/surface/through.ts';
import { normal } from '../fixtures/random.ts';

function expectClose(found: ArrayLike<number>, truth: ArrayLike<number>): void {
  expect(found).toHaveLength(truth.length);
  for (let i = 0; i < truth.length; i++) expect(found[i]!).toBeCloseTo(truth[i]!, 12);
}

function flat(points: readonly Float64Array[]): number[] {
  return points.flatMap((p) => [...p]);
}

function random(count: number, seed: number): Float64Array[] {
  const next = normal(seed);
  return Array.from({ length: count }, () => Float64Array.from({ length: 6 }, () => next()));
}

describe('a clamped spline', () => {
  for (const count of [2, 3, 4, 5, 12, 65]) {
    test(`passes through ${count} points with the given ends (seed ${count})`, () => {
      const points = random(count, count);
      const [first, last] = random(2, count + 100) as [Float64Array, Float64Array];
      const controls = netOfRows(clampedThrough(points, { first, last }));
      const at = masked(controls, 'u', limitMask(controls.rows, 'clamped')).points;
      expectClose(at, flat(points));
      expect(at.slice(0, 6)).toEqual(points[0]);
      expect(at.slice(-6)).toEqual(points[count - 1]);
      const slopes = masked(controls, 'u', slopeMask(controls.rows, 'clamped')).points;
      expectClose(slopes.slice(0, 6), first);
      expectClose(slopes.slice(-6), last);
    });
  }

  test('through points of a cubic is that cubic', () => {
    const cubic = (t: number) => [1 + t - t * t + 0.3 * t * t * t, 2 * t * t * t, -t];
    const slope = (t: number) => Float64Array.of(1 - 2 * t + 0.9 * t * t, 6 * t * t, -1);
    const points = [0, 1, 2, 3, 4, 5].map((t) => Float64Array.from(cubic(t)));
    const controls = netOfRows(clampedThrough(points, { first: slope(0), last: slope(5) }));
    const slopes = masked(controls, 'u', slopeMask(controls.rows, 'clamped')).points;
    expectClose(slopes, flat([0, 1, 2, 3, 4, 5].map(slope)));
  });
});

describe('a periodic spline', () => {
  for (const count of [3, 4, 5, 12, 64]) {
    test(`passes through ${count} points (seed ${count})`, () => {
      const points = random(count, count);
      const controls = netOfRows(periodicThrough(points));
      const at = masked(controls, 'u', limitMask(controls.rows, 'periodic')).points;
      expectClose(at, flat(points));
    });
  }
});

test('too few points are refused', () => {
  const slopes = { first: new Float64Array(6), last: new Float64Array(6) };
  expect(() => clampedThrough(random(1, 1), slopes)).toThrow(RangeError);
  expect(() => periodicThrough(random(2, 1))).toThrow(RangeError);
});

test('a net turned twice is itself', () => {
  const net = netOfRows(random(5, 1));
  expect(turned(net)).toMatchObject({ rows: 2, columns: 5 });
  expect(turned(turned(net))).toEqual(net);
});
