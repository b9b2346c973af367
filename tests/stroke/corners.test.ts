import { describe, expect, test } from 'vitest';
import { clean } from '../../src/stroke/clean.ts';
import { findCorners } from '../../src/stroke/corners.ts';
import { inkAt, pathOf } from '../../src/stroke/path.ts';
import { type Pen, penStroke, samplesAt } from '../fixtures/pen.ts';
import { bend, ellipse, polygon, polyline, type Shape, spiral } from '../fixtures/shapes.ts';

/** The corners of a drawn shape as places; closed shapes lose their doubled last sample. */
function cornersOf(shape: Shape, closed: boolean, pen: Pen) {
  const { samples } = clean(penStroke(shape, pen), 0.2)!;
  const path = pathOf(closed ? samples.slice(0, -1) : samples, closed);
  return findCorners(path, 1).map((s) => inkAt(path, s));
}

/** hand and device: clean, trembling, whole pixels, slow and fast reports */
const pens: readonly Omit<Pen, 'seed'>[] = [
  {},
  { jitter: 0.1 },
  { jitter: 0.1, quantise: 0.25 },
  { hz: 60, jitter: 0.1 },
  { hz: 240, jitter: 0.05, quantise: 0.25 },
];

describe.each(pens)('with pen %o', (pen) => {
  for (const seed of [1, 2, 3, 4]) {
    test(`all corners of polygons, each in its place (seed ${seed})`, () => {
      for (const sides of [3, 4, 5]) {
        const points = polygon(sides, 40);
        const found = cornersOf(polyline(points), true, { ...pen, seed });
        expect(found, `${sides} sides`).toHaveLength(sides);
        for (const [x, y] of points.slice(0, -1)) {
          const nearest = Math.min(...found.map((p) => Math.hypot(p.x - x, p.y - y)));
          expect(nearest).toBeLessThan(1.2);
        }
      }
    });

    test(`no corners on circles, ellipses and spirals (seed ${seed})`, () => {
      for (const [a, b] of [
        [60, 60],
        [20, 20],
        [6, 6],
        [60, 30],
        [60, 20],
        [30, 15],
      ] as const) {
        expect(cornersOf(ellipse(a, b), true, { ...pen, seed }), `${a} × ${b}`).toEqual([]);
      }
      expect(cornersOf(spiral(5, 50, 3), false, { ...pen, seed })).toEqual([]);
      expect(cornersOf(spiral(60, 8, 2), false, { ...pen, seed })).toEqual([]);
    });

    test(`sharp corners, rounded ones and gentle bends (seed ${seed})`, () => {
      const count = (angle: number, radius: number) =>
        cornersOf(bend(angle, radius), false, { ...pen, seed }).length;
      for (const angle of [1.2, Math.PI / 2, -2, 2.6]) expect(count(angle, 0), `${angle}`).toBe(1);
      expect(count(Math.PI / 2, 0.5)).toBe(1);
      for (const radius of [8, 15, 30]) expect(count(Math.PI / 2, radius), `radius ${radius}`).toBe(0);
      for (const angle of [0, 0.3, 0.6]) expect(count(angle, 0), `${angle}`).toBe(0);
    });
  }
});

describe('findCorners', () => {
  test('a clean pen: corners of 60°, the tips of slim ellipses, tight bends (seed 1)', () => {
    expect(cornersOf(polyline(polygon(6, 40)), true, { seed: 1 })).toHaveLength(6);
    expect(cornersOf(ellipse(30, 10), true, { seed: 1 })).toEqual([]);
    expect(cornersOf(bend(Math.PI / 2, 4), false, { seed: 1 })).toEqual([]);
    expect(cornersOf(bend(Math.PI / 2, 1), false, { seed: 1 })).toHaveLength(1);
  });

  test('shapes given by their corners alone have exactly these', () => {
    const square = pathOf(samplesAt(polygon(4, 30).slice(0, 4)), true);
    expect(findCorners(square, 1)).toEqual([...square.lengths].slice(0, 4));
    const zigzag = pathOf(
      samplesAt([
        [0, 0],
        [20, 30],
        [40, 0],
        [60, 30],
      ]),
      false,
    );
    expect(findCorners(zigzag, 1)).toEqual([...zigzag.lengths].slice(1, 3));
  });

  for (const scale of [1e-3, 1, 1e3]) {
    test(`grows with the grain: a square times ${scale}`, () => {
      const points = polygon(4, 30)
        .slice(0, 4)
        .map(([x, y]) => [x * scale, y * scale] as const);
      expect(findCorners(pathOf(samplesAt(points), true), scale)).toHaveLength(4);
    });
  }

  test('small drawings: a square of 6 mm and a narrow bar', () => {
    expect(findCorners(pathOf(samplesAt(polygon(4, 4).slice(0, 4)), true), 1)).toHaveLength(4);
    const bar = samplesAt([
      [0, 0],
      [30, 0],
      [30, 5],
      [0, 5],
    ]);
    expect(findCorners(pathOf(bar, true), 1)).toHaveLength(4);
  });

  test('dots, lines and a hundred kilometres', () => {
    expect(findCorners(pathOf(samplesAt([[1, 1]]), false), 1)).toEqual([]);
    expect(
      findCorners(
        pathOf(
          samplesAt([
            [0, 0],
            [1, 1],
          ]),
          false,
        ),
        1,
      ),
    ).toEqual([]);
    expect(
      findCorners(
        pathOf(
          samplesAt([
            [0, 0],
            [1e8, 0],
            [1e8, 1e8],
          ]),
          false,
        ),
        1,
      ),
    ).toEqual([1e8]);
  });
});
