import { describe, expect, test } from 'vitest';
import { distance2 } from '../../src/math/tuple.ts';
import { align, type Sides } from '../../src/surface/align.ts';
import { circle, halfCircle, line, polygon, reversed } from './curves.ts';

/** The distances between the sides at even u. */
function chords({ left, right }: Sides): number[] {
  return Array.from({ length: 9 }, (_, i) => distance2(left.point(i / 8), right.point(i / 8)));
}

describe('open strokes', () => {
  test('run side by side, left on the left, however they were drawn', () => {
    const [a, b] = [line([-10, 0], [-10, 50]), line([10, 0], [10, 50])];
    for (const [p, q] of [
      [a, b],
      [b, a],
      [a, reversed(b)],
      [reversed(a), b],
      [reversed(b), reversed(a)],
    ] as const) {
      const sides = align(p, q);
      for (const chord of chords(sides)) expect(chord).toBeCloseTo(20, 9);
      const up = sides.left.point(1)[1] > sides.left.point(0)[1];
      expect(sides.left.point(0)[0]).toBe(up ? -10 : 10);
    }
  });

  test('the legs of a right angle begin where they meet', () => {
    const [a, b] = [line([0, 0], [30, 0]), line([0, 30], [0, 0])];
    expect(chords(align(a, b))[0]).toBe(0);
    expect(chords(align(reversed(a), b)).at(-1)).toBe(0);
  });

  test('half circles meet at both ends', () => {
    const found = chords(align(halfCircle(50, 1), reversed(halfCircle(50, -1))));
    expect(found[0]).toBeCloseTo(0, 9);
    expect(found[8]).toBeCloseTo(0, 9);
    expect(found[4]).toBeCloseTo(100, 9);
  });
});

describe('closed strokes', () => {
  test('side by side are mirrored: chords of a torus of revolution', () => {
    for (const start of [0, 0.4, 2, 4.5]) {
      for (const sense of [1, -1] as const) {
        const { left, right } = align(circle(-30, 0, 10, 1, 1), circle(30, 0, 10, sense, start));
        for (let u = 0; u < 1; u += 0.1) {
          const [p, q] = [left.point(u), right.point(u)];
          expect(p[0] + q[0]).toBeCloseTo(0, 2);
          expect(p[1]).toBeCloseTo(q[1], 2);
        }
      }
    }
  });

  test('nested run alike: chords of a ring', () => {
    for (const start of [0, 0.4, 2, 4.5]) {
      for (const sense of [1, -1] as const) {
        const sides = align(circle(0, 0, 10, 1, 1), circle(0, 0, 30, sense, start));
        for (const chord of chords(sides)) expect(chord).toBeCloseTo(20, 3);
      }
    }
  });

  test('with corners begin in a pair of them', () => {
    const inner = polygon([-10, -10], [10, -10], [10, 10], [-10, 10]);
    const { left, right } = align(inner, polygon([21, 19], [-20, 20], [-20, -20], [20, -20]));
    expect(left.corners[0]).toBe(0);
    expect(right.corners[0]).toBe(0);
    expect(Math.sign(left.point(0)[0])).toBe(Math.sign(right.point(0)[0]));
    expect(Math.sign(left.point(0)[1])).toBe(Math.sign(right.point(0)[1]));
  });

  test('that cross begin in a crossing', () => {
    const sides = align(circle(-8, 0, 10), circle(8, 1, 10, -1, 0.7));
    expect(sides).toMatchObject({ closed: true, pinched: true });
    expect(chords(sides)[0]).toBeLessThan(1e-6);
  });
});

test('a closed stroke beside an open one is opened where it is nearest to the open one’s start', () => {
  for (const [a, b] of [
    [circle(-20, 0, 10), line([20, 0], [20, 60])],
    [line([20, 0], [20, 60]), circle(-20, 0, 10)],
  ] as const) {
    const { left, right, closed } = align(a, b);
    expect(closed).toBe(false);
    const opened = left.length > 61 ? left : right;
    for (const u of [0, 1]) expect(opened.point(u)[0]).toBeCloseTo(-10, 6);
  }
});
