/** What is said of a ray ahead holds: values lie in the interval, and keep their sign as far as is said, ahead and around, and lose it where that is said. */
import { describe, expect, test } from 'vitest';
import { bindField } from '../../src/field/bind.ts';
import { Tally } from '../../src/field/near.ts';
import { length3, scale3 } from '../../src/math/tuple.ts';
import { Lot } from './lot.ts';
import { randomTree } from './randomTrees.ts';

const SEED = 7700;
const STEPS = 12;
const TREES = process.env.ROTUND_FULL ? 600 : 60;

describe(`trees drawn by lot (${TREES} from seed ${SEED}, 60 places each)`, () => {
  test('intervals and signs', () => {
    const range = new Float64Array(2);
    let [looks, long, wide, certain] = [0, 0, 0, 0];
    for (let seed = SEED; seed < SEED + TREES; seed++) {
      const lot = new Lot(seed, [1, 1e6, 1e-6][seed % 3]);
      const field = bindField(randomTree(lot, 2));
      const near = field.near(new Tally());
      for (let n = 0; n < 60; n++) {
        const [from, to] = [lot.place(), lot.direction()];
        const ray = scale3(to, 1 / length3(to));
        const reach = lot.length();
        const at = (t: number) =>
          field.value(from[0] + t * ray[0], from[1] + t * ray[1], from[2] + t * ray[2]);
        const value = near.look(ray, ...from, reach);
        const clear = near.clear();
        const t = reach * lot.between(0.01, 1);
        // step by step to where it is sure
        let [along, step, reached] = [0, clear, near.reached(clear)];
        for (let i = 0; i < STEPS && !(reached < Infinity) && step > 0 && along + step < reach; i++) {
          along += step;
          near.look(ray, from[0] + along * ray[0], from[1] + along * ray[1], from[2] + along * ray[2], reach);
          step = near.clear();
          reached = near.reached(step);
        }
        near.look(ray, ...from, reach);
        const around = near.around();
        near.look(ray, ...from, reach);
        near.ahead(t, range);
        const margin = 1e-9 * (Math.abs(value) + Math.abs(range[0]!) + Math.abs(range[1]!));
        looks++;
        if (clear > 0.01 * reach) long++;
        if (around > 0.01 * reach) wide++;
        expect(clear).toBeLessThanOrEqual(reach);
        if (reached < Infinity) {
          certain++;
          // steps may be as short as places are told apart
          const grain = 4 * Number.EPSILON * (length3(from) + along);
          const there = at(along + reached * (1 + 1e-9) + grain);
          expect(there > 0, `seed ${seed}, place ${n}`).toBe(!(value > 0));
        }
        for (const share of [0, 0.1, 0.37, 0.62, 0.9, 1]) {
          const place = `seed ${seed}, place ${n}`;
          const there = at(share * t);
          expect(there, place).toBeGreaterThanOrEqual(range[0]! - margin);
          expect(there, place).toBeLessThanOrEqual(range[1]! + margin);
          const aside = lot.direction();
          const by = (0.9999 * Math.min(around, reach) * share) / length3(aside);
          const beside = field.value(
            from[0] + by * aside[0],
            from[1] + by * aside[1],
            from[2] + by * aside[2],
          );
          if (around > 0) expect(beside > 0, place).toBe(value > 0);
          if (clear > 0) expect(at(0.9999 * share * clear) > 0, place).toBe(value > 0);
        }
      }
    }
    // else nothing has been tested
    expect(long).toBeGreaterThan(0.5 * looks);
    expect(wide).toBeGreaterThan(0.2 * looks);
    expect(certain).toBeGreaterThan(5);
  }, 120_000);
});
