import { describe, expect, it } from 'vitest';
import { length3, sub3 } from '../../src/math/tuple.ts';
import type { Vec3 } from '../../src/math/vec.ts';
import { bounds } from '../../src/mesh/measure.ts';
import { distanceToBox, nearestOn } from '../../src/mesh/nearest.ts';
import { random } from '../fixtures/random.ts';
import { box, soup } from './solids.ts';

const clamp = (value: number, most: number) => Math.min(most, Math.max(0, value));

describe('the nearest point', () => {
  it.each([1, 2, 3])('of a box is the clamped one, from outside (seed %i)', (seed) => {
    const next = random(seed);
    const mesh = box(4, 5, 6);
    for (let i = 0; i < 60; i++) {
      const p: Vec3 = [12 * next() - 4, 15 * next() - 5, 18 * next() - 6];
      const expected: Vec3 = [clamp(p[0], 4), clamp(p[1], 5), clamp(p[2], 6)];
      const away = length3(sub3(p, expected));
      if (away === 0) continue;
      const found = nearestOn(mesh, p)!;
      expect(length3(sub3(found.point, expected))).toBeLessThan(1e-9);
      expect(found.distance).toBeCloseTo(away, 9);
      expect(distanceToBox(bounds(mesh), p)).toBeCloseTo(away, 9);
    }
  });

  it.each([4, 5])('of a triangle is as near as a fine search finds (seed %i)', (seed) => {
    const next = random(seed);
    const point = (): Vec3 => [10 * next(), 10 * next(), 10 * next()];
    for (let i = 0; i < 20; i++) {
      const [a, b, c, p] = [point(), point(), point(), point()];
      const found = nearestOn(soup([a, b, c], [[0, 1, 2]]), p)!;
      let least = Infinity;
      for (let u = 0; u <= 60; u++)
        for (let v = 0; u + v <= 60; v++) {
          const q = [0, 1, 2].map((k) => (u * a[k]! + v * b[k]! + (60 - u - v) * c[k]!) / 60);
          least = Math.min(least, length3(sub3(q as unknown as Vec3, p)));
        }
      expect(found.distance).toBeLessThan(least + 1e-5);
      expect(found.distance).toBeGreaterThan(least - 0.3);
    }
  });

  it('is none when nothing is near enough, or nothing is there', () => {
    expect(nearestOn(box(1, 1, 1), [5, 0, 0], 3)).toBeNull();
    expect(nearestOn(soup([], []), [0, 0, 0])).toBeNull();
  });
});
