/** What of white noise on even points reaches the evaluated curve: the reason why least squares is the default. */
import { describe, expect, test } from 'vitest';
import type { Vec2 } from '../../src/math/vec.ts';
import { type Degree, splinePoint } from '../../src/stroke/bspline.ts';
import { fitFair } from '../../src/stroke/fair.ts';
import { fitLeastSquares } from '../../src/stroke/leastSquares.ts';
import { reverseLevels } from '../../src/stroke/reverse.ts';
import { fineCount } from '../../src/stroke/subdivide.ts';
import { normal } from '../fixtures/random.ts';

const CONTROLS = 400;
const filters = {
  'least-squares': { degree: 2, fit: (fine: readonly Vec2[]) => fitLeastSquares(fine, 2, false, CONTROLS) },
  fair: { degree: 3, fit: (fine: readonly Vec2[]) => fitFair(fine, false, CONTROLS, 10) },
  chaikin: {
    degree: 2,
    fit: (fine: readonly Vec2[], levels: number) => reverseLevels(fine, 2, false, levels),
  },
  cubic: { degree: 3, fit: (fine: readonly Vec2[], levels: number) => reverseLevels(fine, 3, false, levels) },
} as const;
type Name = keyof typeof filters;

interface Gain {
  readonly curve: number;
  readonly controls: number;
}

const known = new Map<string, Gain>();

/** Of one filter, level and seed: made once. */
function gain(name: Name, levels: number, seed: number): Gain {
  const key = `${name} ${levels} ${seed}`;
  const found = known.get(key) ?? freshGain(name, levels, seed);
  known.set(key, found);
  return found;
}

/** The filters are linear: filtered noise is the deviation from the filtered clean stroke. */
function freshGain(name: Name, levels: number, seed: number): Gain {
  const { degree, fit } = filters[name];
  const n = normal(seed);
  const fine = Array.from({ length: fineCount(CONTROLS, degree, false, levels) }, (): Vec2 => [n(), n()]);
  const controls = fit(fine, levels);
  const spread = (points: readonly Vec2[]) =>
    Math.sqrt(points.reduce((sum, p) => sum + p[0] ** 2 + p[1] ** 2, 0) / (2 * points.length));
  return { curve: spread(along(controls, degree)), controls: spread(controls.slice(4, -4)) };
}

/** The curve without its ends, which are pinned to a noisy sample. */
function along(controls: readonly Vec2[], degree: Degree): Vec2[] {
  const points: Vec2[] = [];
  for (let t = 4; t < controls.length - degree - 4; t += 0.125)
    points.push(splinePoint(controls, degree, false, t));
  return points;
}

describe('noise gain (seeds 1–4)', () => {
  const seeds = [1, 2, 3, 4];
  const mean = (name: Name, levels: number, of: 'curve' | 'controls') =>
    seeds.reduce((sum, seed) => sum + gain(name, levels, seed)[of], 0) / seeds.length;

  test('table', () => {
    for (const name of Object.keys(filters) as Name[]) {
      const row = (of: 'curve' | 'controls') =>
        [1, 2, 3].map((l) => mean(name, l, of).toFixed(2)).join(' / ');
      console.log(
        `noise gain at levels 1 / 2 / 3, ${name}: curve ${row('curve')}, controls ${row('controls')}`,
      );
    }
  });

  test.each([
    [2, 0.75],
    [3, 0.6],
  ])('level %i: least squares lets through less than %f of what the thesis does', (levels, share) => {
    const ours = mean('least-squares', levels, 'curve');
    expect(ours).toBeLessThan(share * mean('chaikin', levels, 'curve'));
    expect(ours).toBeLessThan(share * mean('cubic', levels, 'curve'));
  });

  test('more levels of least squares denoise more, more levels of reverse subdivision do not', () => {
    const at = (name: Name) => [1, 2, 3].map((levels) => mean(name, levels, 'curve'));
    const [a, b, c] = at('least-squares') as [number, number, number];
    expect(b).toBeLessThan(0.8 * a);
    expect(c).toBeLessThan(0.8 * b);
    for (const name of ['chaikin', 'cubic'] as const) {
      const [first, , third] = at(name) as [number, number, number];
      expect(third).toBeGreaterThan(first);
    }
  });

  test('level 3 by the root of unknowns over points: 0.35', () => {
    expect(mean('least-squares', 3, 'curve')).toBeCloseTo(Math.sqrt(1 / 8), 1);
  });
});
