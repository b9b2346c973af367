import { describe, expect, test } from 'vitest';
import { dot3, length3, sub3 } from '../../src/math/tuple.ts';
import type { Vec3 } from '../../src/math/vec.ts';
import type { Row } from '../../src/mesh/grid.ts';
import { disc, dome, outsideIn } from '../../src/surface/caps.ts';
import { unitCircle } from '../../src/surface/circle.ts';

const RADIAL = unitCircle(8).map(([x, y]): Vec3 => [x, y, 0]);

function columns({ points, normals }: Row): { point: Vec3; normal: Vec3 }[] {
  const pick = (from: Float64Array, j: number): Vec3 => [from[3 * j]!, from[3 * j + 1]!, from[3 * j + 2]!];
  return RADIAL.map((_, j) => ({ point: pick(points, j), normal: pick(normals, j) }));
}

describe('domes', () => {
  test('are spheres that touch the tube at its end', () => {
    for (const flare of [-0.5, -0.1, 0, 0.3]) {
      const end = { centre: [0, 0, 5], outward: [0, 0, 1], radius: 2, flare } as const;
      const rows = dome(end, RADIAL, 6);
      const size = 2 * Math.hypot(1, flare);
      const middle: Vec3 = [0, 0, 5 + 2 * flare];
      for (const { point, normal } of rows.flatMap(columns)) {
        expect(length3(sub3(point, middle))).toBeCloseTo(size, 12);
        expect(dot3(sub3(point, middle), normal)).toBeCloseTo(size, 12);
      }
      // the rim, one step before the first row, lies on the sphere with the tube's own normal
      expect(Math.hypot(2, 5 - middle[2])).toBeCloseTo(size, 12);
      expect(rows.at(-1)!.pole).toBe(true);
    }
  });
});

describe('discs', () => {
  test('repeat the rim and end in their centre, with one normal', () => {
    const rim: Row = {
      points: Float64Array.from(RADIAL.flat()),
      normals: new Float64Array(24),
      joined: true,
    };
    const [first, last] = disc(rim, [0, 0, 0], [0, 0, 1]);
    expect(first!.points).toBe(rim.points);
    expect([first!.joined, last!.joined, last!.pole]).toEqual([false, true, true]);
    for (const { normal } of [first!, last!].flatMap(columns)) expect(normal).toEqual([0, 0, 1]);
  });
});

test('turned round, rows keep their neighbours', () => {
  const row = (z: number, joined: boolean): Row => ({
    points: Float64Array.of(0, 0, z),
    normals: new Float64Array(3),
    joined,
  });
  const { cap, joinsSurface } = outsideIn([row(1, false), row(2, true), row(3, true)]);
  expect(cap.map(({ points }) => points[2])).toEqual([3, 2, 1]);
  expect(cap.slice(1).map(({ joined }) => joined)).toEqual([true, true]);
  expect(joinsSurface).toBe(false);
});
