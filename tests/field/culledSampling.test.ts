/** Culled lattices: the mesh of all values, from few of them. */
import { describe, expect, test } from 'vitest';
import { bindField } from '../../src/field/bind.ts';
import { culledSampling } from '../../src/field/culledSampling.ts';
import { fitting } from '../../src/field/fitBox.ts';
import { latticeAround, nodeCount, sampling } from '../../src/field/lattice.ts';
import { meshing } from '../../src/field/latticeMesh.ts';
import { type Near, nearOf } from '../../src/field/near.ts';
import type { FieldNode } from '../../src/field/node.ts';
import { polygonize } from '../../src/field/polygonize.ts';
import type { TreeField } from '../../src/field/treeField.ts';
import { bounds } from '../../src/mesh/measure.ts';
import type { SegmentSkel } from '../../src/skeleton/skels.ts';
import { random } from '../fixtures/random.ts';
import { Lot } from './lot.ts';
import { randomTree } from './randomTrees.ts';
import { body, type Point, placed, points } from './trees.ts';

function finished<T>(steps: Generator<number, T>): T {
  for (;;) {
    const { done, value } = steps.next();
    if (done) return value;
  }
}

/** What is asked of skels: values, and spreads, which say where they matter. */
interface Asked {
  values: number;
  spreads: number;
}

/** The field with its questions counted; where it has no near lists, each is one. */
function counted(field: TreeField, asked: Asked): TreeField {
  const count = (near: Near): Near => ({
    low: near.low,
    high: near.high,
    error: near.error,
    asked: near.asked,
    value(x, y, z) {
      asked.values += near.asked;
      return near.value(x, y, z);
    },
    within(...cube) {
      asked.spreads += near.asked;
      return count(near.within(...cube));
    },
  });
  const own = count(nearOf(field));
  return Object.assign(Object.create(field) as TreeField, {
    near: () => own,
    value(x: number, y: number, z: number) {
      asked.values += own.asked;
      return field.value(x, y, z);
    },
  });
}

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

describe('culled lattices', () => {
  test('have the signs of all values, and their mesh (25 trees, seed 71)', () => {
    const lot = new Lot(71);
    let surfaces = 0;
    for (let i = 0; i < 25; i++) {
      const field = bindField(randomTree(lot, 2));
      const lattice = latticeAround({ min: [-6, -6, -6], max: [6, 6, 6] }, 20);
      const [every, few] = [finished(sampling(field, lattice)), finished(culledSampling(field, lattice))];
      few.forEach((value, at) => {
        if (value > 0 !== every[at]! > 0)
          throw new Error(`tree ${i}: ${value} for ${every[at]} at node ${at}`);
      });
      const [wanted, got] = [every, few].map((values) => finished(meshing(field, lattice, values)));
      expect(got!.indices).toEqual(wanted!.indices);
      const apart = got!.positions.map((x, at) => Math.abs(x - wanted!.positions[at]!));
      expect(apart.reduce((most, x) => Math.max(most, x), 0)).toBeLessThan(2e-3 * lattice.step);
      if (wanted!.indices.length > 0) surfaces++;
    }
    expect(surfaces).toBeGreaterThan(12);
  });

  test('ask ever fewer skels a node as lattices become finer (seed 72)', () => {
    const field = bindField(chain(48, 72));
    const box = finished(fitting(field, field.box!))!;
    const shares = [32, 64, 128].map((resolution) => {
      const asked = { values: 0, spreads: 0 };
      const lattice = latticeAround(box, resolution);
      finished(culledSampling(counted(field, asked), lattice));
      return (asked.values + 2 * asked.spreads) / (48 * nodeCount(lattice));
    });
    console.info(`asked, of all skels at all nodes: ${shares.map((x) => x.toFixed(4)).join(', ')}`);
    expect(shares[2]).toBeLessThan(0.05);
    expect(shares[1]! / shares[2]!).toBeGreaterThan(2);
  });

  test('neglect no more than they say (8 bodies, seed 75)', () => {
    const next = random(75);
    const within = (half: number) => half * (2 * next() - 1);
    for (let i = 0; i < 8; i++) {
      const field = bindField(chain(40, 76 + i));
      let near = nearOf(field);
      let [x, y, z] = [within(10), within(10), within(10)];
      for (let half = 16; half > 0.2; half /= 2) {
        near = near.within(x, y, z, half, (0.01 * 0.25) / half);
        for (let k = 0; k < 60; k++) {
          const p = [x + within(half), y + within(half), z + within(half)] as const;
          const exact = field.value(...p);
          expect(Math.abs(near.value(...p) - exact)).toBeLessThanOrEqual(near.error + 1e-12);
          expect(exact).toBeGreaterThanOrEqual(near.low);
          expect(exact).toBeLessThanOrEqual(near.high);
        }
        [x, y, z] = [x + within(half / 2), y + within(half / 2), z + within(half / 2)];
      }
      expect(near.asked).toBeLessThan(40);
    }
  });
});

describe('a union of bodies', () => {
  test('asks those that are near (seed 81)', () => {
    const parts = Array.from({ length: 12 }, (_, i) =>
      placed(chain(6, 81 + i), 15 * (i % 4), 15 * Math.floor(i / 4), 0),
    );
    for (const type of ['union', 'subtraction'] as const) {
      const field = bindField({ type, form: 'hard', parts });
      const asked = { values: 0, spreads: 0 };
      const lattice = latticeAround(finished(fitting(field, field.box!))!, 64);
      const few = finished(culledSampling(counted(field, asked), lattice));
      const every = finished(sampling(field, lattice));
      expect(few.every((value, at) => value > 0 === every[at]! > 0)).toBe(true);
      expect(asked.values).toBeLessThan(0.1 * 12 * nodeCount(lattice));
    }
  });

  test('is within what its parts neglect, and its range holds (40 trees, seed 82)', () => {
    const lot = new Lot(82);
    for (let i = 0; i < 40; i++) {
      const field = bindField(randomTree(lot, 3));
      let near = nearOf(field);
      for (let half = 8; half > 0.3; half /= 2) {
        near = near.within(0.3, 0.2, 0.1, half, 0.01 / half);
        for (const [x, y, z] of points(20, 1, 83)) {
          const p = [0.3 + half * x, 0.2 + half * y, 0.1 + half * z] as const;
          const exact = field.value(...p);
          const slack = 1e-9 * (1 + Math.abs(exact));
          expect(Math.abs(near.value(...p) - exact)).toBeLessThanOrEqual(near.error + slack);
          expect(exact).toBeGreaterThanOrEqual(near.low - slack);
          expect(exact).toBeLessThanOrEqual(near.high + slack);
        }
      }
    }
  });
});

describe('a fitted box', () => {
  test('holds all that is inside, and little more (30 trees, seed 73)', () => {
    const lot = new Lot(73);
    for (let i = 0; i < 30; i++) {
      const field = bindField(randomTree(lot, 2));
      if (!field.box || Math.max(...field.box.max) > 1e4) continue;
      const box = finished(fitting(field, field.box));
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
