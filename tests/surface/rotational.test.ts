import fc from 'fast-check';
import { describe, expect, test } from 'vitest';
import { length3, sub3 } from '../../src/math/tuple.ts';
import { topology } from '../../src/mesh/check.ts';
import { bounds, volume } from '../../src/mesh/measure.ts';
import type { Curve } from '../../src/stroke/curve.ts';
import { rotational } from '../../src/surface/rotational.ts';
import {
  bentStroke,
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
  smoothStroke,
  TILTED,
  vertexDistance,
} from './curves.ts';

const FINE = { caps: true, u: 64, v: 64 };
const { PI } = Math;

interface Case {
  readonly name: string;
  readonly strokes: readonly [Curve, Curve];
  /** mm³ */
  readonly volume: number;
  /** of the whole volume */
  readonly within: number;
  readonly genus: number;
  readonly components: number;
}

const solid = { within: 0.005, genus: 0, components: 1 };

const cases: Case[] = [
  {
    ...solid,
    name: 'two parallel lines: a cylinder',
    strokes: [line([-10, 0], [-10, 50]), line([10, 0], [10, 50])],
    volume: PI * 100 * 50,
  },
  {
    ...solid,
    name: 'a thin rod keeps its ends',
    strokes: [line([-1, 0], [-1, 100]), line([1, 0], [1, 100])],
    volume: PI * 100,
  },
  {
    ...solid,
    name: 'two half circles: a sphere',
    strokes: [halfCircle(50, -1), halfCircle(50, 1)],
    volume: (4 / 3) * PI * 50 ** 3,
    within: 0.01,
  },
  {
    ...solid,
    name: 'two legs: a cone',
    strokes: [line([0, 50], [-20, 0]), line([0, 50], [20, 0])],
    volume: (PI * 400 * 50) / 3,
  },
  {
    ...solid,
    name: 'lines that lean: a slanted cylinder',
    strokes: [line([-10, 0], [20, 50]), line([10, 0], [40, 50])],
    volume: PI * 100 * 50,
  },
  {
    ...solid,
    name: 'lines that cross: a double cone',
    strokes: [line([-20, 50], [20, -50]), line([20, 50], [-20, -50])],
    volume: (2 * PI * 400 * 50) / 3,
    components: 2,
  },
  {
    ...solid,
    name: 'circles side by side: a torus',
    strokes: [circle(-30, 0, 10), circle(30, 0, 10, 1, 2)],
    volume: 2 * PI ** 2 * 30 * 100,
    within: 0.01,
    genus: 1,
  },
  {
    ...solid,
    name: 'nested circles: a ring',
    strokes: [circle(0, 0, 10), circle(0, 0, 30, -1, 1)],
    volume: 2 * PI ** 2 * 20 * 100,
    within: 0.01,
    genus: 1,
  },
  {
    ...solid,
    name: 'nested squares: a square ring, mitred',
    strokes: [
      polygon([-10, -10], [10, -10], [10, 10], [-10, 10]),
      polygon([20, 20], [-20, 20], [-20, -20], [20, -20]),
    ],
    // between corners chords slant by s = −1 … 1, circles of radius 5 √(1 + s²) move 30 mm, 1/√(1 + s²) of it across
    volume: PI * 25 * 120 * ((Math.SQRT2 + Math.asinh(1)) / 2),
    genus: 1,
  },
];

describe('solids known in closed form, at 64 × 64', () => {
  for (const { name, strokes, within, genus, components, ...truth } of cases) {
    test(name, () => {
      const mesh = rotational(...strokes, TILTED, FINE);
      expect(topology(mesh)).toMatchObject({
        watertight: true,
        genus,
        components,
        degenerate: 0,
        finite: true,
      });
      expect(Math.abs(volume(mesh) / truth.volume - 1)).toBeLessThan(within);
      expect(normalError(mesh)).toBeLessThan(1e-6);
      expect(normalAgreement(mesh)).toBeGreaterThan(0.9);
    });

    test(`${name}, whatever the order and direction of the strokes`, () => {
      const [a, b] = strokes;
      const options = { caps: true, u: 12, v: 8 };
      const mesh = rotational(a, b, FLAT, options);
      const { min, max } = bounds(mesh);
      const size = length3(sub3(max, min));
      for (const [p, q] of orders(a, b)) {
        const other = rotational(p, q, FLAT, options);
        expect(volume(other) / volume(mesh)).toBeCloseTo(1, 4);
        if (!a.closed) expect(vertexDistance(other, mesh)).toBeLessThan(1e-6 * size);
      }
    });
  }
});

function orders(a: Curve, b: Curve): [Curve, Curve][] {
  // an X is symmetric: which of its two double cones is meant can only be told by the direction of drawing
  const cross = !a.closed && Math.abs(a.point(0)[0] - b.point(1)[0]) < 1e-9 && a.point(0)[0] !== 0;
  const both: [Curve, Curve][] = [
    [b, a],
    [reversed(a), reversed(b)],
    [reversed(b), reversed(a)],
  ];
  return cross ? both : [...both, [a, reversed(b)], [reversed(a), b], [b, reversed(a)]];
}

describe('normals', () => {
  test('of a sphere are radial, at the poles too', () => {
    const mesh = rotational(halfCircle(50, -1), halfCircle(50, 1), FLAT, FINE);
    for (let i = 0; i < mesh.normals.length / 3; i++) {
      const p = pointOf(mesh, i);
      const pole = Math.abs(p[1]) > 49.999;
      const expected = pole ? [0, Math.sign(p[1]), 0] : p.map((x) => x / 50);
      normalOf(mesh, i).forEach((x, k) => {
        expect(x).toBeCloseTo(expected[k]!, 4);
      });
    }
    expect(creases(mesh, 0.999)).toEqual([]);
  });

  test('of a double cone point away from its axis in both lobes, up to the apex', () => {
    const mesh = rotational(line([-20, 50], [20, -50]), line([20, 50], [-20, -50]), FLAT, {
      ...FINE,
      caps: false,
    });
    const slope = 20 / Math.hypot(20, 50);
    for (let i = 0; i < mesh.normals.length / 3; i++) {
      const [x, y, z] = pointOf(mesh, i);
      const normal = normalOf(mesh, i);
      // flanks lean towards the apex in the middle
      if (Math.abs(y) > 1e-3) {
        expect(normal[1]).toBeCloseTo(-Math.sign(y) * slope, 5);
        expect(normal[0] * x + normal[2] * z).toBeGreaterThan(0);
      } else expect(Math.abs(normal[1])).toBeLessThan(0.5);
    }
  });

  test('bent flanks: analytic normals agree with differences of a fine mesh', () => {
    const left = halfCircle(60, -1, -5);
    const right = line([10, 60], [40, 10], [15, -60]);
    const mesh = rotational(left, right, FLAT, { caps: false, u: 200, v: 200 });
    expect(normalAgreement(mesh)).toBeGreaterThan(0.995);
  });
});

describe('corners', () => {
  test('of both strokes make one crease, straight across, though they lie at other lengths', () => {
    const left = line([-10, 0], [-10, 27], [-40, 60]);
    const right = line([10, 0], [10, 33], [40, 60]);
    const found = creases(rotational(left, right, FLAT, { caps: false, u: 20, v: 16 }));
    expect(found).toHaveLength(16);
    for (const p of found) expect(length3(sub3(p, [0, 30, 0]))).toBeCloseTo(Math.hypot(10, 3), 4);
  });

  test('of one stroke alone make a crease through the corner', () => {
    const left = line([-10, 0], [-24, 30], [-10, 60]);
    const right = line([10, 0], [10, 60]);
    const mesh = rotational(left, right, FLAT, { caps: false, u: 20, v: 16 });
    const middle = mesh.positions.filter((_, i) => i % 3 === 0);
    expect(Math.min(...middle)).toBeCloseTo(-24, 5);
    const split = creases(mesh);
    expect(split.length).toBeGreaterThan(8);
    for (const p of split) expect(Math.abs(p[1] - 30)).toBeLessThan(1);
  });

  test('the corners of nested squares are mitred', () => {
    const inner = polygon([-10, -10], [10, -10], [10, 10], [-10, 10]);
    const outer = polygon([20, 20], [-20, 20], [-20, -20], [20, -20]);
    const found = creases(rotational(inner, outer, FLAT, { caps: true, u: 40, v: 16 }));
    // not at the top and the bottom of the ring, where both normals are the plane's
    expect(found).toHaveLength(4 * 14);
    for (const [x, y] of found) expect(Math.abs(Math.abs(x) - Math.abs(y))).toBeLessThan(1e-5);
  });
});

describe('ends', () => {
  test('open ends are discs with a crease; without caps they stay open', () => {
    const strokes = [line([-10, 0], [-10, 50]), line([10, 0], [10, 50])] as const;
    const open = topology(rotational(...strokes, FLAT, { caps: false, u: 8, v: 16 }));
    expect(open).toMatchObject({ watertight: false, badEdges: 32 });
    const found = creases(rotational(...strokes, FLAT, { caps: true, u: 8, v: 16 }), 0.1);
    expect(found).toHaveLength(32);
  });

  test('that nearly meet become poles and change the volume by less than their gap does', () => {
    const gap = 2;
    const left = halfCircle(50, -1, -gap / 2);
    const right = halfCircle(50, 1, gap / 2);
    const mesh = rotational(left, right, FLAT, FINE);
    expect(creases(mesh, 0.98)).toEqual([]);
    expect(bounds(mesh).max[1]).toBeCloseTo(50, 3);
    // revolved as drawn: π ∫ (1 + 50 sin θ)² 50 sin θ dθ
    const asDrawn = PI * 50 * (2 + 50 * PI + (2500 * 4) / 3);
    expect(volume(mesh) / asDrawn).toBeGreaterThan(0.98);
    expect(volume(mesh) / asDrawn).toBeLessThan(1);
  });

  test('tips that overshoot are trimmed where they cross', () => {
    const left = line([0.5, 51], [-20, 0]);
    const right = line([-0.5, 51], [20, 0]);
    expect(topology(rotational(left, right, FLAT, FINE))).toMatchObject({ components: 1, watertight: true });
  });

  test('strokes that start tangent to each other make a spike', () => {
    const wall = (side: 1 | -1) =>
      line(...Array.from({ length: 33 }, (_, i) => [(side * i * i) / 50, 60 - i] as const));
    const mesh = rotational(wall(-1), wall(1), FLAT, FINE);
    expect(topology(mesh)).toMatchObject({ watertight: true, genus: 0, finite: true });
    expect(volume(mesh)).toBeGreaterThan(0);
  });
});

describe('worst cases', () => {
  test('from 3 × 3 to 200 × 200 the mesh stays closed and outward', () => {
    for (const n of [3, 4, 5, 12, 33, 200]) {
      for (const { strokes, genus, components } of n > 100 ? cases.slice(5, 7) : cases) {
        const mesh = rotational(...strokes, FLAT, { caps: true, u: n, v: n });
        expect(topology(mesh)).toMatchObject({ watertight: true, genus, components, finite: true });
        expect(volume(mesh)).toBeGreaterThan(0);
        expect(normalAgreement(mesh)).toBeGreaterThan(0);
      }
    }
  });

  test('at 1e-6 and 1e6 mm', () => {
    for (const scale of [1e-6, 1e6]) {
      const mesh = rotational(halfCircle(50 * scale, -1), halfCircle(50 * scale, 1), FLAT, FINE);
      expect(topology(mesh)).toMatchObject({ watertight: true, genus: 0, degenerate: 0, finite: true });
      expect(volume(mesh) / ((4 / 3) * PI * (50 * scale) ** 3)).toBeCloseTo(1, 2);
    }
  });

  test('a dot and a stroke: a slanted cone', () => {
    const mesh = rotational(line([0, 40]), line([-10, 0], [30, 0]), FLAT, FINE);
    expect(topology(mesh)).toMatchObject({ watertight: true, finite: true });
  });

  test('strokes on each other, and dots, enclose nothing', () => {
    for (const [a, b] of [
      [line([0, 0], [10, 20]), line([0, 0], [10, 20])],
      [line([10, 20], [0, 0]), line([0, 0], [10, 20])],
      [circle(0, 0, 10), circle(0, 0, 10)],
      [line([1, 1]), line([1, 1])],
      [line([1, 1]), line([5, 5])],
    ] as const) {
      expect(rotational(a, b, FLAT, FINE).indices).toHaveLength(0);
    }
  });

  test('an open and a closed stroke still make a closed solid', () => {
    const mesh = rotational(circle(-20, 0, 10), line([20, -30], [20, 30]), FLAT, FINE);
    expect(topology(mesh)).toMatchObject({ watertight: true, finite: true });
    expect(volume(mesh)).toBeGreaterThan(0);
  });

  test('closed strokes that cross make pinched lobes, all outward', () => {
    const mesh = rotational(circle(-8, 0, 10), circle(8, 1, 10, -1, 0.7), FLAT, FINE);
    expect(topology(mesh)).toMatchObject({ watertight: true, genus: 0, components: 2, finite: true });
    expect(normalAgreement(mesh)).toBeGreaterThan(0);
  });

  test('numbers of quads that are none are refused', () => {
    const strokes = [line([-10, 0], [-10, 50]), line([10, 0], [10, 50])] as const;
    expect(() => rotational(...strokes, FLAT, { caps: true, u: Number.NaN, v: 8 })).toThrow(RangeError);
  });
});

describe('texture', () => {
  test('v runs once round every row, u never falls back', () => {
    const mesh = rotational(halfCircle(50, -1), halfCircle(50, 1), FLAT, { caps: true, u: 9, v: 7 });
    const { uvs } = mesh;
    for (let row = 0; 16 * row < uvs.length; row++) {
      for (let j = 1; j < 8; j++) {
        const at = 2 * (8 * row + j);
        expect(uvs[at]).toBe(uvs[16 * row]);
        expect(uvs[at + 1]!).toBeGreaterThan(uvs[at - 1]!);
      }
      if (row > 0) expect(uvs[16 * row]!).toBeGreaterThanOrEqual(uvs[16 * (row - 1)]!);
    }
    expect(Math.min(...uvs)).toBe(0);
    expect(Math.max(...uvs)).toBe(1);
  });
});

describe('random smooth strokes (seed 2006)', () => {
  test('closed, finite, not inside out, at scales from 1e-3 to 1e3', () => {
    const pair = fc
      .constantFrom(1e-3, 1, 1e3)
      .chain((scale) => fc.tuple(smoothStroke(scale), smoothStroke(scale)));
    fc.assert(
      fc.property(pair, fc.integer({ min: 3, max: 40 }), fc.integer({ min: 3, max: 24 }), ([a, b], u, v) => {
        const mesh = rotational(a, b, TILTED, { caps: true, u, v });
        expect(topology(mesh)).toMatchObject({ watertight: true, finite: true });
        expect(normalError(mesh)).toBeLessThan(1e-5);
        // coarse ones that overlap themselves may enclose less than nothing
        const fine = volume(mesh) < 0 ? rotational(a, b, TILTED, { caps: true, u: 256, v: 64 }) : mesh;
        expect(volume(fine)).toBeGreaterThanOrEqual(-1e-3 * a.length ** 3);
      }),
      { seed: 2006, numRuns: 80 },
    );
  }, 30_000);
});

describe('random strokes with corners (seed 511)', () => {
  test('that cross themselves and each other: closed and finite', () => {
    const pair = fc.boolean().chain((closed) => fc.tuple(bentStroke(closed), bentStroke(closed)));
    fc.assert(
      fc.property(pair, fc.integer({ min: 3, max: 40 }), ([a, b], u) => {
        const mesh = rotational(a, b, TILTED, { caps: true, u, v: 9 });
        expect(topology(mesh)).toMatchObject({ watertight: true, finite: true });
        expect(normalError(mesh)).toBeLessThan(1e-5);
      }),
      { seed: 511, numRuns: 100 },
    );
  }, 30_000);
});
