import { describe, expect, test } from 'vitest';
import { fastAtan2 } from '../../src/math/atan.ts';
import { atan2 } from '../../src/math/trig.ts';
import { exact, preciseAtan, ulps } from '../fixtures/precise.ts';
import { random } from '../fixtures/random.ts';

describe('the fast atan', () => {
  for (const octaves of [1, 20]) {
    test(`2 ulp against 60 digits within ${octaves} octaves of 1 (seed 1)`, () => {
      const next = random(1);
      for (let i = 0; i < 800; i++) {
        const x = 2 ** ((2 * next() - 1) * octaves) * (i % 2 ? 1 : -1);
        expect(ulps(fastAtan2(x, 1), preciseAtan(exact(x))), `atan ${x}`).toBeLessThan(2);
      }
    });
  }

  test('agrees with the exact one in all quadrants (seed 2)', () => {
    const next = random(2);
    for (let i = 0; i < 20_000; i++) {
      const y = (2 * next() - 1) * 2 ** (40 * next() - 20);
      const x = (2 * next() - 1) * 2 ** (40 * next() - 20);
      const truth = atan2(y, x);
      const miss = Math.abs(fastAtan2(y, x) - truth);
      if (!(miss <= 2 ** -51 * Math.abs(truth))) expect(fastAtan2(y, x), `${y} ${x}`).toBe(truth);
    }
  });

  test('on the axes and the diagonals', () => {
    for (const y of [-1, 0, 1]) {
      for (const x of [-1, 0, 1]) if (x || y) expect(fastAtan2(y, x), `${y} ${x}`).toBe(Math.atan2(y, x));
    }
    expect(fastAtan2(1e-300, 1e300)).toBe(0);
    expect(fastAtan2(1e300, 1e-300)).toBe(Math.PI / 2);
  });
});
