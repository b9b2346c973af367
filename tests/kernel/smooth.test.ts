/** No slope and no bend of a power kernel is larger than is said, and some are as large. */
import { expect, test } from 'vitest';
import { smoothness } from '../../src/kernel/smooth.ts';

test.each([1, 2, 3, 4, 5, 6, 9.5])('(1 + r²)^(−n/2), n = %d', (n) => {
  const { first, second } = smoothness(1, n);
  let [steepest, bent] = [0, 0];
  for (let aside = 0; aside < 4; aside += 0.01) {
    for (let along = 0; along < 6; along += 0.01) {
      const m = 1 + aside * aside + along * along;
      steepest = Math.max(steepest, (n * along) / m);
      bent = Math.max(bent, Math.abs(((n * (n + 2) * along * along) / m - n) / m));
    }
  }
  for (const [found, bound] of [
    [steepest, first],
    [bent, second],
  ] as const) {
    expect(found).toBeLessThanOrEqual(bound * (1 + 1e-12));
    expect(found).toBeGreaterThan(0.999 * bound);
  }
});

test('kernels without a core have none', () => {
  expect(smoothness(0, 4).first).toBe(Infinity);
});
