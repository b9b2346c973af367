/** Bends of the surfaces of the list, over strokes as a pen draws them. */
import { describe, expect, test } from 'vitest';
import type { Vec2 } from '../../src/math/vec.ts';
import { topology } from '../../src/mesh/check.ts';
import { volume } from '../../src/mesh/measure.ts';
import { curveOf, polylineCurve } from '../../src/stroke/arcLength.ts';
import type { Curve } from '../../src/stroke/curve.ts';
import { FILTER_DEFAULTS, filterStroke } from '../../src/stroke/filter.ts';
import type { Plane } from '../../src/stroke/stroke.ts';
import { type BendInput, deform } from '../../src/surface/deform.ts';
import { buildSheet, type PlacedOutline, type SurfaceKind, sheetMesh } from '../../src/surface/index.ts';
import { joined } from '../../src/surface/joined.ts';
import { penStroke } from '../fixtures/pen.ts';
import { FLAT, normalAgreement } from './curves.ts';
import { mushroom, wave } from './outlines.ts';

const pen = (path: (t: number) => Vec2, seed: number): Curve =>
  curveOf(filterStroke(penStroke(path, { seed, jitter: 0.1 }), FILTER_DEFAULTS)!);

const SIDE: Plane = { origin: [0, 0, 0], x: [0, 0, -1], y: [0, 1, 0] };
const ASKEW: Plane = { origin: [0, 0, 0], x: [0.28, 0, -0.96], y: [0, 1, 0] };

const vase = [
  pen((t) => [-30 - 9 * Math.sin(6 * t), 120 * t], 1),
  pen((t) => [28 + 9 * Math.sin(5 * t), 120 * t], 2),
];
const egg = [
  pen((t) => [-40 * Math.sin(Math.PI * t), 60 - 60 * Math.cos(Math.PI * t)], 3),
  pen((t) => [35 * Math.sin(Math.PI * t), 60 - 60 * Math.cos(Math.PI * t)], 4),
];
const stalk = [pen((t) => [9 * Math.sin(7 * t), 120 * t], 5)];
const zigzag = [
  polylineCurve(
    [
      [0, 0],
      [25, 45],
      [-10, 80],
      [0, 120],
    ],
    false,
  ),
];
const crossing = [pen((t) => [-30 + 60 * t, 120 * t], 6), pen((t) => [30 - 60 * t, 120 * t], 7)];
const ring = [pen((t) => [60 * Math.cos(6.2832 * t), 60 + 60 * Math.sin(6.2832 * t)], 8)];

const sections: readonly PlacedOutline[] = [{ u: 0.5, outline: joined(wave(0.8, 1), 'mirror') }];
const overhang: readonly PlacedOutline[] = [{ u: 0.5, outline: joined(mushroom, 'mirror') }];
const forms: readonly [string, SurfaceKind, readonly Curve[], readonly PlacedOutline[]][] = [
  ['vase', 'rotational', vase, []],
  ['egg', 'rotational', egg, []],
  ['stalk', 'tube', stalk, []],
  ['zigzag', 'tube', zigzag, []],
  ['ring', 'tube', ring, []],
  ['strokes that cross', 'rotational', crossing, []],
  ['vase with a section', 'crossSection', vase, sections],
  ['egg with an overhanging section', 'crossSection', egg, overhang],
  ['stalk with a section', 'crossSection', stalk, sections],
];
const OPTIONS = { radius: 6, pressure: false, caps: true, u: 24, v: 16 };
const sheetOf = (kind: SurfaceKind, curves: readonly Curve[], outlines: readonly PlacedOutline[]) =>
  buildSheet(kind, { curves, sections: outlines, bends: [] }, OPTIONS)!;

const bow: BendInput = {
  curve: pen((t) => [25 * Math.sin(Math.PI * t), 120 * t], 9),
  plane: SIDE,
  keepsLength: true,
};
const hook: BendInput = {
  curve: pen((t) => [70 - 70 * Math.cos(2.4 * t), 70 * Math.sin(2.4 * t)], 10),
  plane: ASKEW,
  keepsLength: false,
};
const elbow: BendInput = {
  curve: polylineCurve(
    [
      [0, 0],
      [0, 70],
      [55, 95],
    ],
    false,
  ),
  plane: ASKEW,
  keepsLength: false,
};

describe('bent surfaces', () => {
  for (const [name, kind, curves, outlines] of forms) {
    test(`${name}: watertight and outward in every bend and in bends on bends`, () => {
      const flat = sheetOf(kind, curves, outlines);
      const before = topology(sheetMesh(flat, FLAT));
      for (const bends of [[bow], [hook], [elbow], [bow, hook], [elbow, bow], [hook, elbow, bow]]) {
        const mesh = sheetMesh(bends.reduce(deform, flat), FLAT);
        const after = topology(mesh);
        expect(after.finite).toBe(true);
        expect(after.badEdges).toBe(0);
        expect([after.euler, after.components]).toEqual([before.euler, before.components]);
        expect(volume(mesh)).toBeGreaterThan(0);
      }
    });
  }

  test('a bow of the same length keeps the volume of what is round about its axis', () => {
    for (const [kind, curves] of [
      ['rotational', vase],
      ['tube', stalk],
    ] as const) {
      const flat = sheetOf(kind, curves, []);
      const [before, after] = [flat, deform(flat, bow)].map((sheet) => volume(sheetMesh(sheet, FLAT)));
      expect(after! / before!).toBeCloseTo(1, 2);
    }
  });

  test('triangles and normals agree as well as before', () => {
    for (const [kind, curves] of [
      ['rotational', vase],
      ['tube', stalk],
    ] as const) {
      const flat = sheetOf(kind, curves, []);
      for (const bend of [bow, hook]) {
        const agree = normalAgreement(sheetMesh(deform(flat, bend), FLAT));
        expect(agree).toBeGreaterThan(0.9);
      }
    }
  });

  test('the axis as it is seen, drawn over exactly, changes nothing', () => {
    for (const [kind, curves] of [
      ['rotational', vase],
      ['tube', stalk],
      ['tube', zigzag],
    ] as const) {
      const flat = sheetOf(kind, curves, []);
      const ends = [0, 1].map((u) => flat.spine.at(u, u === 0 ? 1 : -1).centre[1]);
      const curve = polylineCurve(
        [
          [0, ends[0]!],
          [0, ends[1]!],
        ],
        false,
      );
      for (const keepsLength of [true, false]) {
        const bent = deform(flat, { curve, plane: SIDE, keepsLength });
        const away = Math.max(
          ...flat.rows.flatMap((row, i) =>
            [...row.points].map((x, k) => Math.abs(x - bent.rows[i]!.points[k]!)),
          ),
        );
        expect(away).toBeLessThan(1e-9);
        const turned = Math.max(
          ...flat.rows.flatMap((row, i) =>
            [...row.normals].map((x, k) => Math.abs(x - bent.rows[i]!.normals[k]!)),
          ),
        );
        expect(turned).toBeLessThan(1e-9);
      }
    }
  });
});
