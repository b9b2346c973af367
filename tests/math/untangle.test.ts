import { describe, expect, it } from 'vitest';
import { cross2 } from '../../src/math/tuple.ts';
import { crossingsOf, untangle } from '../../src/math/untangle.ts';
import type { Vec2 } from '../../src/math/vec.ts';
import { random } from '../fixtures/random.ts';
import { disc, plate, shifted } from '../fixtures/silhouettes.ts';

type Loop = readonly Vec2[];

/** mm², above 0 counter-clockwise */
const area = (loop: Loop) => loop.reduce((sum, p, i) => sum + cross2(loop.at(i - 1)!, p) / 2, 0);
const whole = (loops: readonly Loop[]) => loops.reduce((sum, loop) => sum + area(loop), 0);

function winding(loop: Loop, [x, y]: Vec2): number {
  let turn = 0;
  loop.forEach(([bx, by], i) => {
    const [ax, ay] = loop.at(i - 1)!;
    turn += Math.atan2((ax - x) * (by - y) - (ay - y) * (bx - x), (ax - x) * (bx - x) + (ay - y) * (by - y));
  });
  return Math.round(turn / (2 * Math.PI));
}

describe('crossingsOf', () => {
  it('finds the crossing of a figure eight, and where it is', () => {
    const [found, ...more] = crossingsOf([
      [
        [0, 0],
        [10, 10],
        [10, 0],
        [0, 10],
      ],
    ]);
    expect(more).toEqual([]);
    expect(found!.at).toEqual([5, 5]);
  });

  it('finds none in loops that do not cross', () => {
    expect(crossingsOf(plate(3))).toEqual([]);
  });

  it('finds two where two discs overlap', () => {
    expect(crossingsOf([disc(10), shifted(disc(10), [9.3, 0.1])]).length).toBe(2);
  });
});

describe('untangle', () => {
  it('leaves loops that do not cross', () => {
    const [outer, ...holes] = plate(2);
    expect(untangle(outer!, holes)).toEqual([outer, ...holes]);
  });

  it('makes two of a figure eight, both counter-clockwise', () => {
    const loops = untangle([
      [0, 0],
      [10, 10],
      [10, 0],
      [0, 10],
    ]);
    expect(loops.map(area)).toEqual([25, 25]);
  });

  it('fills the little loop at a bend', () => {
    const loops = untangle([
      [0, 0],
      [10, 0],
      [10, 8],
      [6, 8],
      [6, -2],
      [8, -2],
      [8, 10],
      [0, 10],
    ]);
    expect(crossingsOf(loops)).toEqual([]);
    expect(loops.length).toBeGreaterThan(0);
  });

  it('cuts off what of a hole is outside', () => {
    const loops = untangle(
      [
        [0, 0],
        [10, 0],
        [10, 10],
        [0, 10],
      ],
      [
        [
          [5, 4],
          [15, 4],
          [15, 6],
          [5, 6],
        ],
      ],
    );
    expect(whole(loops)).toBeCloseTo(90, 9);
    expect(loops.length).toBe(1);
  });

  it.each(Array.from({ length: 40 }, (_, i) => i + 1))(
    'random scribble (seed %i): no crossing, and inside what was gone round',
    (seed) => {
      const next = random(seed);
      const scribble = Array.from(
        { length: 5 + Math.floor(20 * next()) },
        (): Vec2 => [40 * next(), 40 * next()],
      );
      const loops = untangle(scribble);
      // corners where loops touch are no crossings
      const through = crossingsOf(loops).filter(({ along }) => along.every((t) => t > 1e-6 && t < 1 - 1e-6));
      expect(through).toEqual([]);
      for (let i = 0; i < 200; i++) {
        const p: Vec2 = [40 * next(), 40 * next()];
        const near = [scribble, ...loops].some((loop) =>
          loop.some((b, k) => distance(p, loop.at(k - 1)!, b) < 1e-3),
        );
        if (near) continue;
        const turns = loops.reduce((sum, loop) => sum + winding(loop, p), 0);
        expect(turns).toBe(winding(scribble, p) === 0 ? 0 : 1);
      }
    },
  );
});

function distance([x, y]: Vec2, [ax, ay]: Vec2, [bx, by]: Vec2): number {
  const [dx, dy] = [bx - ax, by - ay];
  const t = Math.min(Math.max(((x - ax) * dx + (y - ay) * dy) / (dx * dx + dy * dy || 1), 0), 1);
  return Math.hypot(x - ax - t * dx, y - ay - t * dy);
}
