import { describe, expect, test } from 'vitest';
import { kernelNamed } from '../../src/kernel/index.ts';
import type { Vec3 } from '../../src/math/vec.ts';
import { expandQuadratic, type QuadraticSkel } from '../../src/skeleton/quadratic.ts';
import { random } from '../fixtures/random.ts';
import { type Curve, curveField, PARAMS, sumField } from './curves.ts';

const spline: QuadraticSkel = {
  type: 'quadratic',
  points: [
    [0, 0, 0],
    [3, 4, 0],
    [6, 0, 1],
    [8, -3, 2],
    [7, -6, 2],
  ],
  weights: [1, 2, 0.5],
  fieldError: 1e-3,
  distance: 0,
};

const pieces = [0, 1].map((k): Curve => {
  const [a, b, c] = spline.points.slice(2 * k, 2 * k + 3) as [Vec3, Vec3, Vec3];
  const [w0, w1] = spline.weights.slice(k, k + 2) as [number, number];
  const each = (f: (i: 0 | 1 | 2) => number): Vec3 => [f(0), f(1), f(2)];
  return {
    at: (t) => each((i) => (1 - t) * (1 - t) * a[i] + 2 * t * (1 - t) * b[i] + t * t * c[i]),
    speed: (t) => Math.hypot(...each((i) => 2 * (1 - t) * (b[i] - a[i]) + 2 * t * (c[i] - b[i]))),
    weight: (t) => (1 - t) * w0 + t * w1,
  };
});
const truth = (name: string, params: object, p: Vec3) =>
  pieces.reduce((sum, piece) => sum + curveField(piece, name, params, p, 100), 0);

function* points(count: number, seed: number): Generator<Vec3> {
  const next = random(seed);
  for (let i = 0; i < count; i++) {
    const [x, y, z] = pieces[i % 2]!.at(next());
    yield [x + 2 * (next() - 0.5), y + 2 * (next() - 0.5), z + 2 * (next() - 0.5)];
  }
  yield spline.points[2]!;
}

describe('quadratic splines', () => {
  test.each(PARAMS)('%s: the error of the field is below what was asked for (seed 95)', (name, params) => {
    for (const fieldError of [0.1, 1e-2, 1e-3]) {
      const segments = expandQuadratic({ ...spline, fieldError }, kernelNamed(name)!, params);
      const field = sumField(segments, name, params);
      const errors = [...points(12, 95)].map((p) => Math.abs(field(p) - truth(name, params, p)));
      expect(Math.max(...errors)).toBeLessThan(fieldError);
      expect(Math.max(...errors)).toBeGreaterThan(0.005 * fieldError);
    }
  });

  test('inverse squared: from the distance on (seed 96)', () => {
    const segments = expandQuadratic(
      { ...spline, fieldError: 0.01, distance: 0.5 },
      kernelNamed('inverseSquared')!,
      {},
    );
    const field = sumField(segments, 'inverseSquared', {});
    for (const [x, y] of points(12, 96)) {
      const p: Vec3 = [x, y, 3.5];
      expect(Math.abs(field(p) - truth('inverseSquared', {}, p))).toBeLessThan(0.01);
    }
  });

  test('a straight, evenly run piece is one segment', () => {
    const line: QuadraticSkel = {
      ...spline,
      points: [
        [0, 0, 0],
        [2, 0, 0],
        [4, 0, 0],
      ],
      weights: [1, 3],
    };
    expect(expandQuadratic(line, kernelNamed('cauchy')!, { s: 1 })).toEqual([
      { type: 'segment', a: [0, 0, 0], b: [4, 0, 0], weights: [1, 0.5] },
    ]);
  });

  test('a piece that ends where it began keeps its mass', () => {
    const there: QuadraticSkel = {
      ...spline,
      points: [
        [0, 0, 0],
        [2, 0, 0],
        [0, 0, 0],
      ],
      weights: [1, 1],
    };
    const field = sumField(expandQuadratic(there, kernelNamed('cauchy')!, { s: 1 }), 'cauchy', { s: 1 });
    const back: Curve = {
      at: (t) => [4 * t * (1 - t), 0, 0],
      speed: (t) => Math.abs(4 - 8 * t),
      weight: () => 1,
    };
    for (const p of [
      [0.5, 0, 0],
      [1, 0.3, 0],
      [3, 1, 1],
    ] as const) {
      expect(Math.abs(field(p) - curveField(back, 'cauchy', { s: 1 }, p))).toBeLessThan(1e-3);
    }
  });

  test('bent places get more chords than straight ones', () => {
    const bent: QuadraticSkel = {
      ...spline,
      points: [
        [0, 0, 0],
        [9, 0, 0],
        [9, 1, 0],
      ],
      weights: [1, 1],
    };
    const lengths = expandQuadratic(bent, kernelNamed('cauchy')!, { s: 1 }).map(({ a, b }) =>
      Math.hypot(b[0] - a[0], b[1] - a[1]),
    );
    expect(Math.max(...lengths) / Math.min(...lengths)).toBeGreaterThan(2);
  });

  test.each<[Partial<QuadraticSkel>, RegExp]>([
    [{ points: spline.points.slice(0, 4) }, /3 weights need 5 points/],
    [{ weights: [1] }, /at least 3/],
    [{ fieldError: -1 }, /fieldError/],
    [{ fieldError: 1e-13 }, /more than 4096 chords/],
    [{ weights: [1, Number.NaN, 1] }, /weights of a spline must be numbers within ±1e\+60, found NaN/],
    // the pieces are straight, so that only their masses cannot be met: the error named is the one that was asked for
    [
      {
        points: [0, 1, 4, 4, 4].map((x) => [x, 0, 0] as const),
        weights: [1e9, 1e9, 0],
        fieldError: 1e-12,
      },
      /fieldError 1e-12 needs more/,
    ],
    [{ points: spline.points.map(() => [1, 1, 1] as const) }, /apart/],
  ])('%j is refused', (change, message) => {
    expect(() => expandQuadratic({ ...spline, ...change }, kernelNamed('cauchy')!, { s: 1 })).toThrow(
      message,
    );
  });
});
