import { describe, expect, test } from 'vitest';
import { length3, sub3 } from '../../src/math/tuple.ts';
import type { Vec3 } from '../../src/math/vec.ts';
import { curveOf } from '../../src/stroke/arcLength.ts';
import type { Curve } from '../../src/stroke/curve.ts';
import { FILTER_DEFAULTS, filterStroke } from '../../src/stroke/filter.ts';
import type { Outline } from '../../src/surface/outline.ts';
import { type PatchOptions, patchSheet } from '../../src/surface/patch.ts';
import type { Sheet } from '../../src/surface/sheet.ts';
import { sourceOf } from '../../src/surface/source.ts';
import { penStroke } from '../fixtures/pen.ts';
import { circle, halfCircle, line } from './curves.ts';
import { arch, bumpy, DIAMOND, oval, ridge } from './sections.ts';

const OPTIONS: PatchOptions = { between: 'cubic', rows: null, columns: 16, subdivisions: { u: 1, v: 1 } };

function patch(
  curves: readonly Curve[],
  sections: readonly (readonly [u: number, outline: Outline])[],
  options: Partial<PatchOptions> = {},
): Sheet {
  const source = { curves, radius: 10, pressure: false, caps: 'none' } as const;
  return patchSheet(
    source,
    sections.map(([u, outline]) => ({ u, outline })),
    { ...OPTIONS, ...options },
  )!;
}

function at({ points }: { readonly points: Float64Array }, j: number): Vec3 {
  return [points[3 * j]!, points[3 * j + 1]!, points[3 * j + 2]!];
}

/** A line as a hand draws it: uneven speed, tremble, pixels. */
function byHand(seed: number, path: (t: number) => readonly [number, number]): Curve {
  const samples = penStroke(path, { seed, jitter: 0.15, quantise: 0.25, rest: 3, hook: 1 });
  return curveOf(filterStroke(samples, FILTER_DEFAULTS)!);
}

const PAIRS: Readonly<Record<string, readonly [Curve, Curve]>> = {
  'a ball': [halfCircle(50, -1), halfCircle(50, 1)],
  'a half circle and a line': [halfCircle(50, -1, -20), line([20, 50], [20, -50])],
  'a corner on one side': [halfCircle(50, -1), line([0, 50], [30, 20], [0, -50])],
  'lines that cross': [line([-20, 50], [20, -50]), line([20, 50], [-20, -50])],
  'a spike': [
    line(...Array.from({ length: 65 }, (_, i) => [-(i * i) / 200, 60 - i / 2] as const)),
    line(...Array.from({ length: 65 }, (_, i) => [(i * i) / 200, 60 - i / 2] as const)),
  ],
  'circles in each other': [circle(0, 0, 10), circle(0, 0, 30, -1, 1)],
  'a body by hand (seeds 1, 2)': [
    byHand(1, (t) => [-20 - 12 * Math.sin(7 * t) - 3 * Math.sin(19 * t), 120 - 240 * t]),
    byHand(2, (t) => [25 + 15 * Math.sin(5 * t + 1), 118 - 237 * t]),
  ],
  'a leaf by hand (seeds 3, 4)': [
    byHand(3, (t) => [-40 * Math.sin(Math.PI * t), 90 - 180 * t]),
    byHand(4, (t) => [30 * Math.sin(Math.PI * t) * (1 + 0.3 * Math.sin(9 * t)), 90 - 180 * t]),
  ],
};

/** Outlines at their u: two open, three with a ridge that wanders, closed ones. */
const SETS: Readonly<Record<string, readonly (readonly [number, Outline])[]>> = {
  'two arches': [
    [0.3, arch(1)],
    [0.75, arch(-0.4)],
  ],
  ridges: [
    [0.2, ridge(0.3, -0.4, 0.5)],
    [0.5, ridge(0.5, 0.1, 1)],
    [0.81, ridge(0.7, 0.4, 0.3)],
  ],
  'round to bumpy': [
    [0.25, oval(1)],
    [0.6, bumpy(6, 0.12)],
  ],
  'a diamond to an oval': [
    [0.4, DIAMOND],
    [0.8, oval(0.6)],
  ],
};

for (const [name, curves] of Object.entries(PAIRS)) {
  const source = sourceOf({ curves, radius: 10, pressure: false });
  const chordAt = (u: number): number => 2 * source.stand(u, 1).radius;
  const longest = Math.max(...Array.from({ length: 101 }, (_, i) => chordAt(i / 100)));

  describe(name, () => {
    for (const [set, sections] of Object.entries(SETS)) {
      test(`${set}: rows pass through q_l and q_r, to 1e-9 at knots, within 0.5 % of the chord between`, () => {
        const times = 2;
        const sheet = patch(curves, sections, { subdivisions: { u: times, v: 0 } });
        const { vs } = sheet.columns;
        const right = sections[0]![1].closed ? vs.indexOf(0.5) : vs.length - 1;
        expect(right).toBeGreaterThan(0);
        let knot = 0;
        for (const row of sheet.rows) {
          if (!row.joined) knot = 0;
          const stand = source.stand(row.at.u, row.at.side);
          const away = [
            length3(sub3(at(row, 0), [stand.left[0], stand.left[1], 0])),
            length3(sub3(at(row, right), [stand.right[0], stand.right[1], 0])),
          ];
          const allowed =
            knot % 4 === 0 ? 1e-9 * longest : 0.005 * Math.max(2 * stand.radius, 1e-3 * longest);
          expect(Math.max(...away)).toBeLessThan(allowed);
          knot++;
        }
        for (const [u] of sections) {
          expect(Math.min(...sheet.rows.map((row) => Math.abs(row.at.u - u)))).toBeLessThan(2e-3);
        }
      });

      test(`${set}: no NaN, unit normals, at every density`, () => {
        for (const between of ['cubic', 'linear', 'plain'] as const) {
          for (const rows of [1, 5, null]) {
            const sheet = patch(curves, sections, { between, rows, columns: rows ?? 12 });
            for (const row of sheet.rows) {
              expect(row.points).toHaveLength(3 * sheet.columns.vs.length);
              sheet.columns.vs.forEach((_, j) => {
                expect(length3(at(row, j))).toBeLessThan(1e4);
                expect(length3(at({ points: row.normals }, j))).toBeCloseTo(1, 9);
              });
            }
          }
        }
      });
    }
  });
}
