/** Against winding numbers of fine polygons: what is gone round an odd number of times once, all else not at all. */
import fc from 'fast-check';
import { describe, expect, test } from 'vitest';
import { cross2, distance2, length2, sub2 } from '../../src/math/tuple.ts';
import type { Vec2 } from '../../src/math/vec.ts';
import { polylineCurve } from '../../src/stroke/arcLength.ts';
import { joined } from '../../src/surface/joined.ts';
import { type Outline, outlineOf, roundHalf } from '../../src/surface/outline.ts';
import { uncrossed } from '../../src/surface/uncrossed.ts';
import { smoothStroke } from './curves.ts';
import { bent, comb, mushroom, raisedBy, roof, wave } from './outlines.ts';
import { expectOdd, grid, polygonOf } from './winding.ts';

/** front and back as they were drawn, one after the other */
const loopOf = (front: Outline, back: Outline): Vec2[] => [...polygonOf(front), ...polygonOf(back).reverse()];

const loops = bent([-1, 0], [0.6, 0.9], [0.6, 1.7], [-0.6, 1.7], [-0.6, 0.9], [1, 0]);
const kink = bent([-1, 0], [0.5, 0.1], [0.5, 0.8], [-0.2, 0.8], [-0.2, -0.6], [1, 0]);

describe.each([
  ['front below back', raisedBy(roundHalf, 0.3), raisedBy(roundHalf, 0.8)],
  ['an S and its mirror image', wave(0.5, 2), raisedBy(wave(0.5, 2), -1)],
  ['waves', wave(0.5, 5), wave(0.6, 2)],
  ['a comb and a roof', comb, roof],
  ['an overhanging front through its back', mushroom, wave(1.2, 3)],
  ['a loop outside', loops, raisedBy(roundHalf, -0.5)],
  ['a loop inside', kink, raisedBy(roundHalf, -1)],
  ['two loops through each other', loops, kink],
] as const)('%s', (_, front, back) => {
  test('goes round what was enclosed an odd number of times', () => {
    const found = joined(front, back);
    expectOdd(found, loopOf(front, back), grid);
    expect(found.point(0)).toEqual([-1, 0]);
    expect(found.point(0.5)).toEqual([1, 0]);
  });

  test('is one line with ascending corners, its derivatives are its own', () => {
    const { corners, point, derivative } = joined(front, back);
    for (const [i, v] of corners.entries()) expect(v - (corners[i - 1] ?? -1)).toBeGreaterThan(1e-7);
    for (let i = 1; i <= 5000; i++)
      expect(distance2(point(i / 5000), point((i - 1) / 5000))).toBeLessThan(0.02);
    for (let i = 0; i < 500; i++) {
      const v = (i + 0.317) / 500;
      const h = 1e-6;
      if (corners.some((corner) => Math.abs(corner - v) < 2 * h)) continue;
      const [a, b] = [point(v - h), point(v + h)];
      const [dx, dy] = derivative(v, 1);
      expect(Math.hypot((b[0] - a[0]) / (2 * h) - dx, (b[1] - a[1]) / (2 * h) - dy)).toBeLessThan(
        3e-3 * (1 + length2([dx, dy])),
      );
    }
  });

  test('keeps off itself', () => {
    // v of corners may be those of chords but for rounding
    const all = polygonOf(joined(front, back));
    const polygon = all.filter((p, i) => distance2(p, all.at(i - 1)!) > 1e-9);
    const isLeft = (a: Vec2, b: Vec2, p: Vec2): boolean => cross2(sub2(b, a), sub2(p, a)) > 1e-12;
    const cut = polygon.flatMap((a, i) => {
      const b = polygon[(i + 1) % polygon.length]!;
      const others = polygon.slice(i + 2, i === 0 ? -1 : undefined);
      return others.filter((c, k) => {
        const d = polygon[(i + 3 + k) % polygon.length]!;
        return isLeft(a, b, c) !== isLeft(a, b, d) && isLeft(c, d, a) !== isLeft(c, d, b);
      });
    });
    expect(cut).toEqual([]);
  });
});

test('what does not cross itself stays as it is', () => {
  for (const front of [roundHalf, roof, comb, mushroom]) {
    const outline = joined(front, 'mirror');
    expect(uncrossed(outline)).toBe(outline);
  }
});

// doubles by lot are nearly all next to nothing
const evenly = (most: number) => fc.integer({ min: -10_000, max: 10_000 }).map((i) => (most * i) / 10_000);
const x = evenly(50);
const zigzag = fc.array(fc.tuple(x, x), { minLength: 3, maxLength: 7 }).map((points) =>
  polylineCurve(
    points.map(([p, q], i): Vec2 => [p + 0.0137 * i * i, q]),
    false,
  ),
);
const drawn = fc
  .oneof(smoothStroke(30), zigzag)
  .map((curve) => outlineOf(curve, { reversed: false, across: true }));
const places = fc.array(fc.tuple(evenly(2), evenly(2)), {
  minLength: 60,
  maxLength: 60,
});

test('random fronts and backs (seed 91)', () => {
  fc.assert(
    fc.property(drawn, drawn, places, (front, back, at) => {
      expectOdd(joined(front, back), loopOf(front, back), at);
    }),
    { seed: 91, numRuns: Number(process.env.RUNS ?? 40) },
  );
});
