/** Rays onto fields: the first hit, by analysis of shapes and by intervals in float64 along the same rays. */
import { describe, expect, test } from 'vitest';
import { bindField } from '../../src/field/bind.ts';
import type { FieldNode } from '../../src/field/node.ts';
import { locating } from '../../src/field/polygonize.ts';
import { type Ray, Raycaster } from '../../src/field/raycast.ts';
import { length3, scale3, sub3 } from '../../src/math/tuple.ts';
import type { Vec3 } from '../../src/math/vec.ts';
import type { Box } from '../../src/skeleton/skeleton.ts';
import { sceneNode } from '../bench/scenes/index.ts';
import { carvedTree, warpedTree } from '../bench/scenes/trees.ts';
import { finished } from './finished.ts';
import { Lot } from './lot.ts';
import { shape } from './meshes.ts';
import { randomTree } from './randomTrees.ts';
import { firstHit, placeOn } from './rays.ts';
import { body, box, placed, sphere } from './trees.ts';

const located = (node: FieldNode, cells: number) => finished(locating(bindField(node), cells));
const unit = (v: Vec3): Vec3 => scale3(v, 1 / length3(v));

/** Rays of a picture of so many pixels a side, towards the middle of a box, from a direction. */
function raysOnto({ min, max }: Box, pixels: number, towards: Vec3, distance: number): Ray[] {
  const middle = scale3([min[0] + max[0], min[1] + max[1], min[2] + max[2]], 0.5);
  const size = length3(sub3(max, min));
  const back = unit(towards);
  const right = unit([back[2], 0.1, -back[0]]);
  const up: Vec3 = [
    back[1] * right[2] - back[2] * right[1],
    back[2] * right[0] - back[0] * right[2],
    back[0] * right[1] - back[1] * right[0],
  ];
  const eye: Vec3 = [0, 1, 2].map((i) => middle[i]! + distance * size * back[i]!) as unknown as Vec3;
  return Array.from({ length: pixels * pixels }, (_, n) => {
    const x = ((n % pixels) + 0.5) / pixels - 0.5;
    const y = (Math.floor(n / pixels) + 0.5) / pixels - 0.5;
    const to = [0, 1, 2].map((i) => middle[i]! + size * (x * right[i]! + y * up[i]!)) as unknown as Vec3;
    return { from: eye, along: unit(sub3(to, eye)), nearest: 0, pixel: 0, growth: 1 / (pixels * distance) };
  });
}

interface Compared {
  hits: number;
  /** hits of one that the other has not, or another surface */
  missed: number;
  /** of the size: the farthest that hits are apart */
  apart: number;
}

/** What touches by less than the tolerance may be either. */
function compare(node: FieldNode, cells: number, rays: (box: Box) => readonly Ray[]): Compared {
  const field = bindField(node);
  const found = located(node, cells);
  const caster = new Raycaster(found);
  const size = length3(sub3(found.box.max, found.box.min));
  const compared = { hits: 0, missed: 0, apart: 0 };
  for (const ray of rays(found.box)) {
    const isHit = caster.cast(ray);
    const { t } = caster.hit;
    const pixel = ray.growth * 2 * size;
    const truth = firstHit(field, ray, 0, 6 * size, pixel / 64);
    if (isHit !== (truth.t !== null)) {
      // a ray that dips in for less than the last step is either
      const dip = isHit
        ? field.value(...placeOn(ray, t + pixel / 16)) > 0
        : isDeep(field, ray, truth.t!, pixel);
      if (dip) compared.missed++;
      continue;
    }
    if (truth.t === null) continue;
    compared.hits++;
    if (Math.abs(t - truth.t) > 0.01 * size) {
      if (isDeep(field, ray, Math.min(t, truth.t), pixel)) compared.missed++;
      continue;
    }
    compared.apart = Math.max(compared.apart, Math.abs(t - truth.t) / size);
  }
  return compared;
}

const isDeep = (field: ReturnType<typeof bindField>, ray: Ray, t: number, pixel: number) =>
  [1 / 32, 1 / 16, 1 / 8].every((by) => field.value(...placeOn(ray, t + by * pixel)) > 0);

const VIEWS: readonly Vec3[] = [
  [0.3, 0.4, 1],
  [1, 0.2, -0.4],
];

describe('against analysis', () => {
  const across = (from: Vec3, along: Vec3): Ray => ({ from, along, nearest: 0, pixel: 1e-3, growth: 0 });

  test('a sphere: place and normal in every pixel', () => {
    const caster = new Raycaster(located(sphere(10), 48));
    let hits = 0;
    for (const ray of raysOnto({ min: [-10, -10, -10], max: [10, 10, 10] }, 40, [1, 2, 3], 2)) {
      const { from, along } = ray;
      const b = from[0] * along[0] + from[1] * along[1] + from[2] * along[2];
      const under = b * b - (length3(from) ** 2 - 100);
      const isHit = caster.cast(ray);
      if (Math.abs(under) < 1e-6) continue;
      expect(isHit).toBe(under > 0);
      if (!isHit) continue;
      hits++;
      const t = -b - Math.sqrt(under);
      expect(Math.abs(caster.hit.t - t)).toBeLessThan(1e-6);
      const outward = scale3(placeOn(ray, t), 0.1);
      expect(length3(sub3(caster.hit.normal, outward))).toBeLessThan(1e-6);
    }
    expect(hits).toBeGreaterThan(300);
  });

  test('a torus along its axis plane and a capsule across', () => {
    const torus = new Raycaster(located(shape({ type: 'torus', ring: 10, tube: 3 }), 48));
    // through the ring: four places, the first at 13
    expect(torus.cast(across([40, 0, 0], [-1, 0, 0]))).toBe(true);
    expect(torus.hit.t).toBeCloseTo(27, 6);
    // through the hole
    expect(torus.cast(across([0, 40, 0], [0, -1, 0]))).toBe(false);
    expect(torus.cast(across([10, 40, 0], [0, -1, 0]))).toBe(true);
    expect(torus.hit.t).toBeCloseTo(37, 6);
    const capsule = new Raycaster(located(shape({ type: 'capsule', radius: 2, half: 8 }), 48));
    for (const y of [0, 5, 7.9, 9, 9.9]) {
      const x = y <= 8 ? 2 : Math.sqrt(4 - (y - 8) ** 2);
      expect(capsule.cast(across([20, y, 0], [-1, 0, 0]))).toBe(true);
      expect(capsule.hit.t).toBeCloseTo(20 - x, 5);
    }
    expect(capsule.cast(across([20, 10.01, 0], [-1, 0, 0]))).toBe(false);
  });

  test('from within: where the body is left; behind: nothing', () => {
    const caster = new Raycaster(located(sphere(10), 32));
    expect(caster.cast(across([1, 2, 3], unit([0, 1, 0])))).toBe(true);
    expect(caster.hit.at[1]).toBeCloseTo(Math.sqrt(100 - 10), 5);
    expect(caster.cast(across([0, 0, 20], [0, 0, 1]))).toBe(false);
    // all of the line
    expect(caster.cast({ ...across([0, 0, 20], [0, 0, 1]), nearest: -Infinity })).toBe(true);
    expect(caster.hit.t).toBeCloseTo(-30, 5);
  });

  test('along axes, in planes of the lattice and at its corners', () => {
    const found = located(box(5, 5, 5), 32);
    const caster = new Raycaster(found);
    const { origin, step } = found.bricks.lattice;
    for (let n = 0; n < 20; n++) {
      const [y, z] = [origin[1] + 4 * step * (n % 5), origin[2] + 4 * step * Math.floor(n / 5)];
      const isHit = caster.cast(across([50, y, z], [-1, 0, 0]));
      expect(isHit).toBe(Math.abs(y) < 5 && Math.abs(z) < 5);
      if (isHit) expect(caster.hit.t).toBeCloseTo(45, 5);
    }
  });

  test('a body without end is cut off where its lattice ends', () => {
    const half = shape({ type: 'halfSpace', normal: [0, 1, 0], offset: 0 });
    const caster = new Raycaster(located(half, 32));
    expect(caster.cast(across([3, 200, 4], [0, -1, 0]))).toBe(true);
    expect(caster.hit.t).toBeCloseTo(200, 3);
    expect(caster.cast(across([3, -300, 4], [0, 1, 0]))).toBe(true);
    expect(caster.hit.t).toBeCloseTo(200, 0);
    expect(caster.hit.normal).toEqual([0, -1, 0]);
  });

  test('an empty field, a huge one and a tiny one', () => {
    const nothing = new Raycaster(
      located(body([{ skel: { type: 'point', at: [0, 0, 0], weight: 1e-6 } }]), 16),
    );
    expect(nothing.cast(across([0, 0, 20], [0, 0, -1]))).toBe(false);
    for (const size of [1e6, 1e-6]) {
      const caster = new Raycaster(located(sphere(10 * size), 32));
      const ray = { ...across([0, 3 * size, 20 * size], [0, 0, -1]), pixel: 1e-2 * size };
      expect(caster.cast(ray)).toBe(true);
      expect(caster.hit.t / size).toBeCloseTo(20 - Math.sqrt(91), 5);
    }
  });
});

describe('against intervals in float64', () => {
  test.each([
    ['16 segments', sceneNode('tree16'), 64],
    ['64 segments', sceneNode('tree64'), 128],
    ['the blob of 200', sceneNode('blob200'), 48],
    ['carved', carvedTree(), 64],
  ] as const)(
    '%s',
    (_, node, cells) => {
      for (const view of VIEWS) {
        const { hits, missed, apart } = compare(node, cells, (of) => raysOnto(of, 20, view, 1.5));
        expect(hits).toBeGreaterThan(20);
        expect(missed).toBe(0);
        expect(apart).toBeLessThan(1e-4);
      }
    },
    60_000,
  );

  test('with sections', () => {
    const { hits, missed, apart } = compare(warpedTree(), 48, (of) => raysOnto(of, 8, VIEWS[0]!, 1.5));
    expect(hits).toBeGreaterThan(3);
    expect(missed).toBe(0);
    expect(apart).toBeLessThan(1e-4);
  }, 60_000);

  test('a needle thinner than a cell, and two blobs that touch', () => {
    const needle = placed(shape({ type: 'capsule', radius: 0.05, half: 20 }), 0.3, 0, 0.2);
    const beside = { type: 'union', form: 'hard', parts: [needle, placed(sphere(4), 12, 0, 0)] } as const;
    const onto = (y: number): Ray => ({
      from: [0.3, y, 50],
      along: [0, 0, -1],
      nearest: 0,
      pixel: 0.1,
      growth: 0,
    });
    const caster = new Raycaster(located(beside, 64));
    for (let y = -19; y <= 19; y++) {
      expect(caster.cast(onto(y + 0.37))).toBe(true);
      expect(caster.hit.t).toBeCloseTo(50 - 0.25, 4);
    }
    const blobs = body(
      [-1, 1].map((x) => ({ skel: { type: 'point', at: [2.2 * x, 0, 0], weight: 3 } }) as const),
    );
    const { missed, apart, hits } = compare(blobs, 48, (of) => raysOnto(of, 30, [0.1, 0.2, 1], 2));
    expect(hits).toBeGreaterThan(100);
    expect(missed).toBe(0);
    expect(apart).toBeLessThan(1e-4);
  });

  const COUNT = process.env.ROTUND_FULL ? 30 : 5;
  const BLOCKS = process.env.ROTUND_FULL ? 10 : 6;
  const seeds = Array.from({ length: BLOCKS }, (_, i) => 9000 + COUNT * i);
  test.each(seeds)(
    `trees drawn by lot (${COUNT} from seed %i)`,
    (first) => {
      const faults: string[] = [];
      let hits = 0;
      for (let seed = first; seed < first + COUNT; seed++) {
        const lot = new Lot(seed);
        const node = randomTree(lot, 2);
        if (!bindField(node).box) continue;
        const found = compare(node, 20, (of) => raysOnto(of, 6, unit(lot.direction()), 1.5));
        hits += found.hits;
        if (found.missed > 0 || found.apart > 1e-4) faults.push(`seed ${seed}: ${JSON.stringify(found)}`);
      }
      expect(faults).toEqual([]);
      expect(hits).toBeGreaterThan(COUNT);
    },
    300_000,
  );
});
