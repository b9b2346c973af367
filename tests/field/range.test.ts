/** What a tree may be within a cube: holds what it is, and shrinks with the cube. */
import { describe, expect, test } from 'vitest';
import { bindField } from '../../src/field/bind.ts';
import type { FieldNode, SkelsNode, Term } from '../../src/field/node.ts';
import type { TreeField } from '../../src/field/treeField.ts';
import type { Warp } from '../../src/field/warp.ts';
import { kernels } from '../../src/kernel/index.ts';
import { Lot } from './lot.ts';
import { randomBody, randomTree } from './randomTrees.ts';
import { body, box, evaluated, type Point, placed, points, sphere } from './trees.ts';

const SEED = 5200;
const TREES = 250;
const BOXES = 12;
const PLACES = 6;
const SIZES = [1e-3, 1e-2, 0.1, 0.5, 2, 10, 0];
const range = new Float64Array(2);

function rangeOf(field: TreeField, [x, y, z]: Point, half: number): readonly [low: number, high: number] {
  field.range(x, y, z, half, range);
  return [range[0]!, range[1]!];
}

/** In the cube about a place, every third coordinate in its faces or its middle. */
const within = (lot: Lot, [x, y, z]: Point, half: number): Point => {
  const one = () => half * (lot.is(0.3) ? lot.one([-1, 0, 1]) : lot.between(-1, 1));
  return [x + one(), y + one(), z + one()];
};

/** In words, where the field leaves its intervals. */
function faults(field: TreeField, lot: Lot): string[] {
  return Array.from({ length: BOXES }, (_, i) => {
    const half = lot.unit * SIZES[i % SIZES.length]!;
    const [x, y, z] = lot.place();
    // far away sums over edges leave more than the field
    const far = lot.one([1, 1, 1, 1, 1e3, 1e9]);
    const p: Point = [far * x, far * y, far * z];
    const [low, high] = rangeOf(field, p, half);
    return lot
      .many(PLACES, () => within(lot, p, half))
      .map((q) => field.value(...q))
      .filter((value) => !(value >= low && value <= high))
      .map((value) => `${value} not in ${low}…${high}, ${half} about ${p}`);
  }).flat();
}

const width = ([low, high]: readonly [number, number]) => high - low;

describe('the range of a tree', () => {
  test.each([1, 1e6, 1e-6])(
    `holds its values: ${TREES} trees and bodies of %d mm, ${BOXES} cubes each (seeds from ${SEED})`,
    (unit) => {
      for (let seed = SEED; seed < SEED + TREES; seed++) {
        const lot = new Lot(seed, unit);
        const field = bindField(seed % 3 === 0 ? randomBody(lot) : randomTree(lot));
        expect(faults(field, lot), `seed ${seed}`).toEqual([]);
      }
    },
  );

  test(`shrinks at least as the cube does, off creases and skels (seed ${SEED})`, () => {
    const ratios: number[] = [];
    for (let seed = SEED; seed < SEED + 60; seed++) {
      const lot = new Lot(seed);
      const field = bindField(randomTree(lot, 2));
      const p = lot.place();
      const [coarse, fine] = [1e-3, 1e-5].map((half) => width(rangeOf(field, p, half)));
      if (coarse! > 0) ratios.push(fine! / coarse!);
    }
    ratios.sort((a, b) => a - b);
    expect(ratios[Math.floor(0.9 * ratios.length)]).toBeLessThan(0.012);
  });

  test.each(kernels.map(({ name }) => name))(
    'a sum of %s is exact but for the square of the size',
    (kernel) => {
      const params = kernel === 'quartic' ? { R: 6 } : kernel.startsWith('inverse') ? {} : { s: 0.6 };
      const field = bindField({ ...body(), kernel, params });
      // off the plane of the plate, near which singular kernels are clamped
      for (const p of [
        [0, 2, 1],
        [-3, -1.2, 2],
        [6, 2, 3],
      ] as const) {
        const [, gx, gy, gz] = evaluated(field, p);
        const excess = (half: number) =>
          width(rangeOf(field, p, half)) - 2 * half * (Math.abs(gx) + Math.abs(gy) + Math.abs(gz));
        const [coarse, fine] = [excess(1e-2), excess(1e-3)];
        expect(coarse).toBeGreaterThan(0);
        expect(fine / coarse).toBeLessThan(0.0115);
      }
    },
  );

  test('what carves takes away from the slope of what it carves', () => {
    const skel = { type: 'point', at: [0, 0, 0], weight: 1 } as const;
    const field = bindField(body([{ skel }, { skel, factor: -0.9 }]));
    const alone = bindField(body([{ skel }]));
    expect(width(rangeOf(field, [1, 1, 1], 0.01))).toBeLessThan(0.2 * width(rangeOf(alone, [1, 1, 1], 0.01)));
  });

  test('beyond every support exactly −T', () => {
    const terms: Term[] = [
      { skel: { type: 'point', at: [1, 0, 0], weight: 2 } },
      { skel: { type: 'segment', a: [0, 0, 0], b: [2, 1, 0], weights: [1, 1] }, warp: SQUARE },
    ];
    const node: SkelsNode = { ...body(terms), kernel: 'quartic', params: { R: 2 }, threshold: 0.3 };
    expect(rangeOf(bindField(node), [16, 0, 0], 2)).toEqual([-0.3, -0.3]);
  });

  test('of shapes: the sign of a cube that is inside or outside', () => {
    const tree: FieldNode = {
      type: 'subtraction',
      form: 'hard',
      parts: [box(4, 4, 4), placed(sphere(3), 4, 4, 4)],
    };
    const field = bindField(tree);
    expect(rangeOf(field, [-1, -1, -1], 1)[0]).toBeGreaterThan(0);
    expect(rangeOf(field, [3.5, 3.5, 3.5], 0.5)[1]).toBeLessThan(0);
    expect(rangeOf(field, [6, 0, 0], 1)[1]).toBeLessThan(0);
    const [low, high] = rangeOf(field, [4, 0, 0], 0.5);
    expect(low).toBeLessThan(0);
    expect(high).toBeGreaterThan(0);
  });

  test(`is tight: a body's width over that of the values sampled (seed ${SEED})`, () => {
    const field = bindField(body());
    for (const half of [0.01, 0.1, 0.5]) {
      const loose = points(200, 6, SEED).map((p) => {
        const lot = new Lot(SEED);
        const values = lot.many(60, () => field.value(...within(lot, p, half)));
        return width(rangeOf(field, p, half)) / (Math.max(...values) - Math.min(...values));
      });
      const mean = loose.reduce((sum, x) => sum + x, 0) / loose.length;
      console.info(`looseness of a body, cubes of ${2 * half} mm: ${mean.toFixed(2)}`);
      expect(mean).toBeLessThan(4);
    }
  });
});

const SQUARE: Warp = { section: { type: 'superQuadric', exponent: 8 }, scale: [1, 0.7], up: [0, 0, 1] };
