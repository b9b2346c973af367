import { describe, expect, test } from 'vitest';
import { dot3, length3, sub3 } from '../../src/math/tuple.ts';
import { topology } from '../../src/mesh/check.ts';
import { gridMesh } from '../../src/mesh/grid.ts';
import { area, bounds, volume } from '../../src/mesh/measure.ts';
import type { Mesh } from '../../src/mesh/mesh.ts';
import type { Curve } from '../../src/stroke/curve.ts';
import { crossSectionSheet, type SectionOptions } from '../../src/surface/crossSection.ts';
import { buildSurface } from '../../src/surface/index.ts';
import { joined, round } from '../../src/surface/joined.ts';
import { type Outline, outlineOf, roundHalf, straight } from '../../src/surface/outline.ts';
import { rotational } from '../../src/surface/rotational.ts';
import { tube } from '../../src/surface/tube.ts';
import {
  circle,
  creases,
  FLAT,
  halfCircle,
  line,
  normalAgreement,
  normalError,
  normalOf,
  pointOf,
  polygon,
  reversed,
  TILTED,
  withPressure,
} from './curves.ts';
import { bent, comb, mushroom, raisedBy, roof, wave } from './outlines.ts';

const FINE = { u: 48, v: 48 };
const { PI } = Math;

function mesh(
  curves: readonly Curve[],
  outline: Outline,
  options: SectionOptions & { caps?: 'round' | 'flat' | 'none'; radius?: number; pressure?: boolean } = FINE,
  plane = FLAT,
): Mesh {
  const { caps = 'flat', radius = 10, pressure = false } = options;
  const sheet = crossSectionSheet({ curves, caps, radius, pressure }, outline, options);
  if (!sheet) throw new Error('no sheet');
  return gridMesh(sheet.rows, sheet.columns, plane);
}

const pairs: Record<string, readonly [Curve, Curve]> = {
  'a vase': [halfCircle(60, -1, -5), line([10, 60], [40, -60])],
  'a sphere’s outline': [halfCircle(50, -1), halfCircle(50, 1)],
  'legs that meet': [line([0, 50], [-20, 0]), line([0, 50], [20, 0])],
  'strokes with corners': [line([-10, 0], [-10, 27], [-40, 60]), line([10, 0], [10, 33], [40, 60])],
  'strokes that cross': [line([-20, 50], [25, -50]), line([20, 50], [-20, -50])],
  'circles side by side': [circle(-30, 0, 10), circle(30, 0, 10, 1, 2)],
  'nested circles': [circle(0, 0, 10), circle(0, 0, 30, -1, 1)],
  'nested squares': [
    polygon([-10, -10], [10, -10], [10, 10], [-10, 10]),
    polygon([20, 20], [-20, 20], [-20, -20], [20, -20]),
  ],
};
const fronts: Record<string, Outline> = {
  round: roundHalf,
  straight,
  hollow: raisedBy(roundHalf, -0.7),
  'both ways': wave(0.5, 2),
  bumpy: wave(0.3, 5),
  overhanging: mushroom,
  'a roof': roof,
  'a comb': comb,
  'drawn from right to left': outlineOf(reversed(halfCircle(3, 1)), { reversed: true, across: true }),
};

const SEEN = ['round', 'hollow', 'overhanging', 'a roof'].map((name) => fronts[name]!);

describe('without a back', () => {
  test('a straight section is flat, its normals the plane’s, and faces the person', () => {
    for (const curves of Object.values(pairs).slice(0, 4)) {
      const flat = mesh(curves, straight);
      for (let i = 0; i < flat.normals.length / 3; i++) {
        expect(pointOf(flat, i)[2]).toBe(0);
        expect(normalOf(flat, i).map(Math.abs)).toEqual([0, 0, 1]);
      }
      expect(normalAgreement(flat)).toBeGreaterThan(0.999);
      expect(normalOf(flat, flat.indices[0]!)[2]).toBe(1);
    }
  });

  test('between parallel lines it has the length of the section times theirs', () => {
    const sheet = mesh([line([-10, 0], [-10, 50]), line([10, 0], [10, 50])], roof);
    expect(area(sheet)).toBeCloseTo(2 * Math.hypot(10, 10) * 50, 3);
    expect(bounds(sheet).max[2]).toBeCloseTo(10, 5);
    expect(topology(sheet)).toMatchObject({ components: 2 - 1, degenerate: 0, finite: true });
  });

  test('strokes stay its sides to the last bit', () => {
    const [left, right] = pairs['a vase']!;
    const sheet = mesh([left, right], wave(0.4, 3));
    for (const curve of [left, right]) {
      const [x, y] = curve.point(0);
      const at = [x, y].map(Math.fround);
      const found = Array.from({ length: sheet.positions.length / 3 }, (_, i) => pointOf(sheet, i));
      expect(found.some((p) => p[0] === at[0] && p[1] === at[1] && p[2] === 0)).toBe(true);
    }
  });
});

describe('a half circle and its mirror image', () => {
  for (const [name, curves] of Object.entries(pairs)) {
    test(`are the rotational surface: ${name}`, () => {
      const ours = mesh(curves, round);
      const theirs = rotational(...curves, FLAT, { caps: true, ...FINE });
      expect(volume(ours) / volume(theirs)).toBeCloseTo(1, 6);
      expect(worstNeighbour(ours, theirs)).toBeLessThan(1e-6);
    });
  }

  test('on one stroke are the tube', () => {
    const pressed = withPressure(halfCircle(50, 1), (u) => 0.5 + 0.3 * Math.sin(5 * u));
    for (const curve of [
      halfCircle(50, 1),
      line([0, 0], [0, 50], [50, 50]),
      circle(0, 0, 40),
      line([1, 2]),
      pressed,
    ]) {
      const options = { ...FINE, radius: 8, caps: 'round', pressure: curve === pressed } as const;
      const ours = mesh([curve], round, options);
      const theirs = tube(curve, FLAT, options);
      expect(volume(ours) / volume(theirs)).toBeCloseTo(1, 6);
      expect(worstNeighbour(ours, theirs)).toBeLessThan(1e-4);
    }
  });
});

/** The farthest that a vertex in use is from the nearest of the other mesh in place and normal together. */
function worstNeighbour(a: Mesh, b: Mesh): number {
  const cell = (p: readonly number[]): string => p.map((x) => Math.round(x * 10)).join();
  const at = new Map<string, number[]>();
  for (const i of new Set(b.indices)) {
    const [x, y, z] = pointOf(b, i);
    for (const dx of [-0.05, 0.05])
      for (const dy of [-0.05, 0.05])
        for (const dz of [-0.05, 0.05]) {
          const key = cell([x + dx, y + dy, z + dz]);
          at.set(key, [...(at.get(key) ?? []), i]);
        }
  }
  let worst = 0;
  for (const i of new Set(a.indices)) {
    const p = pointOf(a, i);
    const n = normalOf(a, i);
    const near = [...new Set([-0.05, 0.05].flatMap((d) => at.get(cell(p.map((x) => x + d))) ?? []))];
    const away = near.map((j) => {
      const turn = length3(sub3(n, normalOf(b, j)));
      return Math.max(length3(sub3(p, pointOf(b, j))) / 50, turn);
    });
    worst = Math.max(worst, Math.min(...away));
  }
  return worst;
}

describe('closed sections', () => {
  for (const [form, curves] of Object.entries(pairs)) {
    for (const [section, front] of Object.entries(fronts)) {
      test(`${section}, mirrored, on ${form}: watertight, outward, finite`, () => {
        const solid = mesh(curves, joined(front, 'mirror'), FINE, TILTED);
        expect(topology(solid)).toMatchObject({ watertight: true, degenerate: 0, finite: true });
        expect(volume(solid)).toBeGreaterThan(0);
        expect(normalError(solid)).toBeLessThan(1e-5);
        // others fold where they shrink to a tip that does not see all of them
        if (SEEN.includes(front)) expect(normalAgreement(solid)).toBeGreaterThan(0);
      });
    }
  }

  test('between parallel lines enclose the section’s area times the length, scaled with the section', () => {
    const lines = [line([-10, 0], [-10, 50]), line([10, 0], [10, 50])];
    const roofs = mesh(lines, joined(roof, 'mirror'), { u: 4, v: 8 });
    expect(volume(roofs)).toBeCloseTo(200 * 50, 1);
    const base = volume(mesh(lines, joined(mushroom, 'mirror')));
    for (const k of [0.1, 0.5, 3])
      expect(volume(mesh(lines, joined(raisedBy(mushroom, k), 'mirror'))) / base).toBeCloseTo(k, 5);
  });

  test('scaled by k enclose k times as much on any strokes', () => {
    for (const curves of [pairs['a vase']!, pairs['strokes with corners']!, pairs['nested circles']!]) {
      const base = volume(mesh(curves, joined(roundHalf, 'mirror')));
      for (const k of [0.2, 2])
        expect(volume(mesh(curves, joined(raisedBy(roundHalf, k), 'mirror'))) / base).toBeCloseTo(k, 5);
    }
  });

  test('with a back of their own', () => {
    const lines = [line([-10, 0], [-10, 50]), line([10, 0], [10, 50])];
    const hollow = joined(roundHalf, raisedBy(roof, 0.5));
    const half = mesh(lines, hollow, { u: 2, v: 400 });
    expect(topology(half)).toMatchObject({ watertight: true, genus: 0, degenerate: 0 });
    expect(volume(half) / (50 * (50 * PI - 50))).toBeCloseTo(1, 3);
    const swapped = mesh(lines, joined(raisedBy(roof, 0.5), roundHalf), { u: 2, v: 400 });
    expect(volume(swapped)).toBeCloseTo(volume(half), 1);
  });

  test('a back on its front leaves the front alone', () => {
    const sheet = mesh(pairs['a vase']!, joined(roof, roof));
    expect(topology(sheet)).toMatchObject({ watertight: false, components: 1 });
  });
});

describe('on one stroke', () => {
  const strokes: Record<string, Curve> = {
    'a line': line([0, 0], [30, 40]),
    'an arc': halfCircle(50, 1),
    'an elbow': line([0, 0], [0, 50], [50, 50]),
    'a hairpin': line([0, 0], [0, 50], [10, 0]),
    'a ring': circle(0, 0, 40),
    'a frame': polygon([0, 0], [60, 0], [60, 60], [0, 60]),
    'a triangle': polygon([0, 0], [60, 0], [30, 60]),
  };
  for (const [name, curve] of Object.entries(strokes)) {
    for (const caps of ['round', 'flat'] as const) {
      test(`${name}, ${caps} ends: watertight, outward, finite`, () => {
        for (const front of Object.values(fronts)) {
          const solid = mesh([curve], joined(front, 'mirror'), { u: 24, v: 24, caps, radius: 5 }, TILTED);
          expect(topology(solid)).toMatchObject({ watertight: true, finite: true });
          expect(volume(solid)).toBeGreaterThan(0);
          expect(normalError(solid)).toBeLessThan(1e-5);
        }
      });
    }
  }

  test('a bar of a square section', () => {
    const bar = joined(bent([-1, 0], [-1, 1], [1, 1], [1, 0]), 'mirror');
    const solid = mesh([line([0, 0], [30, 40])], bar, { u: 2, v: 16, radius: 5 });
    expect(volume(solid)).toBeCloseTo(100 * 50, 1);
    expect(topology(solid)).toMatchObject({ watertight: true, degenerate: 0, genus: 0 });
    // front and back run smoothly into each other, corners do not
    const sharp = creases(solid);
    for (const p of sharp.filter(([x, y]) => dot3([x, y, 0], [0.6, 0.8, 0]) % 50 > 0.01))
      expect(Math.abs(p[2])).toBeCloseTo(5, 5);
  });
});

test('ends that are not seen whole from their middle bend with their form', () => {
  const curves = [line([-10, 0], [-10, 50]), line([10, 0], [10, 50])];
  const outline = joined(comb, 'mirror');
  const bend = {
    curve: line([0, 0], [0, 25], [20, 45]),
    plane: { origin: [0, 0, 0], x: [0, 0, -1], y: [0, 1, 0] } as const,
    keepsLength: true,
  };
  const options = { radius: 5, pressure: false, caps: true, u: 12, v: 40 };
  const [straightened, bent] = [[], [bend]].map((bends) =>
    buildSurface('crossSection', { curves, sections: [{ u: 0, outline }], bends }, FLAT, options),
  ) as [Mesh, Mesh];
  expect(topology(bent)).toMatchObject({ watertight: true, genus: 0, components: 1, finite: true });
  // sections stay what they are and go the same way
  expect(volume(bent) / volume(straightened)).toBeCloseTo(1, 2);
  expect(normalAgreement(bent)).toBeGreaterThan(0.5);
});

describe('creases', () => {
  test('corners of the section run along the surface with doubled normals, smooth ones have none', () => {
    const lines = [line([-10, 0], [-10, 50]), line([10, 0], [10, 50])];
    const ridge = creases(mesh(lines, roof, { u: 10, v: 8 }));
    expect(ridge).toHaveLength(11);
    for (const [x, , z] of ridge) expect([x, z]).toEqual([expect.closeTo(0, 5), expect.closeTo(10, 5)]);
    expect(creases(mesh(lines, wave(0.4, 3), { u: 10, v: 40 }))).toEqual([]);
  });

  test('corners of strokes run across', () => {
    const found = creases(mesh(pairs['strokes with corners']!, roundHalf, { u: 20, v: 16 }));
    expect(found).toHaveLength(17);
  });
});

describe('degenerate input', () => {
  test('strokes on each other, on one line or without length make nothing', () => {
    for (const curves of [
      [line([0, 0], [10, 20]), line([0, 0], [10, 20])],
      [line([1, 1]), line([5, 5])],
      [line([1, 1])],
      [line([0, 0], [10, 0]), line([20, 0], [40, 0])],
    ])
      for (const outline of [straight, roof, round])
        expect(
          crossSectionSheet({ curves, caps: 'flat', radius: 5, pressure: false }, outline, FINE),
        ).toBeNull();
  });

  test('numbers that are none, and three strokes, are refused', () => {
    const source = { curves: [line([0, 0], [10, 20])], caps: 'flat', radius: 5, pressure: false } as const;
    expect(() => crossSectionSheet(source, round, { u: Number.NaN, v: 8 })).toThrow(RangeError);
    expect(() => crossSectionSheet({ ...source, radius: 0 }, round, FINE)).toThrow(RangeError);
    expect(() => crossSectionSheet({ ...source, curves: [] }, round, FINE)).toThrow(RangeError);
  });
});
