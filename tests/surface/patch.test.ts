import fc from 'fast-check';
import { describe, expect, test } from 'vitest';
import { dot3, length3, sub3 } from '../../src/math/tuple.ts';
import type { Vec3 } from '../../src/math/vec.ts';
import { topology } from '../../src/mesh/check.ts';
import { volume } from '../../src/mesh/measure.ts';
import { curveOf } from '../../src/stroke/arcLength.ts';
import type { Curve } from '../../src/stroke/curve.ts';
import { FILTER_DEFAULTS, filterStroke } from '../../src/stroke/filter.ts';
import { crossSectionSheet } from '../../src/surface/crossSection.ts';
import { sheetMesh } from '../../src/surface/index.ts';
import { joined } from '../../src/surface/joined.ts';
import { type Outline, straight } from '../../src/surface/outline.ts';
import { type PatchOptions, patchSheet } from '../../src/surface/patch.ts';
import type { Sheet } from '../../src/surface/sheet.ts';
import { sourceOf } from '../../src/surface/source.ts';
import { normalAt, place } from '../../src/surface/stand.ts';
import { penStroke } from '../fixtures/pen.ts';
import {
  bentStroke,
  circle,
  creases,
  FLAT,
  halfCircle,
  line,
  normalAgreement,
  normalError,
  smoothStroke,
  TILTED,
} from './curves.ts';
import { comb, mushroom, roof, wave } from './outlines.ts';
import { arch, bumpy, DIAMOND, oval, ridge } from './sections.ts';

const OPTIONS: PatchOptions = { between: 'cubic', rows: null, columns: 16, subdivisions: { u: 1, v: 1 } };

type Sections = readonly (readonly [u: number, outline: Outline])[];

function patch(
  curves: readonly Curve[],
  sections: Sections,
  options: Partial<PatchOptions> = {},
  caps: 'round' | 'none' = 'none',
): Sheet {
  const source = { curves, radius: 10, pressure: false, caps };
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
            const count = sheet.columns.vs.length;
            let [far, off] = [0, 0];
            for (const row of sheet.rows) {
              expect(row.points).toHaveLength(3 * count);
              for (let j = 0; j < count; j++) {
                // so that NaN counts
                if (!(length3(at(row, j)) < 1e4)) far++;
                if (!(Math.abs(length3(at({ points: row.normals }, j)) - 1) < 1e-9)) off++;
              }
            }
            expect([far, off]).toEqual([0, 0]);
          }
        }
      });
    }
  });
}

/** One stroke, and pairs, by name. */
const SOLIDS: Readonly<Record<string, readonly Curve[]>> = {
  ...PAIRS,
  'circles side by side': [circle(-30, 0, 10), circle(30, 0, 10, 1, 2)],
  'a bent stroke': [halfCircle(50, 1)],
  'a stroke with corners, one of them sharp': [line([0, 0], [0, 100], [80, 100], [20, 30])],
  'a round stroke': [circle(0, 0, 40)],
};

const back = (front: Outline): Outline => joined(front, 'mirror');
const CLOSED: Readonly<Record<string, Sections>> = {
  'round to flat': [
    [0.3, oval(1)],
    [0.7, oval(0.3)],
  ],
  'round to bumpy, at ends': [
    [0, oval(1)],
    [1, bumpy(6, 0.12)],
  ],
  'a diamond in front of an oval': [
    [0.4, DIAMOND],
    [0.8, oval(0.6)],
  ],
  'hollow to full, mirrored': [
    [0.3, back(arch(-0.6))],
    [0.7, back(arch(0.5))],
  ],
  'a comb, a roof, a mushroom': [
    [0.3, back(comb)],
    [0.5, back(roof)],
    [0.9, back(mushroom)],
  ],
  'a back of its own': [
    [0.3, joined(arch(0.9), arch(-0.5))],
    [0.7, joined(arch(1), straight)],
  ],
};

describe('closed patches are solids', () => {
  for (const [name, curves] of Object.entries(SOLIDS)) {
    for (const [set, sections] of Object.entries(CLOSED)) {
      test(`${name}, ${set}: watertight, outward, finite`, () => {
        for (const between of ['cubic', 'linear', 'plain'] as const) {
          for (const density of [
            { rows: 2, columns: 3, subdivisions: { u: 0, v: 0 } },
            { rows: 12, columns: 10, subdivisions: { u: 1, v: 1 } },
          ]) {
            const mesh = sheetMesh(patch(curves, sections, { between, ...density }, 'round'), TILTED);
            expect(topology(mesh)).toMatchObject({ watertight: true, badEdges: 0, finite: true });
            expect(volume(mesh)).toBeGreaterThan(0);
            expect(normalError(mesh)).toBeLessThan(1e-6);
          }
        }
      });
    }
  }
});

describe('one section is the cross-sectional surface', () => {
  const outlines = { oval: oval(0.7), diamond: DIAMOND, arch: arch(0.8), ridge: ridge(0.4, 0.2, 0.9) };
  for (const [name, outline] of Object.entries(outlines)) {
    test(`${name}: halving rows and columns divides the error by 16, and normals are S_u × S_v`, () => {
      const curves = PAIRS['a half circle and a line']!;
      const source = sourceOf({ curves, radius: 10, pressure: false });
      const errors = [8, 16, 32].map((n) => {
        const sheet = patch(curves, [[0.5, outline]], { rows: n, columns: n });
        let most = 0;
        let leastCosine = 1;
        for (const row of sheet.rows) {
          const stand = source.stand(row.at.u, row.at.side);
          const sign = row.flipped ? -1 : 1;
          sheet.columns.vs.forEach((v, j) => {
            most = Math.max(most, length3(sub3(at(row, j), place(stand, outline.point(v)))));
            if (outline.corners.includes(v)) return;
            const truth = normalAt(stand, outline.point(v), outline.derivative(v, v === 1 ? -1 : 1));
            leastCosine = Math.min(leastCosine, sign * dot3(truth, at({ points: row.normals }, j)));
          });
        }
        return { most, bend: 1 - leastCosine };
      });
      expect(errors[2]!.most).toBeLessThan(1e-3);
      expect(errors[1]!.most).toBeLessThan(errors[0]!.most / 9);
      expect(errors[2]!.most).toBeLessThan(errors[1]!.most / 9);
      expect(errors[2]!.bend).toBeLessThan(1e-5);
    });
  }

  test('the same again at many u changes nothing', () => {
    const curves = PAIRS['a ball']!;
    const one = patch(curves, [[0.5, bumpy(5, 0.1)]], { rows: 16 });
    const many = patch(
      curves,
      [0.25, 0.5, 0.75].map((u) => [u, bumpy(5, 0.1)] as const),
      { rows: 16 },
    );
    const volumes = [one, many].map((sheet) => volume(sheetMesh(sheet, FLAT)));
    expect(volumes[1]! / volumes[0]!).toBeCloseTo(1, 5);
  });

  test('the volume is that of the cross-sectional surface at 64 × 96', () => {
    for (const name of ['a ball', 'a corner on one side', 'circles in each other', 'a bent stroke']) {
      const curves = SOLIDS[name]!;
      const source = { curves, radius: 10, pressure: false, caps: 'none' } as const;
      const truth = sheetMesh(crossSectionSheet(source, oval(0.8), { u: 64, v: 96 }), FLAT);
      const mesh = sheetMesh(
        patch(curves, [[0.4, oval(0.8)]], { rows: 16, columns: 24, subdivisions: { u: 2, v: 2 } }),
        FLAT,
      );
      expect(volume(mesh) / volume(truth)).toBeCloseTo(1, 3);
    }
  });
});

describe('creases', () => {
  const curves = PAIRS['a half circle and a line']!;

  test('run from the corner of one section to that of the next', () => {
    const sections: Sections = [
      [0.25, ridge(0.3, -0.4, 0.5)],
      [0.75, ridge(0.7, 0.4, 1)],
    ];
    const sheet = patch(curves, sections, { rows: 16 });
    const source = sourceOf({ curves, radius: 10, pressure: false });
    const found = creases(sheetMesh(sheet, FLAT));
    expect(found.length).toBeGreaterThanOrEqual(sheet.rows.length - 2);
    for (const [u, outline] of sections) {
      const corner = place(source.stand(u, 1), outline.point(outline.corners[0]!));
      expect(Math.min(...found.map((p) => length3(sub3(p, corner))))).toBeLessThan(1e-4);
    }
  });

  test('across the corner of a stroke, straight; elsewhere there are none, also between sections and pieces', () => {
    const sections: Sections = [
      [0.3, oval(1)],
      [0.7, bumpy(4, 0.1)],
    ];
    for (const between of ['cubic', 'linear'] as const) {
      const sheet = patch(PAIRS['a corner on one side']!, sections, { between, rows: null });
      const source = sourceOf({ curves: PAIRS['a corner on one side']!, radius: 10, pressure: false });
      const { left, right } = source.stand(source.stops[1]!.u, 1);
      // tips, at y = ± 50, have a normal for every column
      const found = creases(sheetMesh(sheet, FLAT), 0.999).filter(([, y]) => Math.abs(y) < 49.99);
      expect(found.length).toBeGreaterThan(8);
      // on the chord through the corner
      for (const [x, y] of found) {
        const aside = (x - left[0]) * (right[1] - left[1]) - (y - left[1]) * (right[0] - left[0]);
        expect(Math.abs(aside) / length3([right[0] - left[0], right[1] - left[1], 0])).toBeLessThan(1e-3);
      }
    }
  });

  test('without a spline there is one at every section', () => {
    const sections: Sections = [0.2, 0.5, 0.8].map((u, i) => [u, arch(i === 1 ? 1 : 0.3)] as const);
    const edges = (between: PatchOptions['between']) =>
      creases(sheetMesh(patch(curves, sections, { between, rows: 16 }), FLAT), 0.999).length;
    expect(edges('plain')).toBeGreaterThan(3 * 20);
    expect(edges('linear')).toBe(0);
    expect(edges('cubic')).toBe(0);
  });
});

describe('open patches', () => {
  test('straight sections are flat, and face the person who drew', () => {
    for (const curves of [PAIRS['a half circle and a line']!, PAIRS['lines that cross']!]) {
      const sheet = patch(curves, [
        [0.3, straight],
        [0.6, straight],
      ]);
      const mesh = sheetMesh(sheet, FLAT);
      for (let i = 2; i < mesh.positions.length; i += 3) expect(mesh.positions[i]).toBeCloseTo(0, 12);
      for (let i = 2; i < mesh.normals.length; i += 3) expect(mesh.normals[i]).toBeCloseTo(1, 6);
      expect(normalAgreement(mesh)).toBeGreaterThan(0.999);
    }
  });

  test('sections beyond the first and last go on as they are', () => {
    const curves = [line([-10, 0], [-10, 100]), line([10, 0], [10, 100])];
    const sheet = patch(curves, [
      [0.4, arch(0.2)],
      [0.6, arch(1)],
    ]);
    const heights = sheet.rows.map(({ points }) => Math.max(...points.filter((_, k) => k % 3 === 2)));
    sheet.rows.forEach(({ at: { u } }, i) => {
      if (u <= 0.4) expect(heights[i]).toBeCloseTo(2, 3);
      if (u >= 0.6) expect(heights[i]).toBeCloseTo(10, 3);
      expect(heights[i]).toBeGreaterThan(1.99);
      expect(heights[i]).toBeLessThan(10.01);
    });
  });
});

test('nothing comes of strokes on each other, and dots', () => {
  const sections: Sections = [
    [0.3, oval(1)],
    [0.6, bumpy(4, 0.1)],
  ];
  for (const curves of [
    [line([0, 0], [10, 20]), line([0, 0], [10, 20])],
    [line([1, 1]), line([1, 1])],
    [line([1, 1]), line([5, 5])],
  ]) {
    expect(sheetMesh(patch(curves, sections), FLAT).indices).toHaveLength(0);
  }
});

test('numbers that are none are refused', () => {
  for (const options of [{ rows: Number.NaN }, { columns: Number.POSITIVE_INFINITY }]) {
    expect(() => patch(PAIRS['a ball']!, [[0.5, oval(1)]], options)).toThrow(RangeError);
  }
});

/** By 180°: then a tube's rings lie on each other, which welding cannot tell apart. */
function turnsBack({ corners, tangent }: Curve): boolean {
  return corners.some((u) => {
    const [a, b] = [tangent(u, -1), tangent(u, 1)];
    return a[0] * b[0] + a[1] * b[1] < -0.999;
  });
}

const anyOutline = (closed: boolean): fc.Arbitrary<Outline> => {
  const height = fc.double({ min: -1.5, max: 1.5, noNaN: true });
  const open = fc.oneof(
    height.map(arch),
    fc
      .tuple(fc.double({ min: 0.1, max: 0.9, noNaN: true }), height, height)
      .map(([v, x, y]) => ridge(v, x, y)),
    fc.constantFrom(straight, comb, mushroom, roof),
  );
  return closed
    ? fc.oneof(
        open.map(back),
        fc.tuple(open, open).map(([a, b]) => joined(a, b)),
      )
    : open;
};

describe('random strokes and sections (seed 558)', () => {
  test('finite, with unit normals; mirrored backs closed and not inside out', () => {
    const curves = fc.oneof(
      fc.tuple(smoothStroke(50), smoothStroke(50)),
      fc.tuple(bentStroke(false), bentStroke(false)),
      fc.tuple(bentStroke(true), bentStroke(true)),
      fc.tuple(smoothStroke(50)),
      fc.tuple(bentStroke(false).filter((stroke) => !turnsBack(stroke))),
    );
    const section = fc.tuple(
      fc.double({ min: 0, max: 1, noNaN: true }),
      anyOutline(false),
      anyOutline(false),
    );
    const options = fc.record({
      between: fc.constantFrom('cubic' as const, 'linear' as const, 'plain' as const),
      rows: fc.constantFrom(null, 1, 3, 10),
      columns: fc.integer({ min: 1, max: 12 }),
      subdivisions: fc.record({ u: fc.integer({ min: 0, max: 2 }), v: fc.integer({ min: 0, max: 2 }) }),
    });
    const kind = fc.constantFrom('open', 'mirrored', 'drawn');
    fc.assert(
      fc.property(
        curves,
        fc.array(section, { minLength: 1, maxLength: 4 }),
        kind,
        options,
        (strokes, drawn, backs, how) => {
          const sections = drawn.map(([u, front, behind]) => {
            const outline =
              backs === 'open' ? front : joined(front, backs === 'mirrored' ? 'mirror' : behind);
            return [u, outline] as const;
          });
          const sheet = patch(strokes, sections, how, 'round');
          const mesh = sheetMesh(sheet, TILTED);
          const { finite, watertight } = topology(mesh);
          expect(finite).toBe(true);
          expect(normalError(mesh)).toBeLessThan(1e-5);
          if (backs !== 'mirrored') return;
          expect(watertight).toBe(true);
          expect(volume(mesh)).toBeGreaterThanOrEqual(-1e-3 * strokes[0]!.length ** 3);
        },
      ),
      { seed: 558, numRuns: 60 },
    );
  }, 60_000);
});

describe('sections of many folds', () => {
  const curves = [line([-10, 0], [-10, 60]), line([10, 0], [10, 60])];
  const folds = wave(0.2, 12);
  const worst = (options: Partial<PatchOptions>): number => {
    const { rows, columns } = patch(
      curves,
      [
        [0.3, folds],
        [0.7, folds],
      ],
      options,
    );
    const row = rows.find((found) => Math.abs(found.at.u - 0.3) < 1e-9)!;
    return Math.max(
      ...columns.vs.map((v, j) => {
        const [x, y] = folds.point(v);
        const [px, , pz] = at(row, j);
        return length3([px / 10 - x, 0, pz / 10 - y]);
      }),
    );
  };

  test('get the columns they need where rows come by themselves', () => {
    expect(worst({ columns: 16, subdivisions: { u: 0, v: 2 } })).toBeLessThan(0.02);
  });
});
