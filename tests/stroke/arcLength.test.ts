import { describe, expect, test } from 'vitest';
import type { Vec2 } from '../../src/math/vec.ts';
import { curveOf, polylineCurve } from '../../src/stroke/arcLength.ts';
import { splinePoint } from '../../src/stroke/bspline.ts';
import type { Curve } from '../../src/stroke/curve.ts';
import type { FilteredStroke } from '../../src/stroke/filter.ts';
import { normal } from '../fixtures/random.ts';
import { polygon } from '../fixtures/shapes.ts';

function net(count: number, seed: number): Vec2[] {
  const n = normal(seed);
  return Array.from({ length: count }, (_, i): Vec2 => [10 * i + 5 * n(), 20 * n()]);
}

const stroke = (
  pieces: readonly (readonly Vec2[])[],
  rest: Partial<FilteredStroke> = {},
): FilteredStroke => ({
  degree: 2,
  closed: false,
  periodic: false,
  pieces,
  pressure: [0, 1],
  ...rest,
});

/** Length of the stretch u0…u1 by 2n chords, their h² error taken out by comparing with n. */
function chords(curve: Curve, u0: number, u1: number, n = 1000): number {
  const sum = (parts: number) => {
    let total = 0;
    let before = curve.point(u0);
    for (let i = 1; i <= parts; i++) {
      const p = curve.point(u0 + ((u1 - u0) * i) / parts);
      total += Math.hypot(p[0] - before[0], p[1] - before[1]);
      before = p;
    }
    return total;
  };
  const [coarse, fine] = [sum(n), sum(2 * n)];
  return (4 * fine - coarse) / 3;
}

const cases: readonly (readonly [string, FilteredStroke])[] = [
  ['open quadratic', stroke([net(12, 1)])],
  ['open cubic', stroke([net(12, 2)], { degree: 3 })],
  ['closed quadratic', stroke([net(9, 3)], { closed: true, periodic: true })],
  ['closed cubic', stroke([net(9, 4)], { degree: 3, closed: true, periodic: true })],
];

describe.each(cases)('%s', (_, filtered) => {
  const curve = curveOf(filtered);

  test('equal steps of u are equal lengths, to 1e-6 of the whole', () => {
    for (let i = 0; i < 20; i++) {
      const part = chords(curve, i / 20, (i + 1 - 1e-12) / 20);
      expect(Math.abs(part / curve.length - 1 / 20)).toBeLessThan(1e-6);
    }
  });

  test('passes the spline, with its length', () => {
    const [points, spans] = [filtered.pieces[0]!, filtered.periodic ? 9 : 12 - filtered.degree];
    const on = Array.from({ length: 20_001 }, (__, i) =>
      splinePoint(points, filtered.degree, filtered.periodic, (i * spans) / 20_000),
    );
    const length = on.slice(1).reduce((sum, p, i) => sum + Math.hypot(p[0] - on[i]![0], p[1] - on[i]![1]), 0);
    expect(curve.length / length).toBeCloseTo(1, 6);
    for (const u of [0.1, 0.35, 0.8]) {
      const p = curve.point(u);
      expect(Math.min(...on.map((q) => Math.hypot(p[0] - q[0], p[1] - q[1])))).toBeLessThan(0.02);
    }
  });

  test('tangents are unit and along the curve', () => {
    for (let u = 0.013; u < 1; u += 0.05) {
      const [a, b] = [curve.point(u - 1e-6), curve.point(u + 1e-6)];
      const t = curve.tangent(u);
      expect(Math.hypot(t[0], t[1])).toBeCloseTo(1, 12);
      const k = 2e-6 * curve.length;
      expect(t[0]).toBeCloseTo((b[0] - a[0]) / k, 3);
      expect(t[1]).toBeCloseTo((b[1] - a[1]) / k, 3);
    }
  });

  test('open curves clamp and meet their ends exactly, closed ones wrap', () => {
    const points = filtered.pieces[0]!;
    if (curve.closed) {
      const [p, q] = [curve.point(0.3), curve.point(-2.7)];
      expect(p[0]).toBeCloseTo(q[0], 9);
      expect(curve.point(1)).toEqual(curve.point(0));
      expect(curve.corners).toEqual([]);
    } else {
      for (const u of [-1, 0]) expect(curve.point(u)).toEqual(points[0]);
      for (const u of [1, 2]) expect(curve.point(u)).toEqual(points.at(-1));
    }
  });
});

describe('corners', () => {
  const left = net(8, 5);
  const right: readonly Vec2[] = [left[7]!, ...net(8, 6).map((p): Vec2 => [p[0], p[1] + 200])];

  test('lie where pieces meet; both tangents are to be had there', () => {
    const curve = curveOf(stroke([left, right]));
    const alone = curveOf(stroke([left]));
    expect(curve.corners).toHaveLength(1);
    const u = curve.corners[0]!;
    expect(u).toBeCloseTo(alone.length / curve.length, 12);
    expect(curve.point(u)[0]).toBeCloseTo(left[7]![0], 9);
    const direction = (a: Vec2, b: Vec2) => Math.atan2(b[1] - a[1], b[0] - a[0]);
    const angle = (t: Vec2) => Math.atan2(t[1], t[0]);
    for (const near of [u, u - 1e-13, u + 1e-13]) {
      expect(angle(curve.tangent(near, -1))).toBeCloseTo(direction(left[6]!, left[7]!), 9);
      expect(angle(curve.tangent(near, 1))).toBeCloseTo(direction(right[0]!, right[1]!), 9);
      expect(curve.tangent(near)).toEqual(curve.tangent(near, 1));
    }
  });

  test('a closed stroke with one corner begins there', () => {
    const drop: Vec2[] = [
      [0, 0],
      [10, 5],
      [20, 8],
      [25, 0],
      [20, -8],
      [10, -5],
      [0, 0],
    ];
    const curve = curveOf(stroke([drop], { closed: true }));
    expect(curve.corners).toEqual([0]);
    for (const u of [0, 1, -3]) {
      expect(Math.atan2(...curve.tangent(u, 1))).toBeCloseTo(Math.atan2(10, 5), 9);
      expect(Math.atan2(...curve.tangent(u, -1))).toBeCloseTo(Math.atan2(-10, 5), 9);
    }
  });
});

describe('pressure', () => {
  test('is even along an open stroke', () => {
    const curve = curveOf(stroke([net(9, 1)], { pressure: [0, 0.5, 0.25] }));
    for (const [u, p] of [
      [-1, 0],
      [0, 0],
      [0.25, 0.25],
      [0.5, 0.5],
      [0.75, 0.375],
      [1, 0.25],
    ] as const) {
      expect(curve.pressure(u)).toBeCloseTo(p, 12);
    }
  });

  test('wraps on a closed one', () => {
    const curve = curveOf(stroke([net(9, 1)], { closed: true, periodic: true, pressure: [0, 1] }));
    for (const [u, p] of [
      [0, 0],
      [0.25, 0.5],
      [0.5, 1],
      [0.75, 0.5],
      [1, 0],
      [1.25, 0.5],
    ] as const) {
      expect(curve.pressure(u)).toBeCloseTo(p, 12);
    }
  });
});

describe('worst cases', () => {
  test('a cusp, doubled control points and a line drawn back on itself keep finite tangents and even lengths', () => {
    const worst: readonly (readonly Vec2[])[] = [
      [
        [0, 0],
        [10, 0],
        [0, 0],
        [0, 10],
      ],
      [
        [0, 0],
        [0, 0],
        [0, 0],
        [10, 0],
        [10, 0],
      ],
      [
        [0, 0],
        [20, 0],
        [0, 0],
      ],
      [
        [0, 0],
        [10, 10],
        [10, 10],
        [20, 0],
        [20, 0],
        [20, 0],
      ],
    ];
    for (const points of worst) {
      const curve = curveOf(stroke([points]));
      let covered = 0;
      for (let i = 0; i <= 100; i++) {
        for (const side of [-1, 1] as const) {
          const t = curve.tangent(i / 100, side);
          expect(Math.hypot(t[0], t[1])).toBeCloseTo(1, 9);
        }
        if (i > 0) covered += chords(curve, (i - 1) / 100, i / 100, 20);
      }
      expect(covered / curve.length).toBeCloseTo(1, 3);
    }
  });

  test('a stroke of no length is a point', () => {
    const curve = curveOf(
      stroke([
        [
          [3, 4],
          [3, 4],
          [3, 4],
        ],
      ]),
    );
    expect(curve.length).toBe(0);
    expect(curve.point(0.5)).toEqual([3, 4]);
    expect(curve.tangent(0.5)).toEqual([1, 0]);
  });

  for (const scale of [1e-9, 1e9]) {
    test(`scaled by ${scale}`, () => {
      const points = net(10, 8);
      const scaled = curveOf(stroke([points.map(([x, y]): Vec2 => [x * scale, y * scale])]));
      const curve = curveOf(stroke([points]));
      expect(scaled.length / scale / curve.length).toBeCloseTo(1, 12);
      for (const u of [0.2, 0.7]) {
        expect(scaled.point(u)[0] / scale).toBeCloseTo(curve.point(u)[0], 7);
        expect(scaled.tangent(u)[0]).toBeCloseTo(curve.tangent(u)[0], 7);
      }
    });
  }
});

describe('polylineCurve', () => {
  test('a closed square has its four corners and sides', () => {
    const curve = polylineCurve(polygon(4, 10).slice(0, 4), true);
    expect(curve.length).toBeCloseTo(40 * Math.SQRT2, 12);
    expect(curve.corners).toHaveLength(4);
    for (const [i, u] of curve.corners.entries()) expect(u).toBeCloseTo(i / 4, 12);
    expect(curve.point(0.125)[0]).toBeCloseTo(5, 12);
    expect(curve.tangent(0.25, -1)[0]).toBeCloseTo(-Math.SQRT1_2, 12);
    expect(curve.tangent(0.25, 1)[0]).toBeCloseTo(-Math.SQRT1_2, 12);
    expect(curve.tangent(0.25, 1)[1]).toBeCloseTo(-Math.SQRT1_2, 12);
  });

  test('a fine circle has no corners; an open zigzag only inner ones; doubled points do no harm', () => {
    expect(polylineCurve(polygon(100, 10).slice(0, 100), true).corners).toEqual([]);
    const zigzag = polylineCurve(
      [
        [0, 0],
        [10, 10],
        [10, 10],
        [20, 0],
      ],
      false,
    );
    expect(zigzag.corners).toEqual([0.5]);
    expect(zigzag.point(1)).toEqual([20, 0]);
    expect(polylineCurve([[1, 2]], false).point(0.3)).toEqual([1, 2]);
  });
});
