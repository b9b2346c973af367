/** Meshes of convolution bodies against bisection of the field and quadrature, in float64. */
import { describe, expect, test } from 'vitest';
import { bindField } from '../../src/field/bind.ts';
import type { FieldNode, SkelsNode } from '../../src/field/node.ts';
import { polygonize } from '../../src/field/polygonize.ts';
import type { TreeField } from '../../src/field/treeField.ts';
import type { KernelParams } from '../../src/kernel/kernel.ts';
import { topology } from '../../src/mesh/check.ts';
import { volume } from '../../src/mesh/measure.ts';
import type { Mesh } from '../../src/mesh/mesh.ts';
import { nearestOn } from '../../src/mesh/nearest.ts';
import { weld } from '../../src/mesh/weld.ts';
import type { SegmentSkel } from '../../src/skeleton/skels.ts';
import { integrate } from '../fixtures/integrate.ts';
import { expectSolid, made, set, shape } from './meshes.ts';
import { BONE, body, evaluated, type Point, placed, points } from './trees.ts';

/** Where f, positive at `inside` and not at `outside`, changes its sign. */
function bisected(f: (t: number) => number, inside: number, outside: number): number {
  let [low, high] = [inside, outside];
  for (let i = 0; i < 80; i++) {
    const middle = 0.5 * (low + high);
    if (f(middle) > 0) low = middle;
    else high = middle;
  }
  return low;
}

const PI = Math.PI;
const RING = shape({ type: 'torus', ring: 4, tube: 1 });

const on = (field: TreeField, [x, y, z]: Point, [dx, dy, dz]: Point, t: number) =>
  field.value(x + t * dx, y + t * dy, z + t * dz);

/** The weight is that of a point. */
type Case = readonly [kernel: string, params: KernelParams, threshold: number, weight: number];

const KERNELS: readonly Case[] = [
  ['cauchy', { s: 0.5 }, 0.5, 1.5],
  ['gaussian', { s: 0.5 }, 0.5, 1.5],
  ['quartic', { R: 4 }, 0.4, 1.2],
  ['inverseCubic', {}, 0.5, 2],
];

/** Two points on the x axis, `apart` mm from each other. */
const points2 = ([kernel, params, threshold, weight]: Case, apart: number): SkelsNode => ({
  type: 'skels',
  kernel,
  params,
  threshold,
  skels: [-0.5, 0.5].map((side) => ({ skel: { type: 'point', at: [side * apart, 0, 0], weight } })),
});

/** Two lines along z, `apart` mm from each other. */
const lines2 = ([kernel, params, threshold, weight]: Case, apart: number): SkelsNode => ({
  type: 'skels',
  kernel,
  params,
  threshold,
  skels: [-0.5, 0.5].map((side): { skel: SegmentSkel } => {
    const x = side * apart;
    return { skel: { type: 'segment', a: [x, 0, -2], b: [x, 0, 2], weights: [0.4 * weight, 0.02] } };
  }),
});

/** The largest value that every way from one to the other has to pass: both lie in mirror images, so it is in the middle plane. */
function saddle(field: TreeField): number {
  let most = -Infinity;
  for (let z = -3; z <= 3; z += 1 / 256) most = Math.max(most, field.value(0, 0, z));
  return most;
}

describe.each([
  ['points', points2],
  ['segments', lines2],
] as const)('two %s', (_, make) => {
  test.each(KERNELS)('%s: merge and part at the distance where the saddle is T', (...one) => {
    const critical = bisected((apart) => saddle(bindField(make(one, apart))), 1, 20);
    for (const [by, components] of [
      [0.9, 1],
      [0.98, 1],
      [1.02, 2],
      [1.1, 2],
    ] as const) {
      const field = bindField(make(one, by * critical));
      const { mesh, lattice } = polygonize(field, 96);
      // the gap or the neck is wide enough to be seen
      const along: Point = components === 2 ? [1, 0, 0] : [0, 1, 0];
      const inside = saddle(field) > 0;
      const width = inside
        ? bisected((t) => on(field, [0, 0, 0], along, t), 0, 20)
        : bisected((t) => -on(field, [0, 0, 0], along, t), 0, 0.5 * by * critical);
      expect(inside).toBe(components === 1);
      expect(2 * width, `${by}`).toBeGreaterThan(1.5 * lattice.step);
      expectSolid(mesh, 0, components);
    }
  });

  test.each(KERNELS)('%s: vertices lie where bisection along the slope finds the surface', (...one) => {
    const field = bindField(make(one, 4));
    const { mesh, lattice } = polygonize(field, 40);
    for (let i = 0; i < mesh.positions.length; i += 3 * 7) {
      const at: Point = [mesh.positions[i]!, mesh.positions[i + 1]!, mesh.positions[i + 2]!];
      const [, gx, gy, gz] = evaluated(field, at);
      const length = Math.hypot(gx, gy, gz);
      const inward: Point = [gx / length, gy / length, gz / length];
      const h = 0.5 * lattice.step;
      const away = bisected((t) => on(field, at, inward, t), h, -h);
      expect(Math.abs(away)).toBeLessThan(0.01 * lattice.step);
    }
  });

  test.each(KERNELS)('%s: rays from within meet mesh and surface in one place (seed 92)', (...one) => {
    const field = bindField(make(one, 4));
    const { mesh, lattice } = polygonize(field, 40);
    for (const to of points(12, 1, 92)) {
      const length = Math.hypot(...to);
      const way: Point = [to[0] / length, to[1] / length, to[2] / length];
      const from: Point = [2, 0, 0];
      const t = bisected((t) => on(field, from, way, t), 0, 20);
      const place: Point = [from[0] + t * way[0], from[1] + t * way[1], from[2] + t * way[2]];
      // facets are chords: κ (√3 h / 2)² / 2, κ below 1 here
      expect(nearestOn(mesh, place)!.distance).toBeLessThan(
        (3 / 8) * lattice.step ** 2 + 1e-3 * lattice.step,
      );
    }
  });
});

describe('volumes', () => {
  test.each(KERNELS)('%s: of a body of revolution, by quadrature of bisected radii', (...one) => {
    const field = bindField(points2(one, 3));
    const end = bisected((x) => field.value(x, 0, 0), 0, 40);
    const radius = (x: number) => bisected((r) => field.value(x, r, 0), 0, 40);
    // x = end sin θ: the square root at the ends becomes smooth
    const half = integrate(
      (angle) => PI * radius(end * Math.sin(angle)) ** 2 * end * Math.cos(angle),
      [0, PI / 2],
      1e-9,
    );
    const errors = [24, 48].map((cells) => 1 - volume(made(points2(one, 3), cells).mesh) / (2 * half));
    expect(Math.abs(errors[1]!)).toBeLessThan(4e-3);
    // of the second order: a quarter, were all cells cut alike
    expect(errors[0]! / errors[1]!).toBeGreaterThan(3);
    expect(errors[0]! / errors[1]!).toBeLessThan(5);
  });

  test.each<readonly [string, FieldNode, number]>([
    ['a bone with a plate', body(), 9],
    [
      'less a bite',
      set('subtraction', 'hard', body(), placed(shape({ type: 'sphere', radius: 2 }), 3, 1, 1)),
      9,
    ],
    [
      'with a soft bite',
      body([...BONE, { skel: { type: 'point', at: [0, 1, 0], weight: 2 }, factor: -1 }]),
      9,
    ],
    ['blended with a ring', { type: 'blend', a: body(), b: RING, a0: 0.3, a1: 0.5, a2: 1 }, 9],
  ])('%s: by counting 200,000 points (seed 93)', (_, node, half) => {
    const field = bindField(node);
    const { mesh } = polygonize(field, 56);
    expect(topology(mesh).watertight).toBe(true);
    const all = 200_000;
    const share = points(all, half, 93).filter((p) => field.value(...p) > 0).length / all;
    const cube = (2 * half) ** 3;
    const deviation = cube * Math.sqrt((share * (1 - share)) / all);
    expect(Math.abs(volume(mesh) - cube * share)).toBeLessThan(4 * deviation + 4e-3 * cube * share);
  });
});

describe('normals', () => {
  test.each<readonly [string, FieldNode]>([
    ['a smooth union', set('union', 'smooth', body(), placed(RING, 0, 3, 0))],
    ['a blend', { type: 'blend', a: body(), b: RING, a0: 0.3, a1: 0.5, a2: 1 }],
    ['a morph', { type: 'morph', from: body(), to: shape({ type: 'ellipsoid', radii: [4, 2, 3] }), t: 0.4 }],
    [
      'a flattened segment',
      {
        ...body([
          {
            skel: { type: 'segment', a: [-4, 0, 0], b: [4, 1, 0], weights: [2] },
            warp: { section: { type: 'superQuadric', exponent: 4 }, scale: [2, 1], up: [0, 0, 1] },
          },
        ]),
      },
    ],
  ])('of %s are unit, and those of differences', (_, node) => {
    const field = bindField(node);
    const { mesh } = polygonize(field, 32);
    const h = 1e-4;
    const away: number[] = [];
    const isCrease = copies(mesh);
    for (let i = 0; i < mesh.positions.length; i += 3) {
      if (i % 33 !== 0 || isCrease(i / 3)) continue;
      const at = [0, 1, 2].map((k) => mesh.positions[i + k]!) as unknown as Point;
      const slope = (
        [
          [1, 0, 0],
          [0, 1, 0],
          [0, 0, 1],
        ] as const
      ).map((axis) => (on(field, at, axis, -h) - on(field, at, axis, h)) / (2 * h));
      const length = Math.hypot(...slope);
      away.push(Math.hypot(...slope.map((x, k) => x / length - mesh.normals[i + k]!)));
      expect(Math.hypot(...mesh.normals.subarray(i, i + 3))).toBeCloseTo(1, 6);
    }
    // folds aside
    away.sort((a, b) => a - b);
    expect(away[Math.floor(0.95 * away.length)]).toBeLessThan(5e-3);
  });
});

/** Whether a vertex has copies, which creases have for each side. */
function copies({ positions }: Mesh): (vertex: number) => boolean {
  const { ids, count } = weld(positions);
  const found = new Uint32Array(count);
  for (const id of ids) found[id] = found[id]! + 1;
  return (vertex) => found[ids[vertex]!]! > 1;
}
