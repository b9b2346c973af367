import { describe, expect, test } from 'vitest';
import { atan2, cos, sin, sincos } from '../../src/math/trig.ts';
import { random } from '../fixtures/random.ts';

const ULP = 2 ** -52;
/** Math's own last bit and ours: two units of the last place of the true value. */
const close = (ours: number, theirs: number) =>
  Math.abs(ours - theirs) <= 2 * ULP * Math.abs(theirs) + Number.MIN_VALUE;

describe('trig', () => {
  for (const range of [1e-8, 1e-3, 1, Math.PI, 100, 1e4, 1e6]) {
    test(`sin and cos agree with the engine to 2 ulp on ±${range} (seed 1)`, () => {
      const next = random(1);
      for (let i = 0; i < 20_000; i++) {
        const x = (2 * next() - 1) * range;
        if (!close(sin(x), Math.sin(x))) expect(sin(x), `sin ${x}`).toBe(Math.sin(x));
        if (!close(cos(x), Math.cos(x))) expect(cos(x), `cos ${x}`).toBe(Math.cos(x));
      }
    });
  }

  test('next to multiples of π/2, where most digits cancel', () => {
    for (let k = -6000; k <= 6000; k++) {
      const x = k * (Math.PI / 2);
      if (!close(sin(x), Math.sin(x))) expect(sin(x), `sin ${k}·π/2`).toBe(Math.sin(x));
      if (!close(cos(x), Math.cos(x))) expect(cos(x), `cos ${k}·π/2`).toBe(Math.cos(x));
    }
  });

  for (const scale of [1e-9, 1, 1e9]) {
    test(`atan2 agrees with the engine to 2 ulp in all quadrants, scale ${scale} (seed 2)`, () => {
      const next = random(2);
      for (let i = 0; i < 20_000; i++) {
        const y = (2 * next() - 1) * scale;
        const x = (2 * next() - 1) * scale * 10 ** (4 * next() - 2);
        if (!close(atan2(y, x), Math.atan2(y, x)))
          expect(atan2(y, x), `atan2 ${y} ${x}`).toBe(Math.atan2(y, x));
      }
    });
  }

  test('zeros, infinities and their signs', () => {
    const values = [0, -0, 1, -1, Infinity, -Infinity, NaN];
    for (const y of values) for (const x of values) expect(atan2(y, x), `${y} ${x}`).toBe(Math.atan2(y, x));
    expect(sin(-0)).toBe(-0);
    expect(cos(0)).toBe(1);
    for (const x of [Infinity, -Infinity, NaN]) expect(sincos(x)).toEqual([NaN, NaN]);
  });

  test('far beyond its range it still returns a sine', () => {
    for (const x of [1e7, 1e15, -1e300]) expect(sin(x) ** 2 + cos(x) ** 2).toBeCloseTo(1, 12);
  });
});
