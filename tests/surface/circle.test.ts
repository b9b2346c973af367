import { expect, test } from 'vitest';
import { unitCircle } from '../../src/surface/circle.ts';

test('the unit circle is even, and exact on its axes', () => {
  for (const columns of [3, 4, 6, 10, 64, 100]) {
    const found = unitCircle(columns);
    expect(found).toHaveLength(columns);
    found.forEach(([x, y], j) => {
      expect(x).toBeCloseTo(Math.cos((2 * Math.PI * j) / columns), 14);
      expect(y).toBeCloseTo(Math.sin((2 * Math.PI * j) / columns), 14);
      if ((2 * j) % columns === 0) expect(y).toBe(0);
      if ((4 * j) % columns === 0) expect(Math.abs(x) + Math.abs(y)).toBe(1);
    });
  }
});
