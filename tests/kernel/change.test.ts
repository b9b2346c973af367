/** What value and gradient of powers leave out when a point moves, against the kernels themselves. */
import { expect, test } from 'vitest';
import { powerChange, Step } from '../../src/kernel/change.ts';
import { Lot } from '../field/lot.ts';

const SEED = 7300;
const CASES = 2000;
const SOURCES = 40;

const kernel = (core: number, n: number, r2: number) => (core + r2) ** (-n / 2);

/** Of the sources at distance ≥ r that one draws: the largest share that a move by `by` leaves out, as computed. */
function leftOut(lot: Lot, core: number, n: number, r: number, by: number): number {
  const shares = lot.many(SOURCES, () => {
    const far = r * lot.one([1, 1, lot.between(1, 2)]) + lot.one([0, 0, lot.between(0, 2)]);
    const cosine = lot.one([-1, 1, lot.between(-1, 1)]);
    const r2 = far * far;
    const moved = kernel(core, n, r2 + 2 * far * by * cosine + by * by);
    const slope = (-n * far * cosine * by * kernel(core, n, r2)) / (core + r2);
    return Math.abs(moved - kernel(core, n, r2) - slope) / kernel(core, n, r2);
  });
  return Math.max(...shares);
}

test(`holds what is left after value and gradient, and closely (${CASES} cases, seed ${SEED})`, () => {
  const lot = new Lot(SEED);
  let [bound, found] = [0, 0];
  for (let i = 0; i < CASES; i++) {
    const [core, n] = [lot.one([0, 1, 1] as const), lot.one([1, 2, 4, 4.5, 6])];
    const r = lot.between(0, 4);
    const by = Math.sqrt(core + r * r) * lot.between(0.01, 0.9);
    const step = Object.assign(new Step(), { r, by, near: Math.max(r - by, 0), exponent: n });
    powerChange(core).factors(step);
    const most = leftOut(lot, core, n, r, by);
    expect(most, `${core}, ${n}, ${r}, ${by}`).toBeLessThanOrEqual(step.bend * (1 + 1e-9) + 1e-12);
    if (core === 0 || by > 0.4 || r > 1) continue;
    bound += step.bend;
    found += most;
  }
  // the generating function alone is some times as much
  expect(bound / found).toBeLessThan(2.5);
});
