import { describe, expect, test } from 'vitest';
import { pathOf } from '../../src/stroke/path.ts';
import { resample } from '../../src/stroke/resample.ts';
import { normal, random } from '../fixtures/random.ts';

const circle = (count: number, radius: number, seed: number) => {
  const next = random(seed);
  const angles = Array.from({ length: count }, () => 2 * Math.PI * next()).sort((a, b) => a - b);
  return angles.map((a) => ({ x: radius * Math.cos(a), y: radius * Math.sin(a), pressure: a / 7 }));
};

describe('resample', () => {
  test.each([2, 3, 10, 1000])('%i points of an uneven line are even, its ends exact (seed 4)', (count) => {
    const next = random(4);
    const xs = [0, 30, ...Array.from({ length: 40 }, () => 30 * next())].sort((a, b) => a - b);
    const points = xs.map((x) => ({ x, y: 2 * x, pressure: x / 30 }));
    const even = resample(pathOf(points, false), count);
    expect(even).toHaveLength(count);
    expect(even[0]).toEqual(points[0]);
    expect(even.at(-1)).toEqual(points.at(-1));
    even.forEach((p, i) => {
      const x = (30 * i) / (count - 1);
      expect(p.x).toBeCloseTo(x, 9);
      expect(p.y).toBeCloseTo(2 * x, 9);
      // the mean of a linear pressure is its middle value
      expect(p.pressure).toBeCloseTo(x / 30, 9);
    });
  });

  test('a closed path: even all around, first point where it began, inwards by no more than step²/24·κ (seed 5)', () => {
    const points = circle(4000, 20, 5);
    const even = resample(pathOf(points, true), 100);
    const step = (2 * Math.PI * 20) / 100;
    const inward = (step * step) / 24 / 20;
    even.forEach((p, i) => {
      const q = even[(i + 1) % 100]!;
      expect(Math.hypot(q.x - p.x, q.y - p.y)).toBeCloseTo(step, 1);
      expect(Math.abs(20 - Math.hypot(p.x, p.y) - inward)).toBeLessThan(1e-3);
    });
    expect(Math.hypot(even[0]!.x - points[0]!.x, even[0]!.y - points[0]!.y)).toBeLessThan(0.01);
  });

  test('where samples are denser than the steps all of them count: noise falls below a half (seed 6)', () => {
    const n = normal(6);
    // along x only a little, so that noise does not lengthen the path
    const points = Array.from({ length: 10_001 }, (_, i) => ({ x: i / 10, y: 0.005 * n(), pressure: 0.5 }));
    const even = resample(pathOf(points, false), 1001).slice(1, -1);
    const deviation = Math.sqrt(even.reduce((sum, p) => sum + p.y * p.y, 0) / even.length);
    expect(deviation / 0.005).toBeLessThan(0.4);
    console.log(`resample: noise gain ${(deviation / 0.005).toFixed(2)} at ten samples a step`);
  });
});
