import { describe, expect, test } from 'vitest';
import { cross3, dot3, length3, scale3, sub3 } from '../../src/math/tuple.ts';
import type { Vec2, Vec3 } from '../../src/math/vec.ts';
import { pairCurves } from '../../src/surface/pair.ts';
import { ringAt } from '../../src/surface/ring.ts';
import { normalAt, place, placed } from '../../src/surface/stand.ts';
import { halfCircle, line } from './curves.ts';

const pair = pairCurves(halfCircle(60, -1, -5), line([10, 60], [40, -60]));
const outline = (v: number): Vec2 => [2 * v - 1 + Math.sin(7 * v), Math.sin(3 * v)];
const rate = (v: number): Vec2 => [2 + 7 * Math.cos(7 * v), 3 * Math.cos(3 * v)];
const at = (u: number, v: number): Vec3 => place(ringAt(pair, u, 1, false), outline(v));

describe('an outline at one u', () => {
  test('has its ends on the strokes to the last bit, and its y out of the plane in half chords', () => {
    const ring = ringAt(pair, 0.3, 1, false);
    expect(place(ring, [-1, 0])).toEqual([...ring.left, 0]);
    expect(place(ring, [1, 0])).toEqual([...ring.right, 0]);
    const top = place(ring, [0, 1]);
    expect([
      ...placed(ring, [
        [-1, 0],
        [0, 1],
      ]),
    ]).toEqual([...ring.left, 0, ...top]);
    expect(top[2]).toBeCloseTo(length3(sub3([...ring.left, 0], [...ring.right, 0])) / 2, 12);
    expect(top[0]).toBeCloseTo(ring.centre[0], 12);
  });

  test('its normals are those of differences', () => {
    const h = 1e-5;
    for (const u of [0.1, 0.35, 0.8]) {
      for (const v of [0.05, 0.3, 0.6, 0.9]) {
        const along = sub3(at(u + h, v), at(u - h, v));
        const across = sub3(at(u, v + h), at(u, v - h));
        const normal = cross3(along, across);
        const unit = scale3(normal, 1 / length3(normal));
        expect(dot3(unit, normalAt(ringAt(pair, u, 1, false), outline(v), rate(v)))).toBeCloseTo(1, 6);
      }
    }
  });

  test('tips have the limit of the normals beside them', () => {
    const cone = pairCurves(line([0, 50], [-20, 0]), line([0, 50], [20, 0]));
    const tip = cone.stops[0]!.pole ? 0 : 1;
    const side = tip === 0 ? 1 : -1;
    for (const v of [0.1, 0.5, 0.8]) {
      const beside = normalAt(ringAt(cone, tip + side * 0.01, 1, false), outline(v), rate(v));
      expect(dot3(normalAt(ringAt(cone, tip, side, true), outline(v), rate(v)), beside)).toBeCloseTo(1, 9);
    }
  });

  test('where nothing moves a normal is finite', () => {
    const still = { ...ringAt(pair, 0.5, 1, false), dCentre: [0, 0], dHalf: [0, 0] } as const;
    for (const d of [
      [1, 0],
      [0, 0],
    ] as const)
      expect(length3(normalAt(still, [0, 1], d))).toBeCloseTo(1, 12);
  });
});
