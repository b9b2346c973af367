import { describe, expect, test } from 'vitest';
import { cross3, dot3, length3, scale3, sub3 } from '../../src/math/tuple.ts';
import type { Vec3 } from '../../src/math/vec.ts';
import { unitCircle } from '../../src/surface/circle.ts';
import { pairCurves } from '../../src/surface/pair.ts';
import { ringAt, ringNormals, ringPoints } from '../../src/surface/ring.ts';
import { halfCircle, line } from './curves.ts';

const CIRCLE = unitCircle(12);

function column(values: Float64Array, j: number): Vec3 {
  return [values[3 * j]!, values[3 * j + 1]!, values[3 * j + 2]!];
}

describe('rings', () => {
  const pair = pairCurves(halfCircle(60, -1, -5), line([10, 60], [25, 0], [15, -60]));

  test('pass through both strokes, perpendicular to the plane', () => {
    for (const u of [0.1, 0.35, 0.8]) {
      const { left, right } = pair.at(u, 1);
      const points = ringPoints(ringAt(pair, u, 1, false), 1, CIRCLE);
      expect(column(points, 0)).toEqual([...left, 0]);
      expect(column(points, 6)).toEqual([...right, 0]);
      const middle: Vec3 = [(left[0] + right[0]) / 2, (left[1] + right[1]) / 2, 0];
      const across: Vec3 = [left[1] - right[1], right[0] - left[0], 0];
      for (let j = 0; j < 12; j++) {
        const away = sub3(column(points, j), middle);
        expect(length3(away)).toBeCloseTo(length3(sub3([...left, 0], middle)), 9);
        expect(dot3(away, across)).toBeCloseTo(0, 9);
      }
    }
  });

  test('have the normals of the surface: S_u × S_v by differences', () => {
    for (const sense of [1, -1] as const) {
      for (const u of [0.1, 0.35, 0.8]) {
        const normals = ringNormals(ringAt(pair, u, 1, false), sense, CIRCLE);
        const at = (v: number): Float64Array => ringPoints(ringAt(pair, v, 1, false), sense, CIRCLE);
        const [before, here, after] = [at(u - 1e-5), at(u), at(u + 1e-5)];
        for (let j = 0; j < 12; j++) {
          const along = sub3(column(after, j), column(before, j));
          // the chord of the two neighbouring columns is parallel to the circle's tangent
          const around = sub3(column(here, (j + 1) % 12), column(here, (j + 11) % 12));
          const truth = cross3(along, around);
          const cosine = dot3(column(normals, j), scale3(truth, 1 / length3(truth)));
          expect(cosine).toBeGreaterThan(1 - 1e-8);
        }
      }
    }
  });

  test('at a pole are points; x′ is the direction in which the strokes part', () => {
    const cone = pairCurves(line([0, 50], [-20, 0]), line([0, 50], [20, 0]));
    const top = cone.at(0, 1).left[1] === 50 ? 0 : 1;
    const ring = ringAt(cone, top, top === 0 ? 1 : -1, false);
    expect(ring.radius).toBe(0);
    expect(Math.abs(ring.axis[0])).toBeCloseTo(1, 9);
    const slope = 20 / Math.hypot(20, 50);
    const normals = ringNormals(ring, 1, CIRCLE);
    for (let j = 0; j < 12; j++) expect(Math.abs(column(normals, j)[1])).toBeCloseTo(slope, 9);
  });

  test('tangent strokes: x′ is found a little further on', () => {
    const wall = (side: number) =>
      line(...Array.from({ length: 65 }, (_, i) => [(side * i * i) / 500, 64 - i] as const));
    const pair = pairCurves(wall(-1), wall(1));
    const top = pair.at(0, 1).left[1] > 60 ? 0 : 1;
    const { axis } = ringAt(pair, top, top === 0 ? 1 : -1, true);
    expect(Math.abs(axis[0])).toBeCloseTo(1, 2);
  });
});
