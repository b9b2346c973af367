/** Filtering time of one stroke of 1,000 samples, and of making its curve and reading 64 points from it. */
import { bench, describe } from 'vitest';
import { curveOf } from '../../src/stroke/arcLength.ts';
import { FILTER_DEFAULTS, filterStroke } from '../../src/stroke/filter.ts';
import { penStroke } from '../fixtures/pen.ts';

const wave = (t: number) => [300 * t, 40 * Math.sin(12 * t)] as const;
const samples = penStroke(wave, { seed: 1, hz: 240, jitter: 0.05, quantise: 0.25 }).slice(0, 1000);

describe('filter 1,000 samples', () => {
  for (const filter of ['least-squares', 'chaikin', 'cubic'] as const) {
    bench(filter, () => {
      filterStroke(samples, { ...FILTER_DEFAULTS, filter });
    });
  }
});

describe('curve by arc length', () => {
  const filtered = filterStroke(samples, FILTER_DEFAULTS)!;
  const curve = curveOf(filtered);
  bench('make', () => {
    curveOf(filtered);
  });
  bench('read 64 points and tangents', () => {
    for (let i = 0; i < 64; i++) {
      curve.point(i / 63);
      curve.tangent(i / 63);
    }
  });
});
