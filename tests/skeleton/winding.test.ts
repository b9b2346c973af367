/** Outlines that cross themselves: how often they go round, and that bounds on their field are bounds. */
import { describe, expect, test } from 'vitest';
import { kernelNamed } from '../../src/kernel/index.ts';
import { cos, sin, TAU } from '../../src/math/trig.ts';
import type { Vec2, Vec3 } from '../../src/math/vec.ts';
import { polygon } from '../../src/skeleton/polygon.ts';
import { windingOf } from '../../src/skeleton/winding.ts';
import { random } from '../fixtures/random.ts';

const square = (half: number, x = 0): Vec2[] => [
  [x - half, -half],
  [x + half, -half],
  [x + half, half],
  [x - half, half],
];
const holed = (half: number, x = 0) => [...square(half, x)].reverse();
/** One lobe forwards and one backwards, nearly as large. */
const eight: Vec2[] = [
  [-5, -2],
  [5, 2.1],
  [5, -2.1],
  [-5, 2],
];
const rounds = (turns: number, corners: number): Vec2[] =>
  Array.from({ length: corners }, (_, i) => {
    const angle = (i * turns * TAU) / corners;
    return [3 * cos(angle), 3 * sin(angle)];
  });

describe('winding', () => {
  test.each<[string, Vec2[][], number, number]>([
    ['a square', [square(2)], 1, 16],
    ['a hole', [square(2), holed(1)], 1, 12],
    ['two holes', [square(4), holed(1, -2), holed(1, 2)], 1, 56],
  ])('%s is exact', (_, loops, turns, covered) => {
    expect(windingOf(loops, covered)).toEqual({ turns, covered, isOneWay: true });
  });

  test.each<[string, Vec2[][], number, number]>([
    ['an eight', [eight], 1, 20],
    ['a star of two rounds', [rounds(2, 5)], 2, 13],
    ['two rounds on the same line', [rounds(2, 8)], 2, 36],
    ['a hole beside its outline', [square(2), holed(1, 9)], 1, 20],
    ['a hole in a hole', [square(4), holed(2), holed(1)], 1, 64 - 16 + 4],
  ])('%s: not less than it is, nor much more', (_, loops, turns, covered) => {
    const found = windingOf(loops, 1);
    expect(found.turns).toBeGreaterThanOrEqual(turns);
    expect(found.turns).toBeLessThanOrEqual(3 * turns);
    expect(found.covered).toBeGreaterThanOrEqual(covered);
    expect(found.covered).toBeLessThan(3 * covered);
  });

  test('an outline that touches itself is not taken for a simple one', () => {
    const keyhole: Vec2[] = [...square(2), [-2, -2], [-1, -1], [-1, 1], [1, 1], [1, -1], [-1, -1]];
    expect(windingOf([keyhole], 12).covered).toBeGreaterThanOrEqual(12);
  });
});

describe('bounds of plates whose outline crosses itself', () => {
  const shapes: readonly [string, Vec2[][]][] = [
    ['an eight', [eight]],
    ['two rounds', [rounds(2, 5)]],
    ['three rounds', [rounds(3, 7)]],
    ['a hole beside its outline', [square(2), holed(1, 9)]],
  ];
  test.each(shapes)('%s: below a threshold beyond the offset for it (seed 31)', (_, loops) => {
    const next = random(31);
    const anywhere = (): Vec3 => [26 * next() - 9, 14 * next() - 7, 8 * next() - 4];
    const points = Array.from({ length: 300 }, anywhere);
    for (const name of ['cauchy', 'gaussian', 'quartic', 'inverseCubic']) {
      const kernel = kernelNamed(name)!;
      const params = name === 'quartic' ? { R: 3 } : name.startsWith('inverse') ? {} : { s: 0.7 };
      const axes = { origin: [0, 0, 0], u: [1, 0, 0], v: [0, 1, 0] } as const;
      const field = polygon.bind({ type: 'polygon', ...axes, loops, weight: 1 }, kernel, params);
      for (const threshold of [0.3, 1, 3]) {
        const offset = field.offset(threshold);
        const isBeyond = (p: Vec3) =>
          [0, 1, 2].some((i) => p[i]! < field.box.min[i]! - offset || p[i]! > field.box.max[i]! + offset);
        const wrong = points.filter((p) => isBeyond(p) && Math.abs(field.value(...p)) > threshold);
        expect(wrong).toEqual([]);
      }
    }
  });

  test('a hole beside its outline reaches as far as its field, for a kernel with a support too', () => {
    const kernel = kernelNamed('quartic')!;
    const axes = { origin: [0, 0, 0], u: [1, 0, 0], v: [0, 1, 0] } as const;
    const of = (...loops: Vec2[][]) =>
      polygon.bind({ type: 'polygon', ...axes, loops, weight: 1 }, kernel, { R: 3 });
    const both = of(square(2), holed(1, 9));
    expect(both.value(9, 0, 0.5)).toBeCloseTo(-of(square(1, 9)).value(9, 0, 0.5), 13);
    expect(both.box.max[0]).toBe(10);
  });
});
