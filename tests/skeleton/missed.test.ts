/** What stands for a skel from afar, and what that misses. */
import { expect, test } from 'vitest';
import type { Vec3 } from '../../src/math/vec.ts';
import { bindSkel } from '../../src/skeleton/index.ts';
import type { SkelField } from '../../src/skeleton/skeleton.ts';
import { random } from '../fixtures/random.ts';
import { variants } from '../kernel/variants.ts';
import { evaluated } from './compare.ts';
import { everySpecimen, pointsAround } from './specimens.ts';

const SEED = 55;
const powers = variants.filter(({ kernel }) => kernel.change.type === 'relative');
const others = variants.filter(({ kernel }) => kernel.change.type === 'absolute');

/** ½ v·H v by the differences of gradients, good to a millionth of what is asked here. */
function second(field: SkelField, p: Vec3, v: Vec3): number {
  const length = Math.hypot(...v);
  const step = 1e-3 / length;
  const at = (k: number) =>
    evaluated(field, [p[0] + k * step * v[0], p[1] + k * step * v[1], p[2] + k * step * v[2]]);
  const slope = (k: number) => {
    const out = at(k);
    return out[1]! * v[0] + out[2]! * v[1] + out[3]! * v[2];
  };
  return (8 * (slope(1) - slope(-1)) - (slope(2) - slope(-2))) / (24 * step);
}

test(`a quadratic misses no more than is said, and half as far an eighth (seed ${SEED})`, () => {
  const next = random(SEED);
  let [worst, count] = [0, 0];
  for (const { kernel, params, title } of powers) {
    everySpecimen.forEach((skel, i) => {
      const field = bindSkel(skel, kernel, params);
      expect(field.standIn).toBe('quadratic');
      for (const p of pointsAround(skel, SEED + i, 4)) {
        const radius = 0.1 + 0.5 * next();
        const missed = field.missed(...p, radius);
        const centre = evaluated(field, p);
        if (!(missed < 0.5 * Math.abs(centre[0]!))) continue;
        expect(field.missed(...p, 0.5 * radius), title).toBeLessThan(0.13 * missed + 1e-9);
        for (let j = 0; j < 3; j++) {
          const d = [next() - 0.5, next() - 0.5, next() - 0.5] as const;
          const k = (radius * (1 - 1e-12)) / Math.hypot(...d);
          const v: Vec3 = [k * d[0], k * d[1], k * d[2]];
          const taylor =
            centre[0]! + centre[1]! * v[0] + centre[2]! * v[1] + centre[3]! * v[2] + second(field, p, v);
          const miss = Math.abs(field.value(p[0] + v[0], p[1] + v[1], p[2] + v[2]) - taylor);
          count++;
          worst = Math.max(worst, (miss - 1e-9 * Math.abs(centre[0]!)) / missed);
        }
      }
    });
  }
  expect(count).toBeGreaterThan(1000);
  expect(worst).toBeGreaterThan(0.3);
  expect(worst).toBeLessThan(1);
});

test(`what is dropped is no larger than is said, nothing beyond a support (seed ${SEED})`, () => {
  const next = random(SEED);
  let zeros = 0;
  for (const { kernel, params } of others) {
    everySpecimen.forEach((skel, i) => {
      const field = bindSkel(skel, kernel, params);
      expect(field.standIn).toBe('nothing');
      for (const p of pointsAround(skel, SEED + i, 6)) {
        const radius = 0.1 + next();
        const missed = field.missed(...p, radius);
        if (missed === 0) zeros++;
        for (let j = 0; j < 4; j++) {
          const one = () => (radius * (2 * next() - 1)) / Math.sqrt(3);
          const value = field.value(p[0] + one(), p[1] + one(), p[2] + one());
          expect(Math.abs(value)).toBeLessThanOrEqual(missed * (1 + 1e-12) + 1e-300);
        }
      }
    });
  }
  expect(zeros).toBeGreaterThan(10);
});
