/** Rays on the device against the CPU's, pixel by pixel: hits, places, normals, colours. */
import { afterAll, expect, it } from 'vitest';
import { bindField } from '../../../src/field/bind.ts';
import type { FieldNode } from '../../../src/field/node.ts';
import { locating } from '../../../src/field/polygonize.ts';
import { NOWHERE, type RayCamera, type RayImage } from '../../../src/field/rayImage.ts';
import { raycasting } from '../../../src/field/rayScene.ts';
import { castsOnDevice, gpuRaycaster } from '../../../src/gpu/raycast/raycaster.ts';
import { sceneNode } from '../../bench/scenes/index.ts';
import { carvedTree } from '../../bench/scenes/trees.ts';
import { finished } from '../../field/finished.ts';
import { Lot } from '../../field/lot.ts';
import { shape } from '../../field/meshes.ts';
import { randomTree } from '../../field/randomTrees.ts';
import { body, placed, sphere } from '../../field/trees.ts';
import { withDevice } from '../compute.ts';
import { closeDawn, describeGpu } from '../dawn.ts';

afterAll(closeDawn);

const PIXELS = 48;

const camera = (height: number, fov = 30): RayCamera => ({
  view: { pivot: [0, 0, 0], rotation: [0.1, 0.2, 0, 0.9746794], height, fov },
  width: PIXELS,
  height: PIXELS,
  offset: [0.5, 0.5],
});

interface Compared {
  hits: number;
  /** hits of one only */
  either: number;
  /** of the height, of unit normals, of colours; of those hits that both have, all but the worst 2 % */
  apart: number;
  normal: number;
  colour: number;
}

function compared(a: RayImage, b: RayImage, height: number): Compared {
  const found = { hits: 0, either: 0 };
  const apart: number[] = [];
  const normal: number[] = [];
  const colour: number[] = [];
  const off = (x: Float32Array, y: Float32Array, at: number) =>
    Math.max(...[0, 1, 2].map((k) => Math.abs(x[at + k]! - y[at + k]!)));
  for (let at = 0; at < a.surface.length; at += 4) {
    const [isA, isB] = [a.surface[at + 3] !== NOWHERE, b.surface[at + 3] !== NOWHERE];
    if (isA !== isB) found.either++;
    if (!isA || !isB) continue;
    found.hits++;
    apart.push(Math.abs(a.surface[at + 3]! - b.surface[at + 3]!) / height);
    normal.push(off(a.surface, b.surface, at));
    colour.push(off(a.colours, b.colours, at));
  }
  const most = (of: number[]) => of.sort((x, y) => x - y)[Math.floor(0.98 * (of.length - 1))] ?? 0;
  return { ...found, apart: most(apart), normal: most(normal), colour: most(colour) };
}

const located = (node: FieldNode, cells: number) => finished(locating(bindField(node), cells));

async function compare(node: FieldNode, cells: number, of: RayCamera): Promise<Compared> {
  const found = located(node, cells);
  const cpu = finished(raycasting(found, of));
  return withDevice(async (device) => {
    const caster = gpuRaycaster(device);
    const image = await caster.cast([{ node, bricks: found.bricks }], of);
    const gpu = await image.read();
    image.destroy();
    caster.destroy();
    return compared(cpu, gpu, of.view.height);
  });
}

const two: FieldNode = {
  type: 'union',
  form: 'smooth',
  parts: [
    placed(sphere(6), -4, 0, 0),
    body([{ skel: { type: 'point', at: [5, 0, 0], weight: 6 }, colour: [1, 0, 0] }]),
  ],
};
const cut: FieldNode = {
  type: 'subtraction',
  form: 'hard',
  parts: [
    shape({ type: 'box', half: [7, 5, 6] }),
    placed(sphere(5), 6, 5, 5),
    placed(shape({ type: 'torus', ring: 5, tube: 1.5 }), -3, 0, 5),
  ],
};
const blend: FieldNode = {
  type: 'blend',
  a: placed(sphere(5), -4, 0, 0),
  b: placed(sphere(4), 5, 0, 0),
  a0: 1.5,
  a1: 2,
  a2: 2,
};

describeGpu('rays on the device are those of the CPU', () => {
  it.each([
    ['16 segments, in perspective', sceneNode('tree16'), 64, camera(2.2)],
    ['64 segments, orthographic', sceneNode('tree64'), 128, camera(2.2, 0)],
    ['carved', carvedTree(), 96, camera(2)],
    ['a smooth union with colours', two, 48, camera(26)],
    ['a box less a sphere and a torus', cut, 48, camera(24)],
    ['a blend', blend, 48, camera(26)],
    ['from within', sphere(10), 32, camera(2, 100)],
  ] as const)('%s', async (_, node, cells, of) => {
    const { hits, either, apart, normal, colour } = await compare(node, cells, of);
    expect(hits).toBeGreaterThan(50);
    // a ray that only just touches is either
    expect(either).toBeLessThanOrEqual(Math.ceil(0.01 * hits));
    expect(apart).toBeLessThan(1e-5);
    expect(normal).toBeLessThan(2e-3);
    expect(colour).toBeLessThan(2e-3);
  });

  it('bodies cover each other, and where nothing is nothing is written', async () => {
    const nodes = [placed(sphere(4), 0, 0, 3), placed(sphere(6), 0, 0, -3)];
    const of = camera(20);
    const bodies = nodes.map((node) => ({ node, bricks: located(node, 32).bricks }));
    const union: FieldNode = { type: 'union', form: 'hard', parts: nodes };
    const whole = finished(raycasting(located(union, 48), of));
    await withDevice(async (device) => {
      const caster = gpuRaycaster(device);
      for (const order of [bodies, [...bodies].reverse()]) {
        const image = await caster.cast(order, of);
        const { hits, either, apart } = compared(whole, await image.read(), 20);
        expect(hits).toBeGreaterThan(100);
        expect(either).toBeLessThanOrEqual(2);
        expect(apart).toBeLessThan(1e-5);
      }
      const none = await caster.cast([], of);
      expect((await none.read()).surface.filter((_, i) => i % 4 === 3).every((x) => x === NOWHERE)).toBe(
        true,
      );
      expect(await none.work()).toEqual({ terms: 0, lost: 0 });
    });
  });

  it('what tells nothing ahead is refused', async () => {
    const flat = body([
      {
        skel: { type: 'segment', a: [0, 0, 0], b: [9, 0, 0], weights: [2] },
        warp: { section: { type: 'superQuadric', exponent: 4 }, scale: [1, 1], up: [0, 0, 1] },
      },
    ]);
    for (const node of [flat, shape({ type: 'ellipsoid', radii: [3, 5, 4] })]) {
      expect(castsOnDevice(node)).toBe(false);
      await withDevice(async (device) => {
        const caster = gpuRaycaster(device);
        const cast = caster.cast([{ node, bricks: located(node, 16).bricks }], camera(20));
        await expect(cast).rejects.toThrow(RangeError);
        caster.destroy();
      });
    }
  });

  const SEED = 3300;
  const COUNT = process.env.ROTUND_FULL ? 60 : 8;
  it(`trees drawn by lot (${COUNT} from seed ${SEED})`, async () => {
    let hits = 0;
    const faults: string[] = [];
    for (let seed = SEED; hits < 20 * COUNT && seed < SEED + 10 * COUNT; seed++) {
      const node = randomTree(new Lot(seed), 1);
      const box = bindField(node).box;
      if (!box || !castsOnDevice(node)) continue;
      const height =
        1.2 * Math.max(...box.max.map((x, i) => Math.max(Math.abs(x), Math.abs(box.min[i]!)) * 2));
      if (!(height < 1e3)) continue;
      const found = await compare(node, 24, camera(height));
      hits += found.hits;
      const isSame =
        found.either <= Math.ceil(0.03 * found.hits) && found.apart < 1e-4 && found.normal < 0.02;
      if (!isSame) faults.push(`seed ${seed}: ${JSON.stringify(found)}`);
    }
    expect(faults).toEqual([]);
    expect(hits).toBeGreaterThan(100);
  });
});
