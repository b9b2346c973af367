import { describe, expect, it } from 'vitest';
import { GAUSS, type GaussPoints } from '../../src/math/gaussLegendre.ts';

/** What n points leave of x^2n: 2^(2n+1) (n!)⁴ / ((2n+1) ((2n)!)²). */
function left(n: number): number {
  let product = 2 / (2 * n + 1);
  // (n!)² 2^n / (2n)! = ∏ k/(2k − 1), squared
  for (let k = 1; k <= n; k++) product *= (k / (2 * k - 1)) ** 2;
  return product;
}

describe('Gauss–Legendre', () => {
  const rules = Object.keys(GAUSS).map((n) => Number(n) as GaussPoints);
  it.each(rules)('%i points integrate every polynomial up to degree 2n − 1, and not 2n', (n) => {
    const { nodes, weights } = GAUSS[n];
    expect([nodes.length, weights.length]).toEqual([n, n]);
    for (let degree = 0; degree <= 2 * n; degree++) {
      const exact = degree % 2 ? 0 : 2 / (degree + 1);
      const miss = Math.abs(weights.reduce((sum, w, i) => sum + w * nodes[i]! ** degree, 0) - exact);
      if (degree < 2 * n) expect(miss, `degree ${degree}`).toBeLessThan(1e-15);
      else expect(miss / left(n)).toBeCloseTo(1, n < 16 ? 6 : 2);
    }
  });

  it('ascends and mirrors', () => {
    for (const n of rules) {
      const { nodes, weights } = GAUSS[n];
      for (let i = 1; i < n; i++) expect(nodes[i]).toBeGreaterThan(nodes[i - 1]!);
      for (let i = 0; i < n; i++) {
        expect(nodes[i]! + nodes[n - 1 - i]!).toBe(0);
        expect(weights[i]).toBe(weights[n - 1 - i]);
      }
    }
  });
});
