import { describe, expect, test } from 'vitest';
import { functionCurve } from '../../src/stroke/arcLength.ts';
import type { Curve } from '../../src/stroke/curve.ts';
import { matchSides } from '../../src/surface/match.ts';
import { openSide } from '../../src/surface/side.ts';
import { line } from './curves.ts';

const match = (a: Curve, b: Curve) => {
  const [l, r] = [a, b].map((curve) => openSide(curve, { start: 0, reversed: false })) as [never, never];
  return matchSides(l, r, false);
};

/** A staircase: corners at the given heights of a wall 100 high, alternately to the left and back. */
const wall = (x: number, ...heights: number[]): Curve =>
  line([x, 0], ...heights.map((y, i) => [x + (i % 2 === 0 ? 0 : 12), y] as const), [x, 100]);

describe('matching', () => {
  test('smooth strokes match at their ends only', () => {
    expect(match(line([0, 0], [0, 10]), line([5, 0], [5, 10]))).toEqual([
      { a: 0, b: 0, crossing: false },
      { a: 1, b: 1, crossing: false },
    ]);
  });

  test('corners match in order, however far the hand has moved them', () => {
    const [l, r] = [wall(0, 20, 40, 70, 80), wall(50, 26, 44, 66, 83)];
    const found = match(l, r).slice(1, -1);
    expect(found.map(({ a }) => a)).toEqual(l.corners);
    expect(found.map(({ b }) => b)).toEqual(r.corners);
  });

  test('a corner too many stays alone, the others match', () => {
    const l = line([0, 0], [0, 20], [20, 40], [0, 60], [0, 90], [20, 95]);
    const r = line([50, 0], [50, 20], [30, 40], [50, 60], [50, 100]);
    const found = match(l, r).slice(1, -1);
    expect(l.corners).toHaveLength(4);
    expect(found.map(({ a }) => a)).toEqual(l.corners.slice(0, 3));
    expect(found.map(({ b }) => b)).toEqual(r.corners);
  });

  test('corners at opposite ends do not match', () => {
    const found = match(line([0, 0], [0, 90], [20, 100]), line([50, 0], [40, 10], [40, 100]));
    expect(found).toHaveLength(2);
  });

  test('crossings match, in order', () => {
    const wave = (sign: number): Curve =>
      functionCurve((t) => [sign * 10 * Math.cos(3 * Math.PI * t) + 2, 100 * t], false);
    const found = match(wave(1), wave(-1));
    expect(found.map(({ crossing }) => crossing)).toEqual([false, true, true, true, false]);
    for (const { a, b } of found) expect(a).toBeCloseTo(b, 6);
  });

  test('a crossing in one stroke’s middle and the other’s end is not matched', () => {
    const found = match(line([0, 0], [0, 100]), line([-1, 99], [40, 99]));
    expect(found.filter(({ crossing }) => crossing)).toEqual([]);
  });

  test('tips that overshoot are trimmed', () => {
    const found = match(line([0.5, 51], [-20, 0]), line([-0.5, 51], [20, 0]));
    expect(found[0]).toMatchObject({ crossing: true });
    expect(found[0]!.a).toBeCloseTo(0.5 / 20.5, 9);
    expect(found[1]).toEqual({ a: 1, b: 1, crossing: false });
  });
});
