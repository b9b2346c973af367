/** How far the fields of a segment and of one that was moved a little may be apart. */
import { expect, test } from 'vitest';
import type { Vec3 } from '../../src/math/vec.ts';
import { Ball } from '../../src/skeleton/ball.ts';
import { bindSkel } from '../../src/skeleton/index.ts';
import type { SegmentSkel } from '../../src/skeleton/skels.ts';
import { random } from '../fixtures/random.ts';
import { variants } from '../kernel/variants.ts';

const SEED = 58;

test(`a moved segment differs by no more than is said (seed ${SEED})`, () => {
  const next = random(SEED);
  const any = (size: number): Vec3 => [
    size * (2 * next() - 1),
    size * (2 * next() - 1),
    size * (2 * next() - 1),
  ];
  const plus = (a: Vec3, b: Vec3): Vec3 => [a[0] + b[0], a[1] + b[1], a[2] + b[2]];
  let [known, worst] = [0, 0];
  for (const { kernel, params, title } of variants) {
    for (let i = 0; i < 40; i++) {
      const weights = Array.from({ length: 1 + (i % 4) }, () => next() - 0.3);
      const [a, b] = [any(2), any(2)];
      const skel: SegmentSkel = { type: 'segment', a, b, weights };
      const by = 0.3 * next();
      const moved: SegmentSkel = {
        type: 'segment',
        a: plus(a, any(by)),
        b: plus(b, any(by)),
        weights: weights.map((w) => w + 0.05 * by * (next() - 0.5)),
      };
      const [one, other] = [bindSkel(skel, kernel, params), bindSkel(moved, kernel, params)];
      const p = any(5);
      const radius = 0.5 * next();
      const most = one.apart(other, new Ball().set(...p, radius));
      if (most === Infinity) continue;
      known++;
      for (let j = 0; j < 8; j++) {
        const q = plus(p, any(radius / Math.sqrt(3)));
        const apart = Math.abs(one.value(...q) - other.value(...q));
        worst = Math.max(worst, apart / most);
        expect(apart, title).toBeLessThanOrEqual(most);
      }
    }
  }
  expect(known).toBeGreaterThan(100);
  expect(worst).toBeGreaterThan(0.1);
});
