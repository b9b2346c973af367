/** What every skel owes with every kernel: it is the integral. A new kernel or skel is tested by being registered. */
import { describe, expect, it } from 'vitest';
import type { Vec3 } from '../../src/math/vec.ts';
import { bindSkel, skeletons } from '../../src/skeleton/index.ts';
import type { SkelField } from '../../src/skeleton/skeleton.ts';
import type { Skel } from '../../src/skeleton/skels.ts';
import { eachSpecimen, evaluated, expectSame, norm, SEED, scaleOf, some } from './compare.ts';
import { SPECIMENS } from './specimens.ts';
import { truth, valueOfPolygon } from './truth.ts';

describe.each(some)('with the kernel $title', (variant) => {
  const { kernel, params } = variant;
  const bound = (skel: Skel) => bindSkel(skel, kernel, params);

  it(`points and segments are the integral of the kernel (seed ${SEED})`, () => {
    eachSpecimen((skel, p, what) => {
      if (skel.type === 'polygon') return;
      expectSame(evaluated(bound(skel), p), truth(skel, kernel, params, p), scaleOf(skel, variant, p), what);
    });
  });

  it(`polygons are the integral of the kernel (seed ${SEED})`, () => {
    eachSpecimen((skel, p, what) => {
      if (skel.type !== 'polygon') return;
      const wanted = valueOfPolygon(skel, kernel, params, p);
      const miss = Math.abs(bound(skel).value(...p) - wanted);
      const { size } = scaleOf(skel, variant, p);
      if (!(miss <= 1e-10 * Math.max(wanted, size))) expect(miss, what).toBeLessThan(1e-10 * size);
    }, 0);
  });

  it(`gradients are differences of the value (seed ${SEED})`, () => {
    eachSpecimen((skel, p, what) => {
      const field = bound(skel);
      const h = 2 ** -11 * Math.min(1, distanceTo(field, p));
      // quadratic pieces meet at the rim of a support
      const wanted = [0, 1, 2].map((axis) => {
        const at = (steps: number) =>
          field.value(...(p.map((x, i) => (i === axis ? x + steps * h : x)) as Point));
        return (8 * (at(1) - at(-1)) - (at(2) - at(-2))) / (12 * h);
      });
      const found = evaluated(field, p);
      const miss = Math.hypot(...wanted.map((x, i) => x - found[i + 1]!));
      const { size, width } = scaleOf(skel, variant, p);
      const steep = Math.max(norm(found, 1), size / width || 0);
      const noise = (1e-14 * (Math.abs(found[0]!) + size)) / h;
      if (!(miss <= 2e-6 * steep + noise)) expect(miss / steep, what).toBeLessThan(2e-6);
    }, 3);
  });
});

type Point = [x: number, y: number, z: number];

/** from the box, or a hundredth where it is inside */
function distanceTo({ box }: SkelField, p: Vec3): number {
  const apart = ([0, 1, 2] as const).map((i) => Math.max(box.min[i] - p[i], p[i] - box.max[i], 0));
  return Math.hypot(...apart) || 0.01;
}

it('there are specimens of every kind', () => {
  expect(Object.keys(SPECIMENS).sort()).toEqual(Object.keys(skeletons).sort());
});
