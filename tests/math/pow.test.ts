import { describe, expect, test } from 'vitest';
import { pow } from '../../src/math/pow.ts';
import { exact, preciseExp, preciseLog, preciseProduct, ulps } from '../fixtures/precise.ts';
import { random } from '../fixtures/random.ts';

describe('pow against 60 digits', () => {
  for (const octaves of [0.01, 1, 40]) {
    test(`1 ulp for bases within ${octaves} octaves of 1 and results of e±60 (seed 1)`, () => {
      const next = random(1);
      for (let i = 0; i < 600; i++) {
        const x = 2 ** ((2 * next() - 1) * octaves);
        const y = ((2 * next() - 1) * 60) / Math.abs(Math.log(x));
        const truth = preciseExp(preciseProduct(exact(y), preciseLog(exact(x))));
        expect(ulps(pow(x, y), truth), `${x} to ${y}`).toBeLessThan(1);
      }
    });
  }

  test('whole powers that doubles hold are exact', () => {
    for (let k = -1000; k <= 1000; k += 7) expect(pow(2, k)).toBe(2 ** k);
    for (let n = 1; n < 50; n++)
      expect([pow(n, 2), pow(n, 3), pow(n * n, 0.5)]).toEqual([n * n, n * n * n, n]);
  });

  test('large powers against the engine’s (seed 2)', () => {
    const next = random(2);
    for (let i = 0; i < 20_000; i++) {
      const x = 2 ** (2000 * next() - 1000);
      const y = (2 * next() - 1) * 5;
      const theirs = x ** y;
      const ours = pow(x, y);
      if (ours !== theirs) expect(Math.abs(ours / theirs - 1), `${x} to ${y}`).toBeLessThan(1e-15);
    }
  });

  test('ends, zeros and what is no number', () => {
    for (const x of [0, 0.25, 1, 4, Infinity]) {
      for (const y of [0, 1, -1, 0.5, Infinity, -Infinity]) {
        // to the language 1^±∞ is no number, to IEEE 754 it is 1
        if (x !== 1) expect(pow(x, y), `${x} to ${y}`).toBe(x ** y);
      }
      expect(pow(x, Number.NaN)).toBe(x === 1 ? 1 : Number.NaN);
    }
    expect([pow(-1, 2), pow(Number.NaN, 1)]).toEqual([Number.NaN, Number.NaN]);
    expect(pow(1.0000001, 1e300)).toBe(Infinity);
  });
});
