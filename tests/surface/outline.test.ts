import fc from 'fast-check';
import { describe, expect, test } from 'vitest';
import { distance2, length2, scale2, sub2 } from '../../src/math/tuple.ts';
import type { Vec2 } from '../../src/math/vec.ts';
import { functionCurve } from '../../src/stroke/arcLength.ts';
import {
  isReversed,
  type Outline,
  outlineOf,
  restricted,
  roundHalf,
  straight,
} from '../../src/surface/outline.ts';
import { bentStroke, halfCircle, line, polygon, reversed, smoothStroke } from './curves.ts';
import { bent, mushroom, roof, wave } from './outlines.ts';

const ACROSS = { reversed: false, across: true } as const;

/** The largest difference of a derivative from one-sided differences, where v is no corner. */
function rateError(outline: Outline): number {
  const h = 1e-6;
  let worst = 0;
  for (let i = 1; i < 60; i++) {
    const v = i / 60 + 1e-4;
    if (outline.corners.some((corner) => Math.abs(corner - v) < 1e-4)) continue;
    const difference = scale2(sub2(outline.point(v + h), outline.point(v - h)), 1 / (2 * h));
    worst = Math.max(worst, length2(sub2(difference, outline.derivative(v, 1))));
  }
  return worst;
}

describe('outlines of strokes', () => {
  test('begin and end on the construction curves to the last bit, whatever was drawn', () => {
    fc.assert(
      fc.property(
        fc.oneof(smoothStroke(30), bentStroke(false)),
        fc.boolean(),
        fc.boolean(),
        (curve, back, across) => {
          const outline = outlineOf(curve, { reversed: back, across });
          expect([outline.point(0), outline.point(1)]).toEqual([
            [-1, 0],
            [1, 0],
          ]);
          for (const v of [1e-9, 0.2, 0.5, 1 - 1e-9]) {
            for (const x of [...outline.point(v), ...outline.derivative(v, 1)])
              expect(x).toBeTypeOf('number');
            expect([...outline.point(v), ...outline.derivative(v, -1)].every(Number.isFinite)).toBe(true);
          }
          for (const v of outline.corners) expect(v > 0 && v < 1).toBe(true);
        },
      ),
      { seed: 54, numRuns: 100 },
    );
  });

  test('are the stroke moved, turned and scaled: a half circle drawn anywhere is the round one', () => {
    const turned = functionCurve((t) => {
      const angle = 0.7 - Math.PI * t;
      return [20 + 8 * Math.cos(angle), -5 + 8 * Math.sin(angle)];
    }, false);
    // clockwise, so its bulge lies to the left of its chord
    const outline = outlineOf(turned, ACROSS);
    for (let i = 0; i <= 20; i++) {
      const [x, y] = roundHalf.point(i / 20);
      expect(outline.point(i / 20)[0]).toBeCloseTo(x, 7);
      expect(outline.point(i / 20)[1]).toBeCloseTo(-y, 7);
    }
    expect(rateError(outline)).toBeLessThan(1e-5);
  });

  test('drawn across, what lies below a chord from left to right comes out; in the section’s plane y is y', () => {
    const below = line([0, 0], [10, -5], [20, 0]);
    expect(outlineOf(below, ACROSS).point(0.5)).toEqual([expect.closeTo(0, 12), expect.closeTo(0.5, 12)]);
    expect(outlineOf(below, { reversed: false, across: false }).point(0.5)[1]).toBeCloseTo(-0.5, 12);
    const fromRight = outlineOf(reversed(below), { reversed: true, across: true });
    for (const v of [0.1, 0.4, 0.8]) {
      fromRight.point(v).forEach((x, k) => {
        expect(x).toBeCloseTo(outlineOf(below, ACROSS).point(v)[k]!, 12);
      });
    }
  });

  test('keep their corners, and the tangents on both sides of them', () => {
    const skew = outlineOf(line([0, 0], [10, -10], [40, 0]), ACROSS);
    const skewed = outlineOf(line([40, 0], [10, -10], [0, 0]), { reversed: true, across: true });
    for (const outline of [skew, skewed]) {
      expect(outline.corners).toHaveLength(1);
      const [v] = outline.corners as [number];
      expect(v).toBeCloseTo(Math.sqrt(200) / (Math.sqrt(200) + Math.sqrt(1000)), 9);
      const [before, after] = [outline.derivative(v, -1), outline.derivative(v, 1)];
      expect(before[1] / before[0]).toBeCloseTo(1, 9);
      expect(after[1] / after[0]).toBeCloseTo(-1 / 3, 9);
      expect(rateError(outline)).toBeLessThan(1e-6);
    }
  });

  test('dots, loops and ends that meet are flat', () => {
    for (const curve of [line([3, 4]), polygon([0, 0], [10, 0], [5, 5]), line([0, 0], [10, 10], [0.01, 0])]) {
      expect(outlineOf(curve, ACROSS)).toBe(straight);
    }
  });

  test('the end nearer to q_l is the left one', () => {
    const curve = line([0, 1], [10, 1]);
    expect(isReversed(curve, [-1, 0], [11, 0])).toBe(false);
    expect(isReversed(curve, [11, 0], [-1, 0])).toBe(true);
  });
});

describe('strokes whose ends nearly meet', () => {
  /** a circle of radius 10 but for a gap, the ends `gap` apart */
  const omega = (gap: number): Outline => {
    const open = 2 * Math.asin(gap / 20);
    return outlineOf(
      functionCurve((t) => {
        const angle = -Math.PI / 2 - open / 2 - (2 * Math.PI - open) * t;
        return [10 * Math.cos(angle), 10 * Math.sin(angle)];
      }, false),
      { reversed: false, across: false },
    );
  };
  const height = (outline: Outline): number =>
    Math.max(...Array.from({ length: 101 }, (_, i) => outline.point(i / 100)[1]));

  test('are no higher than four chords, and keep their ends and derivatives', () => {
    for (const gap of [0.7, 1, 2, 4]) {
      expect(height(omega(gap))).toBeLessThanOrEqual(8.001);
      expect(omega(gap).point(0)).toEqual([-1, 0]);
      expect(omega(gap).point(1e-9)[0]).toBeCloseTo(-1, 6);
      expect(omega(gap).point(1 - 1e-9)[0]).toBeCloseTo(1, 6);
      expect(rateError(omega(gap))).toBeLessThan(0.01);
    }
  });

  test('go over into those that are as they were drawn', () => {
    // as far as the circle is wide is four chords of 5 mm
    for (const v of [0.1, 0.4, 0.7]) {
      const [a, b] = [omega(4.95).point(v), omega(5.05).point(v)];
      expect(distance2(a, b)).toBeLessThan(0.3);
    }
    expect(height(omega(6))).toBeCloseTo((2 / 6) * (10 + Math.sqrt(91)), 1);
  });
});

describe('round', () => {
  test('lies on the circle, its quarters exact, even in v', () => {
    const quarters: readonly [number, Vec2][] = [
      [0, [-1, 0]],
      [0.5, [0, 1]],
      [1, [1, 0]],
    ];
    for (const [v, p] of quarters) expect(roundHalf.point(v)).toEqual(p);
    for (const v of [0.13, 0.7]) expect(length2(roundHalf.point(v))).toBeCloseTo(1, 14);
    expect(length2(roundHalf.derivative(0.3, 1))).toBeCloseTo(Math.PI, 12);
    expect(rateError(roundHalf)).toBeLessThan(1e-6);
  });
});

describe('stretches of outlines', () => {
  test('have the points, the derivatives and the corners of what they are taken from', () => {
    for (const outline of [roof, mushroom, wave(0.5, 3), bent([-1, 0], [0, 2], [0.5, 0], [1, 0])]) {
      const part = restricted(outline, 0.25, 0.75);
      expect(part.point(0.5)).toEqual(outline.point(0.5));
      expect(part.corners).toEqual(
        outline.corners.filter((v) => v > 0.25 && v < 0.75).map((v) => (v - 0.25) / 0.5),
      );
      expect(rateError(part)).toBeLessThan(0.01);
    }
  });

  test('a half circle has no corner', () => {
    expect(outlineOf(halfCircle(3, 1), ACROSS).corners).toEqual([]);
  });
});
