import fc from 'fast-check';
import { describe, expect, test } from 'vitest';
import { dot3, length3, sub3 } from '../../src/math/tuple.ts';
import { topology } from '../../src/mesh/check.ts';
import { bounds, volume } from '../../src/mesh/measure.ts';
import type { Curve } from '../../src/stroke/curve.ts';
import { tube } from '../../src/surface/tube.ts';
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
  smoothStroke,
  TILTED,
  withPressure,
} from './curves.ts';

const FINE = { radius: 10, pressure: false, caps: 'round', u: 64, v: 64 } as const;
const { PI } = Math;
const BALL = (4 / 3) * PI * 1000;

interface Case {
  readonly name: string;
  readonly stroke: Curve;
  readonly caps: 'round' | 'flat';
  /** mm³ */
  readonly volume: number;
  readonly genus: number;
}

const cases: Case[] = [
  {
    name: 'a line with flat ends: a cylinder',
    stroke: line([0, 0], [30, 40]),
    caps: 'flat',
    volume: PI * 100 * 50,
    genus: 0,
  },
  {
    name: 'a line with round ends: a cylinder and a ball',
    stroke: line([0, 0], [30, 40]),
    caps: 'round',
    volume: PI * 100 * 50 + BALL,
    genus: 0,
  },
  { name: 'a dot: a ball', stroke: line([3, 4]), caps: 'round', volume: BALL, genus: 0 },
  {
    name: 'half a circle: half a torus and a ball',
    stroke: halfCircle(50, 1),
    caps: 'round',
    volume: PI ** 2 * 50 * 100 + BALL,
    genus: 0,
  },
  {
    name: 'a circle: a torus',
    stroke: circle(5, 5, 40, -1),
    caps: 'round',
    volume: 2 * PI ** 2 * 40 * 100,
    genus: 1,
  },
  {
    // both mitred halves end in the bisecting plane through the corner
    name: 'an elbow: as long as its legs',
    stroke: line([0, 0], [0, 50], [50, 50]),
    caps: 'flat',
    volume: PI * 100 * 100,
    genus: 0,
  },
  {
    name: 'a square frame',
    stroke: polygon([0, 0], [60, 0], [60, 60], [0, 60]),
    caps: 'flat',
    volume: PI * 100 * 240,
    genus: 1,
  },
];

describe('solids known in closed form, at 64 × 64', () => {
  for (const { name, stroke, caps, genus, ...truth } of cases) {
    test(name, () => {
      const mesh = tube(stroke, TILTED, { ...FINE, caps });
      expect(topology(mesh)).toMatchObject({
        watertight: true,
        genus,
        components: 1,
        degenerate: 0,
        finite: true,
      });
      expect(Math.abs(volume(mesh) / truth.volume - 1)).toBeLessThan(0.005);
      expect(normalError(mesh)).toBeLessThan(1e-6);
      expect(normalAgreement(mesh)).toBeGreaterThan(0.9);
    });
  }
});

describe('frames', () => {
  test('a closed tube has no seam: every column keeps its height and its distance', () => {
    const mesh = tube(circle(0, 0, 40), FLAT, { ...FINE, u: 30, v: 12 });
    for (let i = 0; i < mesh.positions.length / 3; i++) {
      const [x, y, z] = pointOf(mesh, i);
      const angle = (2 * PI * (i % 13)) / 12;
      expect(Math.hypot(x, y)).toBeCloseTo(40 - 10 * Math.cos(angle), 3);
      expect(z).toBeCloseTo(-10 * Math.sin(angle), 4);
    }
    expect(creases(mesh, 0.999)).toEqual([]);
  });

  test('v = 0 lies on the left of the stroke', () => {
    const mesh = tube(line([0, 0], [50, 0]), FLAT, { ...FINE, caps: 'none' });
    expect(pointOf(mesh, 0)[1]).toBeCloseTo(10, 5);
  });
});

describe('ends', () => {
  test('round ends are hemispheres round the ends of the stroke, without a crease', () => {
    const mesh = tube(line([0, 0], [50, 0]), FLAT, FINE);
    for (let i = 0; i < mesh.positions.length / 3; i++) {
      const p = pointOf(mesh, i);
      if (p[0] > 0 && p[0] < 50) continue;
      const away = sub3(p, [p[0] < 25 ? 0 : 50, 0, 0]);
      expect(length3(away)).toBeCloseTo(10, 4);
      expect(dot3(normalOf(mesh, i), away)).toBeCloseTo(10, 4);
    }
    expect(bounds(mesh).max[0]).toBeCloseTo(60, 5);
    expect(creases(mesh, 0.999)).toEqual([]);
  });

  test('flat ends have a crease, no ends are open', () => {
    expect(creases(tube(line([0, 0], [50, 0]), FLAT, { ...FINE, caps: 'flat' }), 0.1)).toHaveLength(128);
    const open = topology(tube(line([0, 0], [50, 0]), FLAT, { ...FINE, caps: 'none' }));
    expect(open).toMatchObject({ watertight: false, badEdges: 128 });
  });
});

describe('corners', () => {
  test('up to 100° are mitred: one crease, an ellipse in the bisecting plane', () => {
    const mesh = tube(line([0, 0], [0, 50], [50, 50]), FLAT, { ...FINE, caps: 'none' });
    const found = creases(mesh, 0.9999);
    // the two points above and below the corner have one normal
    expect(found).toHaveLength(62);
    for (const [x, y, z] of found) {
      expect(x).toBeCloseTo(50 - y, 4);
      expect(x ** 2 / 100 + z ** 2 / 100).toBeCloseTo(1, 4);
    }
  });

  test('all points near a mitre stay on the cylinders of the legs', () => {
    const mesh = tube(line([0, 0], [0, 50], [50, 50]), FLAT, { ...FINE, caps: 'none' });
    for (let i = 0; i < mesh.positions.length / 3; i++) {
      const [x, y, z] = pointOf(mesh, i);
      const distance = y - 50 < -x ? Math.hypot(x, z) : Math.hypot(y - 50, z);
      expect(distance).toBeCloseTo(10, 3);
    }
  });

  test('sharper turns are ball joints: no crease, no spike', () => {
    const mesh = tube(line([0, 0], [50, 0], [0, 5]), FLAT, FINE);
    expect(topology(mesh)).toMatchObject({ watertight: true, genus: 0, degenerate: 0 });
    expect(creases(mesh, 0.99)).toEqual([]);
    expect(bounds(mesh).max[0]).toBeCloseTo(60, 1);
  });

  test('a stroke that returns on itself', () => {
    const mesh = tube(line([0, 0], [50, 0], [10.3, 0.01]), FLAT, FINE);
    expect(topology(mesh)).toMatchObject({ watertight: true, finite: true });
  });

  // the leg that comes back begins in the very ring in which the other ended, and welding makes one of them
  test.fails('a stroke that returns on itself exactly', () => {
    const mesh = tube(line([0, 0], [50, 0], [10.3, 0]), FLAT, FINE);
    expect(topology(mesh).watertight).toBe(true);
  });

  test('sharp corners of closed strokes, the seam included', () => {
    const mesh = tube(polygon([0, 0], [90, 0], [0, 90]), FLAT, FINE);
    expect(topology(mesh)).toMatchObject({ watertight: true, genus: 1, degenerate: 0 });
  });
});

describe('pressure', () => {
  const pressed = { ...FINE, pressure: true } as const;

  test('0.5 is the radius itself, 0 a fifth and 1 nine fifths of it', () => {
    for (const [p, factor] of [
      [0.5, 1],
      [0, 0.2],
      [1, 1.8],
    ] as const) {
      const mesh = tube(
        withPressure(line([0, 0], [50, 0]), () => p),
        FLAT,
        { ...pressed, caps: 'none' },
      );
      expect(bounds(mesh).max[2]).toBeCloseTo(10 * factor, 4);
    }
  });

  test('that rises evenly makes a cone, whose normals lean back by its slope', () => {
    const cone = withPressure(line([0, 0], [50, 0]), (u) => u);
    const mesh = tube(cone, FLAT, { ...pressed, caps: 'none' });
    const lean = -16 / Math.hypot(16, 50);
    for (let i = 0; i < mesh.normals.length / 3; i++) expect(normalOf(mesh, i)[0]).toBeCloseTo(lean, 4);
    const solid = volume(tube(cone, FLAT, { ...pressed, caps: 'flat' }));
    expect(solid / ((PI * 50 * (4 + 36 + 324)) / 3)).toBeCloseTo(1, 2);
  });

  test('round ends of a cone touch it without a crease', () => {
    const mesh = tube(
      withPressure(line([0, 0], [50, 0]), (u) => u),
      FLAT,
      pressed,
    );
    expect(creases(mesh, 0.9999)).toEqual([]);
    expect(normalAgreement(mesh)).toBeGreaterThan(0.99);
  });

  test('on a bend: normals agree with the surface', () => {
    const wavy = withPressure(halfCircle(60, 1), (u) => 0.5 + 0.4 * Math.sin(9 * u));
    expect(normalAgreement(tube(wavy, FLAT, { ...pressed, u: 200, v: 100 }))).toBeGreaterThan(0.995);
  });
});

describe('worst cases', () => {
  test('from 3 × 3 to 200 × 200 the mesh stays closed and outward', () => {
    for (const n of [3, 4, 5, 12, 33, 200]) {
      for (const { stroke, caps, genus } of n > 100 ? cases.slice(3, 5) : cases) {
        const mesh = tube(stroke, FLAT, { ...FINE, caps, u: n, v: n });
        expect(topology(mesh)).toMatchObject({ watertight: true, genus, finite: true });
        expect(volume(mesh)).toBeGreaterThan(0);
        expect(normalAgreement(mesh)).toBeGreaterThan(0);
      }
    }
  });

  test('a radius larger than the bends overlaps itself, but stays closed and finite', () => {
    for (const stroke of [halfCircle(5, 1), circle(0, 0, 3), line([0, 0], [4, 0], [4, 4], [0, 4], [0, 1])]) {
      const mesh = tube(stroke, FLAT, FINE);
      expect(topology(mesh)).toMatchObject({ watertight: true, finite: true });
      expect(normalError(mesh)).toBeLessThan(1e-5);
    }
  });

  test('at 1e-6 and 1e6 mm', () => {
    for (const scale of [1e-6, 1e6]) {
      const mesh = tube(line([0, 0], [50 * scale, 0]), FLAT, { ...FINE, radius: 10 * scale });
      expect(topology(mesh)).toMatchObject({ watertight: true, genus: 0, degenerate: 0, finite: true });
      expect(volume(mesh) / ((PI * 5000 + BALL) * scale ** 3)).toBeCloseTo(1, 2);
    }
  });

  test('closed or flat dots enclose nothing', () => {
    expect(tube(line([1, 1]), FLAT, { ...FINE, caps: 'flat' }).indices).toHaveLength(0);
    expect(tube(polygon([1, 1]), FLAT, FINE).indices).toHaveLength(0);
  });

  test('a radius that is none is refused', () => {
    for (const radius of [0, -1, Number.NaN, Infinity]) {
      expect(() => tube(line([0, 0], [1, 0]), FLAT, { ...FINE, radius })).toThrow(RangeError);
    }
  });
});

describe('random smooth strokes (seed 52)', () => {
  test('closed, finite and outward, at scales from 1e-3 to 1e3', () => {
    const stroke = fc
      .constantFrom(1e-3, 1, 1e3)
      .chain((scale) =>
        fc.tuple(fc.constant(scale), smoothStroke(scale), fc.double({ min: 0.01, max: 0.5, noNaN: true })),
      );
    fc.assert(
      fc.property(
        stroke,
        fc.integer({ min: 3, max: 40 }),
        fc.integer({ min: 3, max: 24 }),
        ([scale, curve, radius], u, v) => {
          const mesh = tube(curve, TILTED, { ...FINE, radius: radius * scale, u, v });
          expect(topology(mesh)).toMatchObject({ watertight: true, genus: 0, finite: true });
          expect(normalError(mesh)).toBeLessThan(1e-5);
          expect(volume(mesh)).toBeGreaterThan(0);
        },
      ),
      { seed: 52, numRuns: 60 },
    );
  }, 30_000);
});

describe('random strokes with corners (seed 512)', () => {
  test('that cross themselves: closed and finite', () => {
    const stroke = fc.boolean().chain(bentStroke);
    fc.assert(
      fc.property(stroke, fc.integer({ min: 3, max: 40 }), (curve, u) => {
        const mesh = tube(curve, TILTED, { ...FINE, radius: 3.1, u, v: 9 });
        expect(topology(mesh)).toMatchObject({ watertight: true, finite: true });
        expect(normalError(mesh)).toBeLessThan(1e-5);
      }),
      { seed: 512, numRuns: 100 },
    );
  }, 30_000);
});
