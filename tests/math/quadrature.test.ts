import { expect, test } from 'vitest';
import { gauss } from '../../src/math/quadrature.ts';

test('eight points integrate every polynomial up to degree 15, and not 16', () => {
  for (let degree = 0; degree <= 16; degree++) {
    const exact = (2 ** (degree + 1) - 1) / (degree + 1);
    const miss = Math.abs(gauss((t) => t ** degree, 1, 2) / exact - 1);
    if (degree < 16) expect(miss, `degree ${degree}`).toBeLessThan(1e-14);
  }
  expect(Math.abs(gauss((t) => t ** 16, -1, 1) - 2 / 17)).toBeGreaterThan(1e-9);
});

test('the whole is the sum of its parts and the reverse its negative', () => {
  const f = (t: number) => 1 / (1 + t * t);
  expect(gauss(f, 0, 0.3) + gauss(f, 0.3, 1)).toBeCloseTo(Math.PI / 4, 12);
  expect(gauss(f, 1, 0)).toBe(-gauss(f, 0, 1));
});
