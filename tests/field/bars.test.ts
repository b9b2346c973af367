/** Needles, holes and gaps of a few cells by lot: wherever a mesh lacks much of what analysis has, it says so. */
import { describe, expect, test } from 'vitest';
import type { FieldNode } from '../../src/field/node.ts';
import { volume } from '../../src/mesh/measure.ts';
import { sceneNode } from '../bench/scenes/index.ts';
import { random } from '../fixtures/random.ts';
import { along, made, set, shape } from './meshes.ts';
import { box, type Point, placed, sphere } from './trees.ts';

const CELLS = 48;
const TIMES = 30;
/** cells: what is thicker is a faceted bar, no thin place */
const BAR = 2;
/** parts of the volume: facets of a bar of two cells leave out as much */
const FACETS = 0.19;

/** Along an axis, nearly so, or anywhere. */
function way(next: () => number, i: number): Point {
  if (i % 3 === 0) return [0, 1, 0];
  if (i % 3 === 1) return [0.02 * (next() - 0.5), 1, 0.02 * (next() - 0.5)];
  return [next() - 0.5, next() - 0.5, next() - 0.5];
}

describe('needles', () => {
  const capsule = (radius: number, half: number) => shape({ type: 'capsule', radius, half });
  const capsuleVolume = (radius: number, half: number) =>
    Math.PI * radius * radius * (2 * half + (4 / 3) * radius);

  test('beside whose middle the lines of the lattice pass: 0.9 cells, a fifth is left', () => {
    const { mesh, lattice } = made(placed(capsule(0.35, 50), 0.13, 0, 0.07), 128);
    expect(volume(mesh) / capsuleVolume(0.35, 50)).toBeLessThan(0.5);
    expect(mesh.thin!.least).toBeCloseTo(0.7, 3);
    expect(mesh.thin!.gaps).toBe(0);
    // as many cells as it says show all of it
    const finer = made(placed(capsule(0.35, 50), 0.13, 0, 0.07), Math.ceil(128 * 1.01 * mesh.thin!.finer));
    expect(0.7 / lattice.step).toBeLessThan(1);
    expect(finer.mesh.thin).toBeNull();
    expect(volume(finer.mesh) / capsuleVolume(0.35, 50)).toBeGreaterThan(1 - FACETS);
  });

  test.each([1, 2, 3])('of 0.2 to 3 cells, seed %i', (seed) => {
    const next = random(seed);
    for (let i = 0; i < TIMES; i++) {
      const radius = (0.1 + 1.4 * next()) * (40 / CELLS);
      const half = 20 - radius;
      const node = along(way(next, i), capsule(radius, half));
      const { mesh, lattice } = made(placed(node, next(), next(), next()), CELLS);
      if ((2 * radius) / lattice.step < BAR) expect(mesh.thin).not.toBeNull();
      else expect(volume(mesh) / capsuleVolume(radius, half)).toBeGreaterThan(1 - FACETS);
      if ((2 * radius) / lattice.step > 1.1 * BAR) expect(mesh.thin).toBeNull();
    }
  });
});

describe('what is carved out of a ball', () => {
  const BALL = 10;
  /** what it is, how wide for how many mm across, and its volume where it lies `off` the middle */
  const kinds: readonly (readonly [string, (half: number) => FieldNode, (half: number) => number])[] = [
    ['a slit', (half) => box(30, half, 30), (half) => 2 * Math.PI * half * (BALL ** 2 - half ** 2 / 3)],
    [
      'a hole',
      (half) => shape({ type: 'cylinder', radius: half, half: 30 }),
      (half) => (4 / 3) * Math.PI * (BALL ** 3 - (BALL ** 2 - half ** 2) ** 1.5),
    ],
    ['a crack inside', (half) => box(6, half, 6), (half) => 288 * half],
    ['a bubble', (half) => sphere(half), (half) => (4 / 3) * Math.PI * half ** 3],
  ];

  test.each(kinds)('%s of 0.2 to 3 cells, seed 4', (kind, tool, carved) => {
    const next = random(4);
    const whole = volume(made(sphere(BALL), CELLS).mesh);
    for (let i = 0; i < TIMES; i++) {
      const half = (0.1 + 1.4 * next()) * ((2 * BALL) / CELLS);
      const off = [next(), next(), next()].map((x) => 0.4 * (x - 0.5)) as unknown as Point;
      const body = set('subtraction', 'hard', sphere(BALL), placed(along(way(next, i), tool(half)), ...off));
      const { mesh, lattice } = made(body, CELLS);
      const across = (2 * half) / lattice.step;
      const isLacking = Math.abs((whole - volume(mesh)) / carved(half) - 1) > 0.25;
      const isBall = kind === 'a bubble' && across > 1;
      if (isLacking && !isBall) expect(mesh.thin!.gaps).toBeGreaterThan(0);
      if (mesh.thin) expect(mesh.thin.places).toBe(mesh.thin.gaps);
      if (across > 1.1 * BAR) expect(mesh.thin).toBeNull();
    }
  });

  test('two balls beside each other, by less than a cell and by two; that touch in a crevice', () => {
    const balls = (gap: number) =>
      made(set('union', 'hard', sphere(10), placed(sphere(10), 20 + gap, 0.1, 0.2)), CELLS);
    expect(balls(0.5).mesh.thin).toMatchObject({ gaps: 1, places: 1 });
    expect(balls(2).mesh.thin).toBeNull();
    for (const deep of [0.1, 0.3, 1, 3]) expect(balls(-deep).mesh.thin).toBeNull();
  });
});

describe('no alarm', () => {
  test.each(['tree16', 'tree64', 'blob200'] as const)('%s in 128 cells', (name) => {
    expect(made(sceneNode(name), name === 'blob200' ? 64 : 128).mesh.thin).toBeNull();
  });
});
