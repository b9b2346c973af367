import { describe, expect, test } from 'vitest';
import { distance2 } from '../../src/math/tuple.ts';
import { functionCurve } from '../../src/stroke/arcLength.ts';
import type { Curve } from '../../src/stroke/curve.ts';
import { crossings } from '../../src/surface/crossings.ts';
import { openSide } from '../../src/surface/side.ts';
import { circle, line } from './curves.ts';

const find = (a: Curve, b: Curve) => {
  const [l, r] = [a, b].map((curve) => openSide(curve, { start: 0, reversed: false })) as [never, never];
  return crossings(l, r);
};

describe('crossings', () => {
  test('of two lines, exactly', () => {
    const [only, ...others] = find(line([0, 0], [10, 10]), line([0, 4], [8, 4]));
    expect(others).toEqual([]);
    expect(only!.a).toBeCloseTo(0.4, 12);
    expect(only!.b).toBeCloseTo(0.5, 12);
  });

  test('of a wave and a line: all of them, in one point to 1e-9', () => {
    const wave = functionCurve((t) => [100 * t, 10 * Math.cos(7 * Math.PI * t)], false);
    const straight = line([0, 1], [100, 2]);
    const found = find(wave, straight);
    expect(found).toHaveLength(7);
    for (const { a, b } of found) expect(distance2(wave.point(a), straight.point(b))).toBeLessThan(1e-7);
    expect(found.every(({ a }, i) => i === 0 || a > found[i - 1]!.a)).toBe(true);
  });

  test('of two circles: two', () => {
    expect(find(circle(-8, 0, 10, 1, 0.3), circle(8, 1, 10, -1))).toHaveLength(2);
  });

  test('in a corner is at the corner itself, once', () => {
    const bent = line([0, 0], [5, 5], [0, 10]);
    const found = find(bent, line([1, 5], [5, 5], [7, 5]));
    expect(found).toHaveLength(1);
    expect(found[0]!.a).toBe(bent.corners[0]);
  });

  test('strokes on each other or apart have none', () => {
    expect(find(line([0, 0], [10, 20]), line([0, 0], [10, 20]))).toEqual([]);
    expect(find(line([0, 0], [10, 20]), line([1, 0], [11, 20]))).toEqual([]);
    expect(find(line([3, 3]), line([0, 0], [10, 20]))).toEqual([]);
  });
});
