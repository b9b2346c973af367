import { describe, expect, it } from 'vitest';
import { triangulate } from '../../src/math/triangulate.ts';
import { cross2, dot2, sub2 } from '../../src/math/tuple.ts';
import type { Vec2 } from '../../src/math/vec.ts';
import { areaOf, blob, plate, SHAPES } from '../fixtures/silhouettes.ts';

const cornersOf = ({ points, triangles }: ReturnType<typeof triangulate>, t: number) =>
  [0, 1, 2].map((i) => points[triangles[3 * t + i]!]!) as [Vec2, Vec2, Vec2];

function areaOfTriangles(found: ReturnType<typeof triangulate>): number {
  let sum = 0;
  for (let t = 0; t < found.triangles.length / 3; t++) {
    const [a, b, c] = cornersOf(found, t);
    const area = cross2(sub2(b, a), sub2(c, a)) / 2;
    expect(area).toBeGreaterThan(0);
    sum += area;
  }
  return sum;
}

/** Above 0 where d is in the circle through a, b and c. */
function inCircle(a: Vec2, b: Vec2, c: Vec2, d: Vec2): number {
  const [p, q, r] = [sub2(a, d), sub2(b, d), sub2(c, d)];
  return dot2(p, p) * cross2(q, r) + dot2(q, q) * cross2(r, p) + dot2(r, r) * cross2(p, q);
}

describe('triangulate', () => {
  it.each(Object.entries(SHAPES))('%s: fills the region, and each inner edge is Delaunay', (_, loops) => {
    const found = triangulate(loops);
    expect(found.isDelaunay).toBe(true);
    expect(areaOfTriangles(found)).toBeCloseTo(areaOf(loops), 6);
    for (let k = 0; k < found.across.length; k++) {
      const other = found.across[k]!;
      if (other < 0) continue;
      const own = Math.floor(k / 3);
      expect([0, 1, 2].some((i) => found.across[3 * other + i] === own)).toBe(true);
      const [a, b, c] = cornersOf(found, own);
      const size = dot2(sub2(b, a), sub2(b, a));
      for (const d of cornersOf(found, other))
        expect(inCircle(a, b, c, d)).toBeLessThan(1e-6 * size * size + 1e-6);
    }
  });

  it.each([0, 1, 2, 5])('has n + 2 h − 2 triangles with %i holes', (holes) => {
    const loops = holes === 0 ? [blob(1)] : plate(holes);
    const places = loops.reduce((sum, loop) => sum + loop.length, 0);
    expect(triangulate(loops).triangles.length / 3).toBe(places + 2 * holes - 2);
  });

  it('takes places that are nearly the same as one', () => {
    const loop = blob(2).flatMap(([x, y]): Vec2[] => [
      [x, y],
      [x + 1e-13, y - 1e-13],
    ]);
    const found = triangulate([loop]);
    expect(found.isDelaunay).toBe(true);
    expect(areaOfTriangles(found)).toBeCloseTo(areaOf([blob(2)]), 6);
  });

  it.each([
    ['nothing', []],
    ['one place', [[[1, 2]]]],
    [
      'a line',
      [
        [
          [0, 0],
          [1, 1],
          [2, 2],
          [3, 3],
        ],
      ],
    ],
    [
      'one place many times',
      [
        [
          [1, 2],
          [1, 2],
          [1, 2],
          [1, 2],
        ],
      ],
    ],
  ] as [string, Vec2[][]][])('is empty for %s', (_, loops) => {
    expect(triangulate(loops).triangles.length).toBe(0);
  });

  it('gives triangles all the same where an outline crosses itself, and says so', () => {
    const eight: Vec2[] = [
      [0, 0],
      [10, 10],
      [10, 0],
      [0, 10],
    ];
    const found = triangulate([eight]);
    expect(found.isDelaunay).toBe(false);
  });
});
