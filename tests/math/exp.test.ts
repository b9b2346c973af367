import { describe, expect, test } from 'vitest';
import { exp, expm1 } from '../../src/math/exp.ts';
import { exact, PRECISE_ONE, preciseExp, ulps } from '../fixtures/precise.ts';
import { random } from '../fixtures/random.ts';

describe('exp and expm1 against 60 digits', () => {
  for (const range of [1e-6, 0.3, 1, 36, 80]) {
    test(`1 ulp on ±${range} (seed 1)`, () => {
      const next = random(1);
      for (let i = 0; i < 500; i++) {
        const x = (2 * next() - 1) * range;
        const truth = preciseExp(exact(x));
        expect(ulps(exp(x), truth), `exp ${x}`).toBeLessThan(1);
        expect(ulps(expm1(x), truth - PRECISE_ONE), `expm1 ${x}`).toBeLessThan(1);
      }
    });
  }

  test('next to the middles between multiples of ln 2, where the reduction is at its worst', () => {
    for (let k = -60; k <= 60; k++) {
      const x = (k + 0.5) * Math.LN2;
      expect(ulps(exp(x), preciseExp(exact(x))), `exp ${x}`).toBeLessThan(1);
      expect(ulps(expm1(x), preciseExp(exact(x)) - PRECISE_ONE), `expm1 ${x}`).toBeLessThan(1);
    }
  });

  test('where doubles end', () => {
    expect(exp(709.78)).toBeCloseTo(Math.exp(709.78), -296);
    expect([exp(710), expm1(710)]).toEqual([Infinity, Infinity]);
    expect([exp(-745.13), exp(-746), expm1(-746)]).toEqual([Number.MIN_VALUE, 0, -1]);
    for (let x = -745; x < -700; x += 0.37) {
      expect(Math.abs(exp(x) - Math.exp(x))).toBeLessThanOrEqual(2 ** -52 * exp(x) + Number.MIN_VALUE);
    }
    expect([exp(0), exp(-0), expm1(0)]).toEqual([1, 1, 0]);
    expect(expm1(-0)).toBe(-0);
    expect([exp(Number.NaN), expm1(Number.NaN)]).toEqual([Number.NaN, Number.NaN]);
    expect([exp(Infinity), exp(-Infinity), expm1(Infinity), expm1(-Infinity)]).toEqual([
      Infinity,
      0,
      Infinity,
      -1,
    ]);
  });
});
