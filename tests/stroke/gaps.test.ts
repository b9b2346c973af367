import { describe, expect, test } from 'vitest';
import { fillGaps } from '../../src/stroke/gaps.ts';

const arc = (count: number, angle: number, closed = false) =>
  Array.from({ length: count }, (_, i) => {
    const a = (angle * i) / (closed ? count : count - 1);
    return { x: 50 * Math.cos(a), y: 50 * Math.sin(a), pressure: i / count };
  });

describe('fillGaps', () => {
  test('keeps every given point, in order, and leaves none further apart than the spacing', () => {
    const points = arc(18, Math.PI);
    const filled = fillGaps(points, false, 1);
    expect(filled.filter((p) => points.includes(p as never))).toEqual(points);
    for (let i = 1; i < filled.length; i++) {
      const [a, b] = [filled[i - 1]!, filled[i]!];
      expect(Math.hypot(b.x - a.x, b.y - a.y)).toBeLessThan(1.1);
    }
  });

  test.each([9, 18, 34])('a half circle of %i samples becomes round, its ends too', (count) => {
    const chord = 50 * (1 - Math.cos(Math.PI / 2 / (count - 1)));
    for (const p of fillGaps(arc(count, Math.PI), false, 0.5)) {
      expect(Math.abs(Math.hypot(p.x, p.y) - 50)).toBeLessThan(0.06 * chord);
    }
  });

  test('a closed circle of eight samples too', () => {
    const chord = 50 * (1 - Math.cos(Math.PI / 8));
    for (const p of fillGaps(arc(8, 2 * Math.PI, true), true, 0.5)) {
      expect(Math.abs(Math.hypot(p.x, p.y) - 50)).toBeLessThan(0.12 * chord);
    }
  });

  test('lines stay lines, however uneven; dense and tiny strokes stay as they are', () => {
    const line = [0, 1, 20, 21, 22, 80].map((x) => ({ x, y: 3 * x, pressure: 0.5 }));
    for (const p of fillGaps(line, false, 1)) expect(p.y).toBeCloseTo(3 * p.x, 9);
    expect(fillGaps(line, false, 1000)).toEqual(line);
    expect(fillGaps(line.slice(0, 2), false, 1)).toEqual(line.slice(0, 2));
  });

  test('back and forth on one line makes no loop', () => {
    const there = [0, 10, 0, 10].map((x) => ({ x, y: 0, pressure: 0.5 }));
    for (const p of fillGaps(there, false, 1)) {
      expect(p.y).toBe(0);
      expect(p.x).toBeGreaterThan(-2);
      expect(p.x).toBeLessThan(12);
    }
  });
});
