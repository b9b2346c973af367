/** Near lists: what they leave out is bounded, and the less is asked the smaller cubes are. */
import { describe, expect, test } from 'vitest';
import { bindField } from '../../src/field/bind.ts';
import { fitting } from '../../src/field/fitBox.ts';
import { type NearLeaf, Tally } from '../../src/field/near.ts';
import type { FieldNode } from '../../src/field/node.ts';
import { polygonize } from '../../src/field/polygonize.ts';
import { bounds } from '../../src/mesh/measure.ts';
import type { SegmentSkel } from '../../src/skeleton/skels.ts';
import { random } from '../fixtures/random.ts';
import { finished } from './finished.ts';
import { Lot } from './lot.ts';
import { nodeCount } from './nodeCount.ts';
import { randomTree } from './randomTrees.ts';
import { body, type Point, placed, points } from './trees.ts';

/** A winding chain of thin segments. */
function chain(count: number, seed: number): FieldNode {
  const next = random(seed);
  let a: Point = [0, 0, 0];
  const skels = Array.from({ length: count }, () => {
    const step = () => 8 * next() - 4;
    const b: Point = [a[0] + step(), a[1] + step(), a[2] + step()];
    const skel: SegmentSkel = { type: 'segment', a, b, weights: [1.2] };
    a = b;
    return { skel };
  });
  return { ...body(skels, 1), params: { s: 1 } };
}

describe('near lists', () => {
  test('work falls behind the number of nodes, ever more (seed 72)', () => {
    const field = bindField(chain(48, 72));
    const [coarse, middle, fine] = [32, 64, 128].map((resolution) => {
      const { evaluations, lattice } = polygonize(field, resolution);
      return evaluations / (48 * nodeCount(lattice));
    });
    console.info(
      `work, of all skels at all nodes: ${[coarse, middle, fine].map((x) => x!.toFixed(4)).join(', ')}`,
    );
    expect(fine).toBeLessThan(0.03);
    expect(middle! / fine!).toBeGreaterThan(2);
    expect(coarse! / middle!).toBeGreaterThan(2);
  });

  test('neglect no more than they say, in colour and slope too (8 bodies, seed 75)', () => {
    const next = random(75);
    const within = (half: number) => half * (2 * next() - 1);
    for (let i = 0; i < 8; i++) {
      const field = bindField(chain(40, 76 + i));
      let near = field.near(new Tally());
      let [x, y, z] = [within(10), within(10), within(10)];
      for (let half = 16; half > 0.2; half /= 2) {
        near = near.within(x, y, z, half, 0.002 / half);
        for (let k = 0; k < 60; k++) {
          // near the middle they say that they neglect little
          const by = k % 3 === 0 ? 0.3 * half : half;
          const p = [x + within(by), y + within(by), z + within(by)] as const;
          const exact = field.value(...p);
          const out = new Float64Array(4);
          near.evaluate(...p, out);
          expect(Math.abs(near.value(...p) - exact)).toBeLessThanOrEqual(near.errorAt(...p) + 1e-12);
          expect(near.errorAt(...p)).toBeLessThanOrEqual(near.error * (1 + 1e-9));
          expect(out[0]).toBeCloseTo(near.value(...p), 12);
          expect(exact).toBeGreaterThanOrEqual(near.low);
          expect(exact).toBeLessThanOrEqual(near.high);
        }
        [x, y, z] = [x + within(half / 2), y + within(half / 2), z + within(half / 2)];
      }
      expect(near.asked).toBeLessThan(40);
    }
  });

  test('of every tree hold the field, and name every leaf once (60 trees, seed 82)', () => {
    const lot = new Lot(82);
    for (let i = 0; i < 60; i++) {
      const field = bindField(randomTree(lot, 3));
      const tally = new Tally();
      let near = field.near(tally);
      for (let half = 8; half > 0.3; half /= 2) {
        near = near.within(0.3, 0.2, 0.1, half, 0.01 / half);
        for (const [x, y, z] of points(20, 1, 83)) {
          const p = [0.3 + half * x, 0.2 + half * y, 0.1 + half * z] as const;
          const exact = field.value(...p);
          const slack = 1e-9 * (1 + Math.abs(exact));
          // what is dropped from a union may be what its value is far from the surface
          if (near.low <= 0 && near.high > 0) {
            expect(Math.abs(near.value(...p) - exact)).toBeLessThanOrEqual(near.errorAt(...p) + slack);
          }
          expect(exact).toBeGreaterThanOrEqual(near.low - slack);
          expect(exact).toBeLessThanOrEqual(near.high + slack);
        }
      }
      const leaves: NearLeaf[] = [];
      near.eachLeaf((leaf) => leaves.push(leaf));
      expect(leaves.map(({ leaf }) => leaf).sort((a, b) => a - b)).toEqual(
        Array.from({ length: tally.leaves }, (_, n) => n),
      );
    }
  });
});

test('of a union only the bodies that are near are asked (seed 81)', () => {
  const parts = Array.from({ length: 12 }, (_, i) =>
    placed(chain(6, 81 + i), 15 * (i % 4), 15 * Math.floor(i / 4), 0),
  );
  for (const type of ['union', 'subtraction'] as const) {
    const { bricks, evaluations, lattice } = polygonize(bindField({ type, form: 'hard', parts }), 64);
    const most = bricks.active.reduce((sum, { near }) => Math.max(sum, near.asked), 0);
    expect(most).toBeLessThan(40);
    expect(evaluations).toBeLessThan(0.05 * 12 * 6 * nodeCount(lattice));
  }
});

describe('a fitted box', () => {
  test('holds all that is inside, and little more (30 trees, seed 73)', () => {
    const lot = new Lot(73);
    for (let i = 0; i < 30; i++) {
      const field = bindField(randomTree(lot, 2));
      if (!field.box || Math.max(...field.box.max) > 1e4) continue;
      const box = finished(fitting(field.near(new Tally()), field.box));
      for (const p of points(2000, 8, 74)) {
        if (field.value(...p) <= 0) continue;
        expect(box).not.toBeNull();
        p.forEach((x, axis) => {
          expect(x).toBeGreaterThanOrEqual(box!.min[axis]!);
          expect(x).toBeLessThanOrEqual(box!.max[axis]!);
        });
      }
    }
  });

  test.each(['cauchy', 'inverse', 'gaussian'] as const)(
    'of thin limbs far apart is theirs (%s)',
    (kernel) => {
      // a trunk, and legs a hundredth as thick as they are far apart: a coarse lattice found one of them
      const line = (x: number) =>
        ({ type: 'segment', a: [x, -30, 0], b: [x, 30, 0], radii: [0.6, 0.6] }) as const;
      const params = kernel === 'inverse' ? {} : { s: 1.5 };
      const skels = [-60, 0, 60].map((x) => ({ skel: line(x) }));
      const field = bindField({ type: 'skels', kernel, params, threshold: 1, skels });
      const { mesh } = polygonize(field, 160);
      const { min, max } = bounds(mesh);
      expect(max[0] - min[0]).toBeGreaterThan(120);
    },
  );
});
