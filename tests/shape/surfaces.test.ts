/** Against what each shape is by definition: points known to be on it, distances known by analysis; and refusals. */
import { describe, expect, test } from 'vitest';
import { cos, sin } from '../../src/math/trig.ts';
import { bindShape, type Shape } from '../../src/shape/index.ts';
import { FieldError } from '../../src/skeleton/skeleton.ts';
import { random } from '../fixtures/random.ts';

type Point = readonly [x: number, y: number, z: number];

/** Points on the surface by a parametrisation of it, from two random numbers. */
const onSurface: readonly [Shape, (u: number, v: number) => Point][] = [
  [{ type: 'sphere', radius: 7 }, (u, v) => ball(u, v, 7)],
  [
    { type: 'ellipsoid', radii: [7, 2, 3] },
    (u, v) => ball(u, v, 1).map((x, i) => x * [7, 2, 3][i]!) as unknown as Point,
  ],
  [{ type: 'box', half: [7, 2, 3] }, (u, v) => [7, 4 * u - 2, 6 * v - 3]],
  [{ type: 'box', half: [7, 2, 3] }, (u, v) => [14 * u - 7, -2, 6 * v - 3]],
  [{ type: 'roundedBox', half: [7, 2, 3], radius: 1 }, (u, v) => [12 * u - 6, -2, 4 * v - 2]],
  [
    { type: 'roundedBox', half: [7, 2, 3], radius: 1 },
    (u, v) => ball(u, v, 1).map((x, i) => x + (x < 0 ? -1 : 1) * [6, 1, 2][i]!) as unknown as Point,
  ],
  [{ type: 'cylinder', radius: 4, half: 6 }, (u, v) => [4 * cos(7 * u), 12 * v - 6, 4 * sin(7 * u)]],
  [{ type: 'cylinder', radius: 4, half: 6 }, (u, v) => [4 * v * cos(7 * u), 6, 4 * v * sin(7 * u)]],
  [{ type: 'capsule', radius: 4, half: 6 }, (u, v) => [4 * cos(7 * u), 12 * v - 6, 4 * sin(7 * u)]],
  [
    { type: 'capsule', radius: 4, half: 6 },
    (u, v) => {
      const [x, y, z] = ball(u, v, 4);
      return [x, y + (y < 0 ? -6 : 6), z];
    },
  ],
  [
    { type: 'torus', ring: 9, tube: 2 },
    (u, v) => {
      const rho = 9 + 2 * cos(7 * u);
      return [rho * cos(7 * v), 2 * sin(7 * u), rho * sin(7 * v)];
    },
  ],
  [{ type: 'halfSpace', normal: [0, 0, 2], offset: 5 }, (u, v) => [u, v, 5]],
  [
    { type: 'quadric', squares: [-1, 0, -1], products: [0, 0, 0], linear: [0, 4, 0], constant: 0 },
    (u, v) => [u, (u * u + v * v) / 4, v],
  ],
];

function ball(u: number, v: number, radius: number): Point {
  const y = 2 * u - 1;
  const rho = Math.sqrt(1 - y * y);
  return [radius * rho * cos(7 * v), radius * y, radius * rho * sin(7 * v)];
}

describe('surfaces', () => {
  test.each(onSurface)('%j is 0 on its surface, a step inwards positive (seed 5)', (shape, point) => {
    const field = bindShape(shape);
    const next = random(5);
    const out = new Float64Array(4);
    for (let i = 0; i < 200; i++) {
      const p = point(next(), next());
      field.evaluate(...p, out);
      expect(Math.abs(out[0]!)).toBeLessThan(1e-14 * 20);
      const [x, y, z] = p.map((c, k) => c + 1e-3 * out[k + 1]!) as [number, number, number];
      expect(field.value(x, y, z)).toBeCloseTo(1e-3, 5);
    }
  });

  test('distances known by analysis', () => {
    const at = (shape: Shape, ...p: Point) => bindShape(shape).value(...p);
    expect(at({ type: 'sphere', radius: 3 }, 0, 0, 0)).toBe(3);
    expect(at({ type: 'box', half: [1, 2, 3] }, 4, 6, 3)).toBe(-5);
    expect(at({ type: 'box', half: [1, 2, 3] }, 0, 0, 0)).toBe(1);
    expect(at({ type: 'roundedBox', half: [2, 3, 4], radius: 1 }, 4, 6, 3)).toBe(-4);
    expect(at({ type: 'cylinder', radius: 2, half: 3 }, 0, 7, 5)).toBe(-5);
    expect(at({ type: 'capsule', radius: 2, half: 3 }, 3, 7, 0)).toBe(-3);
    expect(at({ type: 'torus', ring: 5, tube: 1 }, 0, 0, 0)).toBe(-4);
    expect(at({ type: 'torus', ring: 5, tube: 1 }, 0, 12, 0)).toBe(-12);
    expect(at({ type: 'halfSpace', normal: [3, 0, 4], offset: 2 }, 5, 1, 5)).toBe(-5);
    expect(at({ type: 'ellipsoid', radii: [4, 3, 2] }, 0, 0, 0)).toBe(2);
  });

  test('an ellipsoid written as a quadric has the same inside (seed 6)', () => {
    const one = bindShape({ type: 'ellipsoid', radii: [2, 3, 4] });
    const squares = [-1 / 4, -1 / 9, -1 / 16] as const;
    const other = bindShape({
      type: 'quadric',
      squares,
      products: [0, 0, 0],
      linear: [0, 0, 0],
      constant: 1,
    });
    const next = random(6);
    for (let i = 0; i < 500; i++) {
      const p = [8 * next() - 4, 8 * next() - 4, 8 * next() - 4] as const;
      expect(Math.sign(one.value(...p))).toBe(Math.sign(other.value(...p)));
    }
    other.box!.max.forEach((x, i) => {
      expect(x).toBeCloseTo(i + 2, 12);
    });
  });

  const none = { products: [0, 0, 0], linear: [0, 0, 0] } as const;
  test.each<[Shape, RegExp]>([
    [{ type: 'sphere', radius: 0 }, /radius must be above 0 mm, got 0/],
    [{ type: 'sphere', radius: Number.NaN }, /radius/],
    [{ type: 'ellipsoid', radii: [1, -2, 3] }, /radii\[1\].*-2/],
    [{ type: 'box', half: [1, 1, Infinity] }, /half\[2\]/],
    [{ type: 'roundedBox', half: [1, 2, 3], radius: 1.5 }, /radius must be at most/],
    [{ type: 'cylinder', radius: 1, half: -1 }, /half/],
    [{ type: 'capsule', radius: 1, half: -1 }, /half/],
    [{ type: 'torus', ring: 1, tube: 2 }, /tube must be at most ring/],
    [{ type: 'halfSpace', normal: [0, 0, 0], offset: 1 }, /normal/],
    [{ type: 'halfSpace', normal: [0, 1, 0], offset: Infinity }, /offset/],
    [{ type: 'quadric', squares: [0, 0, 0], ...none, constant: 1 }, /all coefficients/],
    [{ type: 'quadric', squares: [-1, -1, -1], ...none, constant: -1 }, /no inside/],
    [{ type: 'quadric', squares: [Number.NaN, 0, 0], ...none, constant: -1 }, /coefficients must be numbers/],
    [{ type: 'pyramid' } as unknown as Shape, /unknown shape 'pyramid'/],
  ])('%j is refused', (shape, message) => {
    expect(() => bindShape(shape)).toThrow(message);
    expect(() => bindShape(shape)).toThrow(FieldError);
  });
});
