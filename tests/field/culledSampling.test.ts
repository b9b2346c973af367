/** Culled lattices: the mesh of all values, from few of them. */
import { describe, expect, test } from 'vitest';
import { bindField } from '../../src/field/bind.ts';
import { culledSampling } from '../../src/field/culledSampling.ts';
import { fitting } from '../../src/field/fitBox.ts';
import { latticeAround, nodeCount, sampling } from '../../src/field/lattice.ts';
import { meshing } from '../../src/field/latticeMesh.ts';
import type { FieldNode } from '../../src/field/node.ts';
import { polygonize } from '../../src/field/polygonize.ts';
import type { TreeField } from '../../src/field/treeField.ts';
import { bounds } from '../../src/mesh/measure.ts';
import type { SegmentSkel } from '../../src/skeleton/skels.ts';
import { random } from '../fixtures/random.ts';
import { Lot } from './lot.ts';
import { randomTree } from './randomTrees.ts';
import { body, type Point, points } from './trees.ts';

function finished<T>(steps: Generator<number, T>): T {
  for (;;) {
    const { done, value } = steps.next();
    if (done) return value;
  }
}

/** Counts values and ranges. */
function counted(field: TreeField): TreeField & { values: number; ranges: number } {
  const counts = { values: 0, ranges: 0 };
  return Object.assign(Object.create(field) as TreeField, counts, {
    value(this: typeof counts, x: number, y: number, z: number) {
      this.values++;
      return field.value(x, y, z);
    },
    range(this: typeof counts, x: number, y: number, z: number, half: number, out: Float64Array) {
      this.ranges++;
      field.range(x, y, z, half, out);
    },
    evaluate: (x: number, y: number, z: number, out: Float64Array) => field.evaluate(x, y, z, out),
    colour: (x: number, y: number, z: number, out: Float64Array) => field.colour(x, y, z, out),
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
  test('leave the mesh of all values, bit for bit (25 trees, seed 71)', () => {
    const lot = new Lot(71);
    let surfaces = 0;
    for (let i = 0; i < 25; i++) {
      const field = bindField(randomTree(lot, 2));
      const lattice = latticeAround({ min: [-6, -6, -6], max: [6, 6, 6] }, 20);
      const all = finished(meshing(field, lattice, finished(sampling(field, lattice))));
      const few = finished(meshing(field, lattice, finished(culledSampling(field, lattice))));
      expect(few.indices).toEqual(all.indices);
      expect(few.positions).toEqual(all.positions);
      expect(few.normals).toEqual(all.normals);
      if (all.indices.length > 0) surfaces++;
    }
    expect(surfaces).toBeGreaterThan(12);
  });

  test('take a share of the values that falls as lattices become finer (seed 72)', () => {
    const shares = [32, 64, 128].map((resolution) => {
      const field = counted(bindField(chain(24, 72)));
      const box = finished(fitting(field, field.box!))!;
      field.values = 0;
      field.ranges = 0;
      const lattice = latticeAround(box, resolution);
      finished(culledSampling(field, lattice));
      return (field.values + 3 * field.ranges) / nodeCount(lattice);
    });
    console.info(
      `values and three times the ranges, of all nodes: ${shares.map((x) => x.toFixed(3)).join(', ')}`,
    );
    expect(shares[2]).toBeLessThan(0.15);
    expect(shares[1]! / shares[2]!).toBeGreaterThan(1.6);
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
