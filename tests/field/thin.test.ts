/** What is thinner than a cell against what is known of plates, needles and shells; thick bodies give no alarm. */
import { describe, expect, test } from 'vitest';
import type { Affine } from '../../src/field/affine.ts';
import type { FieldNode } from '../../src/field/node.ts';
import type { Polygonized } from '../../src/field/polygonize.ts';
import { cauchy } from '../../src/kernel/cauchy.ts';
import { topology } from '../../src/mesh/check.ts';
import { volume } from '../../src/mesh/measure.ts';
import { lineWeight } from '../../src/skeleton/weight.ts';
import { random } from '../fixtures/random.ts';
import { along, made, set, shape } from './meshes.ts';
import { BONE, box, type Point, placed, sphere } from './trees.ts';

const CELLS = 64;
const cellsOf = ({ mesh, lattice }: Polygonized): number | null =>
  mesh.thin ? mesh.thin.least / lattice.step : null;

const way = (next: () => number): Point => [next() - 0.5, next() - 0.5, next() - 0.5];
const disc = (thickness: number) => shape({ type: 'cylinder', radius: 10, half: thickness / 2 });

describe('tilted plates, seed 11', () => {
  const next = random(11);
  const cases = [0.15, 0.3, 0.5, 0.7, 0.9, 1, 1.2, 1.4, 1.6, 2, 3].map(
    (cells) => [cells, way(next)] as const,
  );

  test.each(cases)('of %f cells along %j', (cells, normal) => {
    // the lattice depends on how the plate lies: its cells are measured first
    const { step } = made(along(normal, disc(0.1)), CELLS).lattice;
    const result = made(along(normal, disc(cells * step)), CELLS);
    const truly = (cells * step) / result.lattice.step;
    if (truly > 1.5) expect(result.mesh.thin).toBeNull();
    else {
      expect(result.mesh.thin!.places).toBeGreaterThan(0);
      expect(cellsOf(result)! / truly).toBeGreaterThan(0.99);
      expect(cellsOf(result)! / truly).toBeLessThan(1.01);
    }
  });

  test('nothing above the limit is in pieces', () => {
    for (const [, normal] of cases) {
      const { step } = made(along(normal, disc(0.1)), CELLS).lattice;
      const { mesh } = made(along(normal, disc(1.55 * step)), CELLS);
      expect(topology(mesh).components).toBe(1);
    }
  });
});

test.each([0.3, 0.6, 1, 1.3, 2])('a needle of %f cells, seed 12', (cells) => {
  const next = random(12);
  for (let i = 0; i < 8; i++) {
    const normal = way(next);
    const { step } = made(along(normal, shape({ type: 'capsule', half: 10, radius: 0.1 })), CELLS).lattice;
    const needle = along(normal, shape({ type: 'capsule', half: 10, radius: (cells * step) / 2 }));
    const result = made(needle, CELLS);
    const isWhole = topology(result.mesh).components === 1;
    if (cells > 1.6) expect([isWhole, result.mesh.thin]).toEqual([true, null]);
    // in pieces it is told, and what is told is right
    else expect(isWhole || result.mesh.thin !== null).toBe(true);
    if (result.mesh.thin) expect(cellsOf(result)! / cells).toBeCloseTo(1, 0.5);
  }
});

test('a shell of 0.8 cells, and one of two', () => {
  const shell = (thickness: number) =>
    made(set('subtraction', 'hard', sphere(10), sphere(10 - thickness)), CELLS);
  const cell = 20 / CELLS;
  expect(cellsOf(shell(0.8 * cell))).toBeCloseTo(0.8, 1);
  expect(shell(2 * cell).mesh.thin).toBeNull();
});

test('two sheets are two places, a ball between them is none', () => {
  const sheet = (y: number) => placed(box(6, 0.05, 6), 0.03, y, 0.07);
  const ball = placed(sphere(4), 0, 0.4, 0);
  const { thin } = made(set('union', 'hard', sheet(-9.9), ball, sheet(9.87)), CELLS).mesh;
  expect(thin!.places).toBe(2);
  expect(thin!.least).toBeCloseTo(0.1, 3);
  expect(Math.abs(thin!.at[1])).toBeGreaterThan(9);
});

describe('what no corner of the lattice sees', () => {
  const cell = 40 / CELLS;

  test.each([0.1, 0.3, 0.6, 0.9])('a brim of %f cells about a ball', (cells) => {
    // between two layers of the lattice, which begin 1.27 cells below the ball
    const heights = [0, 0.25, 0.5, 0.75].map((part) => part * cell);
    const brims = heights.map((y) =>
      placed(shape({ type: 'cylinder', radius: 20, half: (cells * cell) / 2 }), 0, y, 0),
    );
    for (const brim of brims) {
      const result = made(set('union', 'hard', brim, placed(sphere(10), 0, 1, 0)), CELLS);
      expect(cellsOf(result)! / cells).toBeCloseTo(1, 1);
    }
  });

  test.each([0.5, 0.7, 0.9])('limbs of a sum, %f cells thick', (cells) => {
    const radius = (cells * cell) / 2;
    const params = { s: 0.8 / radius };
    const weight = lineWeight(cauchy, params, radius, 0.5);
    const limb = (y: number) => ({
      skel: { type: 'segment', a: [-20, y, 0.5 * cell], b: [20, y, 0.5 * cell], weights: [weight] } as const,
    });
    const node: FieldNode = {
      type: 'skels',
      kernel: 'cauchy',
      params,
      threshold: 0.5,
      skels: [0, 0.25, 0.5, 0.75].map((part) => limb((12 * part + part) * cell)),
    };
    expect(cellsOf(made(node, CELLS))).toBeGreaterThan(0.5 * cells);
    expect(cellsOf(made(node, CELLS))).toBeLessThan(1.2 * cells);
  });
});

describe('unequal scales, 1 : 0.01', () => {
  const sum = (kernel: string): FieldNode => ({
    type: 'skels',
    kernel,
    params: { s: 0.4 },
    threshold: 0.5,
    skels: BONE,
  });
  const bodies: readonly (readonly [string, FieldNode])[] = [
    ['a ball', sphere(10)],
    ['a box', box(10, 8, 6)],
    ['a torus', shape({ type: 'torus', ring: 10, tube: 3 })],
    ['a capsule', shape({ type: 'capsule', half: 10, radius: 4 })],
    ['a sum by Cauchy', sum('cauchy')],
    ['a sum by Gauss', sum('gaussian')],
  ];

  test.each(bodies)('%s is whole, or said to be thin', (_, node) => {
    const whole = volume(made(node, CELLS).mesh);
    for (const axis of [0, 1, 2]) {
      const matrix = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0].map((m, i) => (i === 5 * axis ? 0.01 : m));
      const flat: FieldNode = { type: 'affine', matrix: matrix as unknown as Affine, node };
      for (const body of [flat, along([0.3, 0.8, 0.52], flat)]) {
        const { mesh } = made(body, CELLS);
        if (mesh.thin) continue;
        expect(topology(mesh).components).toBe(1);
        expect(Math.abs(volume(mesh) / (0.01 * whole) - 1)).toBeLessThan(0.05);
      }
    }
  });
});

test('nothing is found where nothing is: a field that comes near to 0 and stays below', () => {
  const dim = (threshold: number): FieldNode => ({
    type: 'skels',
    kernel: 'cauchy',
    params: { s: 1 },
    threshold,
    skels: [{ skel: { type: 'point', at: [0.1, 0.2, 0.3], weight: 1 } }],
  });
  expect(made(dim(1.0001), 16).mesh).toMatchObject({ thin: null, indices: { length: 0 } });
  expect(made(dim(0.98), 8).mesh.indices.length).toBeGreaterThan(0);
});

describe('no alarm', () => {
  const turned: FieldNode = {
    type: 'affine',
    matrix: [0.5 ** 0.5, 0.5 ** 0.5, 0, 0, -(0.5 ** 0.5), 0.5 ** 0.5, 0, -8, 0, 0, 1, 0],
    node: placed(box(30, 30, 30), 30, 0, 0),
  };
  const thick: readonly (readonly [string, FieldNode])[] = [
    ['a ball', sphere(10)],
    ['a box', box(10, 8, 6)],
    ['a torus', shape({ type: 'torus', ring: 10, tube: 3 })],
    ['a cylinder', shape({ type: 'cylinder', radius: 8, half: 8 })],
    ['a box less a ball', set('subtraction', 'hard', box(10, 10, 10), placed(sphere(8), 10, 0, 0))],
    ['a wedge of 45°', set('intersection', 'hard', box(8, 8, 8), turned)],
    ['two balls', set('union', 'hard', sphere(5), placed(sphere(5), 9, 0, 0))],
    ['a bone', { type: 'skels', kernel: 'cauchy', params: { s: 0.4 }, threshold: 0.5, skels: BONE }],
  ];

  test.each(thick)('%s, turned, seed 13', (_, node) => {
    const next = random(13);
    for (let i = 0; i < 6; i++) expect(made(along(way(next), node), 32 + 4 * i).mesh.thin).toBeNull();
  });

  test('unions of thick bodies at random, seeds 1–40', () => {
    const alarms = Array.from({ length: 40 }, (_, i) => {
      const next = random(i + 1);
      const parts = Array.from({ length: 5 }, () => {
        const size = 4 + 4 * next();
        const kinds = [sphere(size), box(size, 5, 4), shape({ type: 'capsule', half: size, radius: 4 })];
        const [x, y, z] = way(next);
        return placed(along(way(next), kinds[Math.floor(3 * next())]!), 20 * x, 20 * y, 20 * z);
      });
      return made(set('union', 'hard', ...parts), 48).mesh.thin;
    });
    expect(alarms.filter((thin) => thin !== null)).toEqual([]);
  });
});
