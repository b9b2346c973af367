/** What stands for a skel from afar, and what that misses. */
import { expect, test } from 'vitest';
import type { Vec3 } from '../../src/math/vec.ts';
import { Ball } from '../../src/skeleton/ball.ts';
import { bindSkel } from '../../src/skeleton/index.ts';
import { TAYLOR, taylorAt } from '../../src/skeleton/taylor.ts';
import { random } from '../fixtures/random.ts';
import { variants } from '../kernel/variants.ts';
import { everySpecimen, pointsAround } from './specimens.ts';

const SEED = 55;
const NOWHERE: Vec3 = [1, 2, 3];
const powers = variants.filter(({ kernel }) => kernel.change.type === 'relative');
const others = variants.filter(({ kernel }) => kernel.change.type === 'absolute');

/** How small the ball must be for a bound of this share of the field. */
const SHARE = 0.5;

test(`the stand-in misses no more than is said (seed ${SEED})`, () => {
  const next = random(SEED);
  let [worst, count, work] = [0, 0, 0];
  for (const { kernel, params, title } of powers) {
    everySpecimen.forEach((skel, i) => {
      const field = bindSkel(skel, kernel, params);
      for (const p of pointsAround(skel, SEED + i, 4)) {
        const radius = 0.1 + 0.5 * next();
        const missed = field.missed(new Ball().set(...p, radius), Infinity);
        expect([missed, Infinity]).toContain(field.missed(new Ball().set(...p, radius), 0.9 * missed));
        const centre = Math.abs(field.value(...p));
        if (!(missed < SHARE * centre)) continue;
        // of segments long beside their distance the sources, six at most, are what is missed
        const order = { point: 0.13, polygon: 0.26, segment: 1 }[skel.type];
        expect(field.missed(new Ball().set(...p, 0.5 * radius), Infinity), title).toBeLessThan(
          order * missed + 1e-9,
        );
        const factor = 3;
        const taylor = new Float64Array(TAYLOR);
        work += field.standIn(new Ball().set(...p, radius), factor, taylor);
        for (let j = 0; j < 3; j++) {
          const d = [next() - 0.5, next() - 0.5, next() - 0.5] as const;
          const k = (radius * (1 - 1e-12)) / Math.hypot(...d);
          const v: Vec3 = [k * d[0], k * d[1], k * d[2]];
          const truth = field.value(p[0] + v[0], p[1] + v[1], p[2] + v[2]);
          const miss = Math.abs(truth - taylorAt(taylor, ...v) / factor);
          count++;
          worst = Math.max(worst, miss / missed);
        }
      }
    });
  }
  expect(count).toBeGreaterThan(1000);
  expect(worst).toBeGreaterThan(0.3);
  expect(worst).toBeLessThan(1);
  // of a segment two or three sources
  expect(work / (count / 3)).toBeLessThan(2);
});

test(`what is dropped is no larger than is said, nothing beyond a support (seed ${SEED})`, () => {
  const next = random(SEED);
  let zeros = 0;
  for (const { kernel, params } of others) {
    everySpecimen.forEach((skel, i) => {
      const field = bindSkel(skel, kernel, params);
      expect(field.standIn(new Ball().set(...NOWHERE, 1), 1, new Float64Array(TAYLOR))).toBe(0);
      for (const p of pointsAround(skel, SEED + i, 6)) {
        const radius = 0.1 + next();
        const missed = field.missed(new Ball().set(...p, radius), Infinity);
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
