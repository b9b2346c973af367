import { describe, expect, test } from 'vitest';
import {
  controlCount,
  type Ends,
  limitMask,
  type Mask,
  slopeMask,
  subdivisionMask,
} from '../../src/surface/bspline.ts';
import { normal } from '../fixtures/random.ts';
import { basis } from './basis.ts';

function apply(mask: Mask, points: readonly number[]): number[] {
  const { length } = points;
  return mask.map(({ from, weights }) =>
    weights.reduce((sum, weight, k) => sum + weight * points[(from + k + length) % length]!, 0),
  );
}

function value(points: readonly number[], weights: readonly number[]): number {
  return points.reduce((sum, p, i) => sum + p * weights[i]!, 0);
}

const COUNTS: Readonly<Record<Ends, readonly number[]>> = {
  clamped: [4, 5, 6, 7, 8, 9, 13, 30],
  periodic: [3, 4, 5, 8, 13],
};

for (const ends of ['clamped', 'periodic'] as const) {
  for (const count of COUNTS[ends]) {
    describe(`${ends}, ${count} control points (seed ${count})`, () => {
      const next = normal(count);
      const points = Array.from({ length: count }, () => next());
      const spans = ends === 'clamped' ? count - 3 : count;

      for (const times of [0, 1, 2, 3, 4, 5]) {
        test(`subdivided ${times} times: positions and derivatives are the basis functions'`, () => {
          let fine = points;
          for (let i = 0; i < times; i++) fine = apply(subdivisionMask(fine.length, ends), fine);
          const halved = 2 ** times;
          expect(fine).toHaveLength(controlCount(spans * halved, ends));
          const at = apply(limitMask(fine.length, ends), fine);
          const slopes = apply(slopeMask(fine.length, ends), fine);
          expect(at).toHaveLength(spans * halved + (ends === 'clamped' ? 1 : 0));
          at.forEach((p, k) => {
            const truth = basis(count, ends, k / halved);
            expect(Math.abs(p - value(points, truth.at))).toBeLessThan(1e-12);
            expect(Math.abs(slopes[k]! * halved - value(points, truth.slope))).toBeLessThan(1e-9);
          });
        });
      }

      test('weights of every result sum to 1, of derivatives to 0', () => {
        const sums = (mask: Mask) => mask.map(({ weights }) => weights.reduce((a, b) => a + b, 0));
        for (const sum of sums(subdivisionMask(count, ends))) expect(sum).toBe(1);
        for (const sum of sums(limitMask(count, ends))) expect(sum).toBeCloseTo(1, 15);
        for (const sum of sums(slopeMask(count, ends))) expect(sum).toBe(0);
      });
    });
  }
}

test('too few points are refused', () => {
  for (const mask of [subdivisionMask, limitMask, slopeMask]) {
    expect(() => mask(3, 'clamped')).toThrow(RangeError);
    expect(() => mask(2, 'periodic')).toThrow(RangeError);
  }
});
