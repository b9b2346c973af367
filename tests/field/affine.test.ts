import { describe, expect, test } from 'vitest';
import { type Affine, composed, IDENTITY, inverted, mappedBox, stretches } from '../../src/field/affine.ts';
import { random } from '../fixtures/random.ts';
import { points, RIGID, SKEW } from './trees.ts';

const apply = (m: Affine, [x, y, z]: readonly number[]) =>
  [0, 4, 8].map((r) => m[r]! * x! + m[r + 1]! * y! + m[r + 2]! * z! + m[r + 3]!);

const some: readonly [string, Affine][] = [
  ['identity', IDENTITY],
  ['rigid', RIGID],
  ['skew', SKEW],
  ['tiny', [1e-6, 0, 0, 5, 0, 2e-6, 0, 5, 1e-6, 0, 1e-6, 5]],
  ['flat', [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 2e-5, 0]],
];

describe('affine maps', () => {
  test.each(some)('%s: its inverse undoes it (seed 51)', (_, m) => {
    for (const p of points(50, 10, 51)) {
      apply(inverted(m), apply(m, p)).forEach((x, i) => {
        expect(x).toBeCloseTo(p[i]!, 7);
      });
      apply(composed(m, inverted(m)), p).forEach((x, i) => {
        expect(x).toBeCloseTo(p[i]!, 7);
      });
    }
  });

  test('composed is one after the other (seed 52)', () => {
    for (const p of points(50, 10, 52)) {
      apply(composed(SKEW, RIGID), p).forEach((x, i) => {
        expect(x).toBeCloseTo(apply(SKEW, apply(RIGID, p))[i]!, 12);
      });
    }
  });

  test.each(some)(
    '%s: no direction is stretched by less or more than said, some by nearly that (seed 53)',
    (_, m) => {
      const next = random(53);
      const { least, most } = stretches(m);
      const found = Array.from({ length: 20_000 }, () => {
        const v = [next() - 0.5, next() - 0.5, next() - 0.5];
        const moved = apply(m, v).map((x, i) => x - m[4 * i + 3]!);
        const length = (w: readonly number[]) => Math.sqrt(w.reduce((sum, x) => sum + x * x, 0));
        return length(moved) / length(v);
      });
      expect(Math.min(...found)).toBeGreaterThanOrEqual(least * (1 - 1e-9));
      expect(Math.max(...found)).toBeLessThanOrEqual(most * (1 + 1e-9));
      expect(Math.max(...found)).toBeGreaterThan(0.99 * most);
    },
  );

  test.each(some)('%s: a mapped box holds the mapped points, closely (seed 54)', (_, m) => {
    const box = mappedBox(m, { min: [-1, -2, -3], max: [1, 2, 3] });
    const corners = [-1, 1].flatMap((x) => [-2, 2].flatMap((y) => [-3, 3].map((z) => apply(m, [x, y, z]))));
    for (const i of [0, 1, 2]) {
      expect(box.min[i]).toBeCloseTo(Math.min(...corners.map((p) => p[i]!)), 12);
      expect(box.max[i]).toBeCloseTo(Math.max(...corners.map((p) => p[i]!)), 12);
    }
  });

  test('what flattens space, or is no matrix, is refused', () => {
    expect(() => inverted([1, 0, 0, 0, 0, 1, 0, 0, 1, 1, 0, 0])).toThrow(/flattens/);
    expect(() => inverted([1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1e-7, 0])).toThrow(/flattens/);
    expect(() => inverted(new Array(12).fill(0) as unknown as Affine)).toThrow(/flattens/);
    expect(() => inverted([1, 0, 0] as unknown as Affine)).toThrow(/12 numbers/);
    expect(() => inverted([...IDENTITY.slice(0, 11), Number.NaN] as unknown as Affine)).toThrow(/12 numbers/);
  });
});
