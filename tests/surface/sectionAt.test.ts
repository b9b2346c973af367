import { describe, expect, test } from 'vitest';
import { dot3, length3, sub3 } from '../../src/math/tuple.ts';
import type { Vec3 } from '../../src/math/vec.ts';
import type { Plane } from '../../src/stroke/stroke.ts';
import { axisOf } from '../../src/surface/bendAxis.ts';
import { type BendInput, deform } from '../../src/surface/deform.ts';
import { buildSheet } from '../../src/surface/index.ts';
import { straight } from '../../src/surface/outline.ts';
import { sectionAt } from '../../src/surface/sectionAt.ts';
import { FLAT, line, TILTED } from './curves.ts';

const SIDE: Plane = { origin: [0, 0, 0], x: [0, 0, -1], y: [0, 1, 0] };
const OPTIONS = { radius: 6, pressure: false, caps: true, u: 24, v: 16 };
const pair = [line([-20, 0], [-20, 100]), line([20, 0], [20, 100])];
const round = buildSheet('rotational', { curves: pair, sections: [], bends: [] }, OPTIONS)!;
const flat = buildSheet(
  'crossSection',
  { curves: pair, sections: [{ u: 0.5, outline: straight }], bends: [] },
  OPTIONS,
)!;
/** straight away from the person at y = 50 */
const elbow: BendInput = { curve: line([0, 0], [0, 50], [50, 50]), plane: SIDE, keepsLength: true };

const close = (v: Vec3, w: Vec3): void => expect(length3(sub3(v, w))).toBeLessThan(1e-9);

describe('sections of sheets', () => {
  for (const [name, sheet] of [
    ['round', round],
    ['open', flat],
  ] as const) {
    test(`${name}: the frame of the chord and the points, on any drawing plane`, () => {
      for (const drawing of [FLAT, TILTED]) {
        const { plane, half, points } = sectionAt(sheet, sheet, 0.37, drawing)!;
        expect(half).toBeCloseTo(20, 9);
        close(plane.x, drawing.x);
        close(sub3(plane.origin, drawing.origin), drawing.y.map((y) => 37 * y) as unknown as Vec3);
        expect(dot3(plane.y, drawing.x)).toBeCloseTo(0, 9);
        expect(dot3(plane.y, drawing.y)).toBeCloseTo(0, 9);
        for (const p of points) expect(dot3(sub3(p, plane.origin), drawing.y)).toBeCloseTo(0, 9);
      }
      close(sectionAt(sheet, sheet, 0.37, FLAT)!.plane.y, [0, 0, 1]);
    });

    test(`${name}: after a bend it stands across the stroke`, () => {
      const bent = deform(sheet, elbow);
      const { plane, half } = sectionAt(bent, sheet, 0.9, FLAT)!;
      expect(half).toBeCloseTo(20, 9);
      close(plane.origin, [0, 50, -40]);
      close(plane.x, [1, 0, 0]);
      // what was towards the person is up now
      close(plane.y, [0, 1, 0]);
    });
  }

  test('a point has no section', () => {
    const cone = buildSheet(
      'rotational',
      { curves: [line([0, 100], [-20, 0]), line([0, 100], [20, 0])], sections: [], bends: [] },
      OPTIONS,
    )!;
    const views = [0, 0.5, 1].map((u) => sectionAt(cone, cone, u, FLAT));
    expect(views.filter((view) => view === null)).toHaveLength(1);
  });

  test('the axis as it is shown', () => {
    const points = axisOf(round.spine, SIDE);
    close([...points[0]!, 0], [0, points[0]![1], 0]);
    expect(points.map(([, y]) => y).sort((a, b) => a - b)[0]).toBeCloseTo(0, 9);
    expect(Math.max(...points.map(([, y]) => y))).toBeCloseTo(100, 9);
  });
});
