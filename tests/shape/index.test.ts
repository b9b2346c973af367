/** One suite over every shape of the list; a new one is tested without a line here. */
import { describe, expect, test } from 'vitest';
import type { Vec3 } from '../../src/math/vec.ts';
import { bindShape, kindOf, type Shape, shapes } from '../../src/shape/index.ts';
import type { Field } from '../../src/shape/shape.ts';
import { random } from '../fixtures/random.ts';

type Point = [x: number, y: number, z: number];

/** Where the shape is looked at, mm: about its box, or about the origin. */
function region(field: Field): { readonly centre: Vec3; readonly half: Vec3 } {
  const { min, max } = field.box ?? { min: [-10, -10, -10], max: [10, 10, 10] };
  const axis = (f: (i: number) => number): Vec3 => [f(0), f(1), f(2)];
  return { centre: axis((i) => (min[i]! + max[i]!) / 2), half: axis((i) => (max[i]! - min[i]!) / 2) };
}

/** Uniform in the region, `grown` times as large. */
function pointsAround(field: Field, count: number, grown: number, seed: number): Point[] {
  const { centre, half } = region(field);
  const next = random(seed);
  const coordinate = (i: number) => centre[i]! + grown * half[i]! * (2 * next() - 1);
  return Array.from({ length: count }, () => [coordinate(0), coordinate(1), coordinate(2)]);
}

/** Of every pair of neighbours with different signs the point between where the value passes 0. */
function surfacePoints(field: Field, points: readonly Point[]): Point[] {
  return points.flatMap((p, i) => {
    const q = points[(i + 1) % points.length]!;
    const inside = field.value(...p) > 0;
    if (inside === field.value(...q) > 0) return [];
    let [a, b] = inside ? [p, q] : [q, p];
    for (let k = 0; k < 60; k++) {
      const middle = a.map((x, axis) => (x + b[axis]!) / 2) as Point;
      if (field.value(...middle) > 0) a = middle;
      else b = middle;
    }
    return [a];
  });
}

function differences(field: Field, p: Point, h: number): Point {
  return [0, 1, 2].map((axis) => {
    const at = (k: number) => field.value(...(p.map((x, i) => (i === axis ? x + k * h : x)) as Point));
    // fourth order
    return (8 * (at(1) - at(-1)) - (at(2) - at(-2))) / (12 * h);
  }) as Point;
}

/** NaN when one of them is */
const worst = (values: readonly number[]) => Math.max(...values);
const length = (v: readonly number[]) => Math.sqrt(v.reduce((sum, x) => sum + x * x, 0));
const away = (p: readonly number[], q: readonly number[]) => length(p.map((x, i) => x - q[i]!));
const out = new Float64Array(4);
const gradientAt = (field: Field, p: Point): number[] => {
  field.evaluate(...p, out);
  return [...out.subarray(1)];
};

for (const [key, kind] of Object.entries(shapes)) {
  const examples = kind.examples as readonly Shape[];
  describe(`shape ${key} (seeds 1 and 2)`, () => {
    test('is what its key says', () => {
      expect(kind.name).toBe(key);
      expect(kind.label).not.toBe('');
      for (const shape of examples) expect(kindOf(shape)).toBe(kind);
    });

    test.each(examples)('the gradient has length 1 on the surface: %j', (shape) => {
      const field = bindShape(shape);
      const points = surfacePoints(field, pointsAround(field, 600, 1.3, 1));
      expect(points.length).toBeGreaterThan(20);
      expect(worst(points.map((p) => Math.abs(length(gradientAt(field, p)) - 1)))).toBeLessThan(1e-5);
    });

    test.each(examples)('value() and evaluate() agree, gradient = differences: %j', (shape) => {
      const field = bindShape(shape);
      const size = Math.min(...region(field).half);
      const errors = pointsAround(field, 250, 1.5, 2).flatMap((p) => {
        const gradient = gradientAt(field, p);
        if (out[0] !== field.value(...p)) return [Infinity];
        const h = 1e-4 * size;
        const [fine, coarse] = [differences(field, p, h), differences(field, p, 3 * h)];
        // two steps that differ straddle an edge, where there is no gradient
        return away(fine, coarse) > 1e-7 ? [] : [away(fine, gradient)];
      });
      expect(errors.length).toBeGreaterThan(150);
      expect(worst(errors)).toBeLessThan(2e-6);
    });

    test.each(examples)('the box holds the inside and is no larger: %j', (shape) => {
      const field = bindShape(shape);
      if (!field.box) return;
      const { min, max } = field.box;
      const { half } = region(field);
      const inside = pointsAround(field, 2500, 1.5, 1).filter((p) => field.value(...p) > 0);
      for (const i of [0, 1, 2]) {
        const [least, most] = [Math.min(...inside.map((p) => p[i]!)), worst(inside.map((p) => p[i]!))];
        expect(least).toBeGreaterThanOrEqual(min[i]!);
        expect(most).toBeLessThanOrEqual(max[i]!);
        expect(most - least).toBeGreaterThan(1.4 * half[i]!);
      }
    });

    test.each(examples)('boxAbove holds all points above a level: %j', (shape) => {
      const field = bindShape(shape);
      const size = Math.min(...region(field).half);
      for (const level of [0, -0.5 * size, -3 * size]) {
        const box = field.boxAbove(level);
        if (!box) continue;
        const above = pointsAround(field, 1500, 6, 2).filter((p) => field.value(...p) > level);
        const lost = above.filter((p) => p.some((x, i) => x < box.min[i]! || x > box.max[i]!));
        expect(lost).toEqual([]);
      }
    });

    test.each(examples)('finite at centre, on axes, in corners, far away: %j', (shape) => {
      const field = bindShape(shape);
      const { centre, half } = region(field);
      const steps = [-1e3, -1, -0.5, 0, 0.5, 1, 1e3];
      const lengths = steps.flatMap((i) =>
        steps.flatMap((j) =>
          steps.map((k) => {
            field.evaluate(centre[0] + i * half[0], centre[1] + j * half[1], centre[2] + k * half[2], out);
            return Number.isFinite(out[0]) ? length([...out.subarray(1)]) : NaN;
          }),
        ),
      );
      expect(worst(lengths)).toBeLessThan(kind.exact ? 1 + 1e-9 : Infinity);
    });

    if (!kind.exact) return;

    test.each(examples)('the value is the distance: %j', (shape) => {
      const field = bindShape(shape);
      const size = Math.max(...region(field).half);
      const surface = surfacePoints(field, pointsAround(field, 700, 1.2, 1));
      const errors = pointsAround(field, 80, 2, 2).map((p) => {
        const gradient = gradientAt(field, p);
        const value = out[0]!;
        // no surface point is nearer, and one is as near: along the gradient
        const nearest = Math.min(...surface.map((q) => away(p, q)));
        const foot = p.map((x, i) => x - value * gradient[i]!) as Point;
        return Math.max(Math.abs(value) - nearest, Math.abs(field.value(...foot)));
      });
      expect(worst(errors)).toBeLessThan(1e-9 * size);
    });
  });
}
