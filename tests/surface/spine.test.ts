import fc from 'fast-check';
import { describe, expect, test } from 'vitest';
import { add3, cross3, dot3, length3, scale3, sub3 } from '../../src/math/tuple.ts';
import type { Vec3 } from '../../src/math/vec.ts';
import { pairCurves } from '../../src/surface/pair.ts';
import type { Spine } from '../../src/surface/sheet.ts';
import { pairSpine, strokeSpine } from '../../src/surface/spine.ts';
import { bentStroke, circle, halfCircle, line, polygon, smoothStroke } from './curves.ts';

/** Rate and spin against differences of centres and normals. */
function agrees(spine: Spine, us: readonly number[], h = 1e-5): void {
  for (const u of us) {
    const here = spine.at(u, 1);
    const [before, after] = [spine.at(u - h, 1), spine.at(u + h, 1)];
    const rate = scale3(sub3(after.centre, before.centre), 1 / (2 * h));
    const turning = scale3(sub3(after.normal, before.normal), 1 / (2 * h));
    expect(length3(sub3(rate, here.rate))).toBeLessThan(1e-4 * (1 + length3(rate)));
    expect(length3(sub3(turning, cross3(here.spin, here.normal)))).toBeLessThan(
      1e-3 * (1 + length3(turning)),
    );
    expect(length3(here.normal)).toBeCloseTo(1, 12);
  }
}

describe('between two strokes', () => {
  const vase = pairCurves(halfCircle(60, -1, -5), line([10, 60], [40, -60]));

  test('sections hold their chord and the plane’s normal, and move as their derivatives say', () => {
    const spine = pairSpine(vase);
    for (const u of [0, 0.3, 0.9, 1]) {
      const { left, right } = vase.at(u, 1);
      const { centre, normal } = spine.at(u, 1);
      const chord: Vec3 = [right[0] - left[0], right[1] - left[1], 0];
      expect(dot3(normal, chord)).toBeCloseTo(0, 9);
      expect(normal[2]).toBe(0);
      const middle = scale3(add3([...left, 0], [...right, 0]), 0.5);
      expect(length3(sub3(centre, middle))).toBeLessThan(1e-12);
    }
    agrees(spine, [0.1, 0.4, 0.77]);
    expect([spine.stops[0], spine.stops.at(-1), spine.closed]).toEqual([0, 1, false]);
  });

  test('their normals point along u in every lobe, also where the strokes changed sides', () => {
    const spine = pairSpine(pairCurves(line([-20, 50], [25, -50]), line([20, 50], [-20, -50])));
    for (const u of [0, 0.2, 0.7, 1]) {
      const { normal, rate } = spine.at(u, 1);
      expect(dot3(normal, rate)).toBeGreaterThan(0);
    }
  });

  test('at tips they have the limit of what is beside them', () => {
    const tips = [
      pairCurves(halfCircle(50, -1), halfCircle(50, 1)),
      pairCurves(line([0, 50], [-20, 0]), line([0, 50], [25, -3])),
    ];
    for (const spine of tips.map(pairSpine)) {
      for (const [u, inside] of [
        [0, 1e-3],
        [1, 1 - 1e-3],
      ] as const) {
        for (const side of [-1, 1] as const) {
          const [tip, near] = [spine.at(u, side), spine.at(inside, 1)];
          expect(dot3(tip.normal, near.normal)).toBeGreaterThan(0.999);
          expect(length3(sub3(tip.spin, near.spin))).toBeLessThan(0.1 * (1 + length3(near.spin)));
        }
      }
    }
  });

  test('closed pairs go round: the end is the start', () => {
    const spine = pairSpine(pairCurves(circle(0, 0, 10), circle(0, 0, 30, -1, 1)));
    const [start, end] = [spine.at(0, 1), spine.at(1, -1)];
    expect(spine.closed).toBe(true);
    expect(length3(sub3(start.centre, end.centre))).toBeLessThan(1e-6);
    expect(dot3(start.normal, end.normal)).toBeCloseTo(1, 6);
    agrees(spine, [0.2, 0.6]);
  });
});

describe('along one stroke', () => {
  test('sections are across it and turn as it does', () => {
    const spine = strokeSpine(halfCircle(50, 1));
    agrees(spine, [0.1, 0.5, 0.8]);
    for (const u of [0, 0.5, 1]) {
      const { normal, rate, spin } = spine.at(u, 1);
      expect(length3(sub3(rate, scale3(normal, Math.PI * 50)))).toBeLessThan(1e-3);
      expect(spin[2]).toBeCloseTo(-Math.PI, 2);
    }
  });

  test('corners are stops with a station on either side; closed strokes begin at one', () => {
    const square = strokeSpine(polygon([0, 0], [60, 0], [60, 60], [0, 60]));
    expect(square.stops).toEqual([0, 0.25, 0.5, 0.75, 1].map((u) => expect.closeTo(u, 9)));
    expect(dot3(square.at(0.25, -1).normal, square.at(0.25, 1).normal)).toBeCloseTo(0, 9);
    expect(square.at(0.25, -1).centre).toEqual(square.at(0.25, 1).centre);
  });
});

test('whatever is drawn, stations are finite (seed 61)', () => {
  const stroke = fc.oneof(smoothStroke(30), bentStroke(false), bentStroke(true), fc.constant(line([3, 4])));
  fc.assert(
    fc.property(stroke, stroke, (a, b) => {
      const pair = pairCurves(a, b);
      // two dots are no pair
      const spines = pair.length > 0 ? [strokeSpine(a), pairSpine(pair)] : [strokeSpine(a)];
      for (const spine of spines) {
        for (const u of [...spine.stops, 1e-9, 0.123, 0.5]) {
          for (const side of [-1, 1] as const) {
            const { centre, rate, normal, spin } = spine.at(u, side);
            expect([...centre, ...rate, ...normal, ...spin].every(Number.isFinite)).toBe(true);
            expect(length3(normal)).toBeCloseTo(1, 9);
          }
        }
      }
    }),
    { seed: 61, numRuns: 60 },
  );
});
