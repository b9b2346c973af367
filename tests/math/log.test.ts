import { describe, expect, test } from 'vitest';
import { log, log1p } from '../../src/math/log.ts';
import { exact, PRECISE_ONE, preciseLog, ulps } from '../fixtures/precise.ts';
import { random } from '../fixtures/random.ts';

describe('log and log1p against 60 digits', () => {
  for (const octaves of [0.2, 1, 40, 100]) {
    test(`log: 1 ulp within ${octaves} octaves of 1 (seed 1)`, () => {
      const next = random(1);
      for (let i = 0; i < 500; i++) {
        const x = 2 ** ((2 * next() - 1) * octaves);
        expect(ulps(log(x), preciseLog(exact(x))), `log ${x}`).toBeLessThan(1);
      }
    });
  }

  for (const [from, to] of [
    [-30, -1],
    [-2, 2],
    [0, 80],
  ] as const) {
    test(`log1p: 1 ulp for 2^${from} to 2^${to}, both signs where there are two (seed 2)`, () => {
      const next = random(2);
      for (let i = 0; i < 600; i++) {
        const size = 2 ** (from + (to - from) * next());
        const x = size < 1 && i % 2 ? -size : size;
        expect(ulps(log1p(x), preciseLog(exact(x) + PRECISE_ONE)), `log1p ${x}`).toBeLessThan(1);
      }
    });
  }

  test('ends, zeros and what is no number', () => {
    expect([log(1), log(0), log(-1), log(Infinity)]).toEqual([0, -Infinity, Number.NaN, Infinity]);
    expect([log1p(0), log1p(-1), log1p(-2), log1p(Infinity)]).toEqual([0, -Infinity, Number.NaN, Infinity]);
    expect(log1p(-0)).toBe(-0);
    expect([log(Number.NaN), log1p(Number.NaN)]).toEqual([Number.NaN, Number.NaN]);
    expect(log(Number.MIN_VALUE)).toBeCloseTo(-1074 * Math.LN2, 12);
    expect(log(Number.MAX_VALUE)).toBeCloseTo(1024 * Math.LN2, 12);
    expect(log1p(1e-300)).toBe(1e-300);
  });
});
