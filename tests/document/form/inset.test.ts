import { describe, expect, test } from 'vitest';
import { inset, rimsOf } from '../../../src/document/form/inset.ts';
import { crossingsOf } from '../../../src/math/untangle.ts';
import { along, distanceTo, isInside } from '../../../src/skeleton/medial/outline.ts';
import { random } from '../../fixtures/random.ts';
import { disc, polar, SHAPES } from '../../fixtures/silhouettes.ts';

const all = (rims: ReturnType<typeof rimsOf>, by: number) => rims.map((loop) => loop.map(() => by));

describe('insets', () => {
  test('of a disc are discs, and so are the circles that touch it', () => {
    const rims = rimsOf([disc(30)]);
    for (const { inside, outside } of rims[0]!) {
      expect(Math.abs(inside / 30 - 1)).toBeLessThan(1e-6);
      expect(outside).toBe(Infinity);
    }
    for (const by of [6, -6])
      for (const p of inset(rims, all(rims, by))[0]!) expect(Math.hypot(...p)).toBeCloseTo(30 - by, 6);
  });

  test('no place goes beyond the middle of what is narrow', () => {
    const loop = along(SHAPES['thin bar']!, 1);
    const moved = inset(rimsOf([loop]), [loop.map(() => 50)]);
    for (const p of moved[0]!) expect(isInside(p, [loop])).toBe(true);
    expect(crossingsOf(moved)).toEqual([]);
  });

  test.each(Array.from({ length: 20 }, (_, seed) => seed))(
    'never cross, however much is asked for, seed %d',
    (seed) => {
      const next = random(seed);
      const waves = Array.from({ length: 6 }, (_, k) => [k + 2, 0.5 * next(), next()] as const);
      const loop = polar(
        (t) => waves.reduce((r, [k, a, p]) => r + 6 * a * Math.cos(2 * Math.PI * (k * t + p)), 30),
        240,
      );
      const rims = rimsOf([loop]);
      const moved = inset(rims, [loop.map(() => 30 * (next() - 0.4))]);
      expect(crossingsOf(moved)).toEqual([]);
      const even = inset(rims, [loop.map(() => 4)]);
      for (const p of even[0]!) {
        expect(isInside(p, [loop])).toBe(true);
        expect(distanceTo(p, [loop])).toBeLessThan(4 + 1e-9);
      }
    },
  );
});
