import fc from 'fast-check';
import { describe, expect, test } from 'vitest';
import { cross2, length2 } from '../../src/math/tuple.ts';
import type { Vec2 } from '../../src/math/vec.ts';
import { topology } from '../../src/mesh/check.ts';
import { evenColumns, gridMesh, type Row } from '../../src/mesh/grid.ts';
import { area, volume } from '../../src/mesh/measure.ts';
import type { Mesh } from '../../src/mesh/mesh.ts';
import { columnsOf } from '../../src/surface/columns.ts';
import { joined, round } from '../../src/surface/joined.ts';
import { centroid, lidOf, lidRows } from '../../src/surface/lid.ts';
import { FLAT, normalAgreement } from './curves.ts';
import { comb, roof } from './outlines.ts';

/** A wall of height 1 on the polygon, shut at both ends by its lid: clockwise polygons, as outlines are, face outward flipped. */
function prism(points: readonly Vec2[]): Mesh {
  const ring = [...points, points[0]!];
  const lid = lidOf(ring);
  const at = (z: number) => (p: Vec2) => [p[0], p[1], z] as const;
  const row = (z: number): Row => ({
    points: Float64Array.from(ring.flatMap(at(z))),
    normals: Float64Array.from(ring.flatMap((p) => [p[0], p[1], 0].map((x) => x / (length2(p) || 1)))),
    joined: true,
  });
  const [bottom, top] = [row(0), row(1)];
  const below = [...lidRows(lid, bottom, at(0), [0, 0, -1])].reverse();
  const cap = below.map((r, i) => ({ ...r, joined: i > 0 }));
  const rows = [...cap, { ...bottom, joined: false }, top, ...lidRows(lid, top, at(1), [0, 0, 1])];
  return gridMesh(rows, evenColumns(ring.length - 1), FLAT);
}

const twice = (points: readonly Vec2[]): number =>
  points.reduce((sum, p, i) => sum + cross2(points.at(i - 1)!, p), 0);

/** Not crossing itself: at rising angles about a point, or a comb of random teeth. */
const star = fc
  .array(fc.double({ min: 0.1, max: 5, noNaN: true }), { minLength: 4, maxLength: 40 })
  .map((radii) =>
    radii.map((r, i): Vec2 => {
      const angle = (2 * Math.PI * i) / radii.length;
      return [r * Math.cos(angle), r * Math.sin(angle)];
    }),
  );
const teeth = fc
  .array(fc.double({ min: -3, max: 3, noNaN: true }), { minLength: 3, maxLength: 30 })
  .map((heights): Vec2[] => [
    ...heights.map((h, i): Vec2 => [i, h]),
    ...heights.map((h, i): Vec2 => [i, h + 0.2]).reverse(),
  ]);

describe('lids', () => {
  test('of outlines seen whole from their centroid are fans', () => {
    for (const outline of [round, joined(roof, 'mirror')]) {
      const lid = lidOf(columnsOf(outline, 24).points);
      expect(lid).toEqual({ centre: [expect.closeTo(0, 12), expect.closeTo(0, 12)] });
    }
    expect('rounds' in lidOf(columnsOf(joined(comb, 'mirror'), 40).points)).toBe(true);
  });

  test('the centroid is that of the area, wherever points are dense', () => {
    const square: Vec2[] = [
      [0, 0],
      [1, 0],
      [2, 0],
      [3, 0],
      [4, 0],
      [4, 4],
      [0, 4],
      [0, 0],
    ];
    expect(centroid(square)).toEqual([expect.closeTo(2, 12), expect.closeTo(2, 12)]);
    expect(
      centroid([
        [1, 1],
        [3, 1],
        [1, 1],
      ]).every(Number.isFinite),
    ).toBe(true);
  });

  test('of any simple outline make a prism: closed, of its area, lids facing out (seed 75)', () => {
    fc.assert(
      fc.property(fc.oneof(star, teeth), (points) => {
        const sense = Math.sign(twice(points));
        const mesh = prism(points);
        expect(topology(mesh)).toMatchObject({ watertight: true, genus: 0, components: 1, finite: true });
        expect(-sense * volume(mesh)).toBeCloseTo(Math.abs(twice(points)) / 2, 3);
        const walls = points.reduce((sum, p, i) => {
          const q = points.at(i - 1)!;
          return sum + length2([p[0] - q[0], p[1] - q[1]]);
        }, 0);
        // lids cover the outline once: no triangle outside of it, none twice
        expect(area(mesh) / (walls + Math.abs(twice(points)))).toBeCloseTo(1, 4);
      }),
      { seed: 75, numRuns: 150 },
    );
  });

  test('of outlines that cross themselves, or are none, are closed and finite (seed 76)', () => {
    const x = fc.integer({ min: -9, max: 9 });
    fc.assert(
      fc.property(
        fc.uniqueArray(fc.tuple(x, x), { minLength: 3, maxLength: 20, selector: String }),
        (points) => {
          expect(topology(prism(points))).toMatchObject({ finite: true });
        },
      ),
      { seed: 76, numRuns: 150 },
    );
    expect(
      normalAgreement(
        prism([
          [-1, 0],
          [0, 1],
          [1, 0],
          [0, -1],
        ]),
      ),
    ).toBeGreaterThan(-1.01);
  });

  test('corners of the outline, where entries are doubled, do no harm', () => {
    const outline = columnsOf(joined(comb, 'mirror'), 30);
    const lid = lidOf(outline.points);
    if (!('rounds' in lid)) throw new Error('not seen from the middle');
    for (const round of lid.rounds) {
      expect(round).toHaveLength(outline.points.length);
      round.forEach((from, j) => {
        if (!outline.joined[j] && j > 0) expect(outline.points[from]).toEqual(outline.points[round[j - 1]!]);
      });
    }
  });
});
