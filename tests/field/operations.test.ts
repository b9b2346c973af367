/** Operations on two numbers: signs, ends and partial derivatives; no field in sight. */
import { describe, expect, test } from 'vitest';
import { blendUnion } from '../../src/field/blendUnion.ts';
import { hardUnion } from '../../src/field/hardUnion.ts';
import { morph } from '../../src/field/morph.ts';
import type { Operation } from '../../src/field/operation.ts';
import { smoothUnion } from '../../src/field/smoothUnion.ts';
import { exp } from '../../src/math/exp.ts';
import { random } from '../fixtures/random.ts';

const operations: readonly [string, Operation][] = [
  ['hard union', hardUnion],
  ['smooth union', smoothUnion],
  ['blend', blendUnion({ a0: 0.7, a1: 1.5, a2: 0.5 })],
  ['groove', blendUnion({ a0: -0.7, a1: 1.5, a2: 0.5 })],
  ['morph', morph(0.3)],
];

/** Sizes from e^−60 to e^60, any sign. */
function* pairs(count: number, seed: number): Generator<readonly [number, number]> {
  const next = random(seed);
  const number = () => (next() < 0.5 ? -1 : 1) * exp(120 * next() - 60);
  for (let i = 0; i < count; i++) yield [number(), number()];
}

const out = new Float64Array(3);

describe('operations', () => {
  test('the smooth union has the sign of the hard one, and both intersections too (1e5 pairs, seed 11)', () => {
    let wrong = 0;
    for (const [a, b] of pairs(100_000, 11)) {
      const isIn = smoothUnion.value(a, b) > 0;
      const isInBoth = -smoothUnion.value(-a, -b) > 0;
      if (isIn !== Math.max(a, b) > 0 || isInBoth !== Math.min(a, b) > 0) wrong++;
    }
    expect(wrong).toBe(0);
  });

  test('the smooth union is the R-function, relatively exact (seed 12)', () => {
    const next = random(12);
    for (let i = 0; i < 300; i++) {
      // whole numbers: their squares are exact
      const [a, b] = [Math.round(2e6 * next() - 1e6), Math.round(2e6 * next() - 1e6)];
      const value = smoothUnion.value(a, b);
      // (value − a − b)² = a² + b² ⇔ value² − 2 value (a + b) + 2 a b = 0
      const rest = value * value - 2 * value * (a + b) + 2 * a * b;
      expect(Math.abs(rest)).toBeLessThan(
        4e-15 * (Math.abs(value * (a + b)) + Math.abs(a * b) + value * value),
      );
    }
    expect(smoothUnion.value(3, 4)).toBe(12);
    expect(smoothUnion.value(-3, -4)).toBe(-2);
    expect(smoothUnion.value(0, 0)).toBe(0);
    expect(smoothUnion.value(1e300, 1e300)).toBeCloseTo(3.414213562373095e300, -287);
  });

  test.each(operations)('%s: partial derivatives are differences (seed 13)', (_, operation) => {
    const next = random(13);
    let worst = 0;
    for (let i = 0; i < 2000; i++) {
      const [a, b] = [4 * next() - 2, 4 * next() - 2];
      operation.evaluate(a, b, out);
      if (out[0] !== operation.value(a, b)) worst = Infinity;
      const h = 1e-5;
      if (Math.abs(a - b) < 2 * h || Math.sqrt(a * a + b * b) < 0.05) continue;
      const da = (operation.value(a + h, b) - operation.value(a - h, b)) / (2 * h);
      const db = (operation.value(a, b + h) - operation.value(a, b - h)) / (2 * h);
      worst = Math.max(worst, Math.abs(da - out[1]!), Math.abs(db - out[2]!));
    }
    expect(worst).toBeLessThan(1e-7);
  });

  test.each(operations)(
    '%s: a level is not passed where both operands are deep enough (seed 14)',
    (_, operation) => {
      const next = random(14);
      for (const level of [0, -0.1, -1, -30]) {
        const c = operation.reach(level);
        expect(c).toBeGreaterThanOrEqual(0);
        for (let i = 0; i < 2000; i++) {
          const deeper = () => -c - 5 * next() * next() * next();
          const value = operation.value(deeper(), deeper());
          if (!(value <= level + 1e-12)) expect(value).toBeLessThanOrEqual(level + 1e-12);
        }
      }
    },
  );

  test('a blend with a0 = 0 is the smooth union; its shift is a0 on the meeting curve, and fades', () => {
    const none = blendUnion({ a0: 0, a1: 1, a2: 1 });
    for (const [a, b] of pairs(200, 15)) expect(none.value(a, b)).toBe(smoothUnion.value(a, b));
    const small = (a0: number) =>
      blendUnion({ a0, a1: 1, a2: 1 }).value(-0.2, -0.3) - smoothUnion.value(-0.2, -0.3);
    expect(small(1e-3)).toBeLessThan(1e-3);
    expect(small(1e-6)).toBeLessThan(1e-6);
    const blend = blendUnion({ a0: 0.5, a1: 2, a2: 3 });
    expect(blend.value(0, 0)).toBe(0.5);
    expect(blend.value(-2, 0)).toBe(0.25);
    expect(blend.value(0, -3)).toBe(0.25);
    expect(blend.value(-1e20, -1e20)).toBeLessThan(0);
  });

  test('a morph is its operands at the ends, exactly (seed 16)', () => {
    for (const [a, b] of pairs(200, 16)) {
      expect(morph(0).value(a, b)).toBe(a);
      expect(morph(1).value(a, b)).toBe(b);
    }
  });

  test('amounts out of range are refused', () => {
    expect(() => blendUnion({ a0: Number.NaN, a1: 1, a2: 1 })).toThrow(/a0 must be a number/);
    expect(() => blendUnion({ a0: 1, a1: 0, a2: 1 })).toThrow(/a1 must be above 0, got 0/);
    expect(() => blendUnion({ a0: 1, a1: 1, a2: -1 })).toThrow(/a2/);
    expect(() => morph(1.5)).toThrow(/t must be from 0 to 1, got 1.5/);
  });
});
