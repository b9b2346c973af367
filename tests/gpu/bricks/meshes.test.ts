/** Meshes of bricks that the device finds are those of the CPU's bricks: nothing but records went up. */

import { afterAll, expect, it } from 'vitest';
import { bindField } from '../../../src/field/bind.ts';
import type { FieldMesh } from '../../../src/field/brickMesh.ts';
import { culling } from '../../../src/field/bricks.ts';
import { type Lattice, latticeAround } from '../../../src/field/lattice.ts';
import { Tally } from '../../../src/field/near.ts';
import type { FieldNode, Term } from '../../../src/field/node.ts';
import { cullsOnDevice } from '../../../src/gpu/bricks/cullsOnDevice.ts';
import { gpuPolygonizer } from '../../../src/gpu/polygonize/polygonizer.ts';
import { gpuWork } from '../../../src/gpu/polygonize/work.ts';
import { finished } from '../../../src/math/finished.ts';
import { topology } from '../../../src/mesh/check.ts';
import { BONE, body, placed, RIGID, SKEW, sphere } from '../../field/trees.ts';
import { bricksOf } from '../../fixtures/bricks.ts';
import { random } from '../../fixtures/random.ts';
import { withDevice } from '../compute.ts';
import { closeDawn, describeGpu } from '../dawn.ts';

afterAll(closeDawn);

const CELLS = 32;
/** cells: what lists miss moves vertices by a fifth of what they may */
const OFF = 0.004;
/** ms: pipelines of six kinds */
const PATIENCE = 120_000;

function bush(seed: number): FieldNode {
  const next = random(seed);
  const at = () => [8 * next() - 4, 8 * next() - 4, 8 * next() - 4] as const;
  const one = (): Term => ({
    skel: { type: 'segment', a: at(), b: at(), weights: [1 + next(), 0.1 * next()] },
    colour: [next(), next(), next()],
  });
  return body(Array.from({ length: 12 }, one));
}

const torus: FieldNode = { type: 'shape', shape: { type: 'torus', ring: 4, tube: 1 } };
const bone = body(BONE);

const BODIES: Readonly<Record<string, FieldNode>> = {
  'a bush of 12 segments (seed 5)': bush(5),
  'a torus': torus,
  'a body of sections': body([
    {
      ...BONE[0]!,
      warp: { section: { type: 'superQuadric', exponent: 4 }, scale: [1.5, 0.8], up: [0, 1, 0] },
    },
    { ...BONE[1]!, warp: { section: { type: 'round' }, scale: [1, 2], up: [0, 1, 0], along: [0, 0, 1] } },
  ]),
  'a moved body': { type: 'affine', matrix: RIGID, node: bone },
  'a union of bodies and a ball': {
    type: 'union',
    form: 'hard',
    parts: [bush(6), placed(bone, 6, 0, 0), placed(sphere(2), -6, 1, 0)],
  },
  'a stretched body that blends with a ball': {
    type: 'blend',
    a: { type: 'affine', matrix: SKEW, node: bone },
    b: placed(sphere(3), 5, 1, 0),
    a0: 0.5,
    a1: 1,
    a2: 1,
  },
};

/** How far vertices are from the surface of all skels, in cells, but for the last few of a thousand, where blades are. */
function off(field: ReturnType<typeof bindField>, { positions }: FieldMesh, step: number): number {
  const out = new Float64Array(4);
  const all = Float64Array.from({ length: positions.length / 3 }, (_, v) => {
    field.evaluate(positions[3 * v]!, positions[3 * v + 1]!, positions[3 * v + 2]!, out);
    return Math.abs(out[0]!) / Math.hypot(out[1]!, out[2]!, out[3]!) / step;
  }).sort();
  return all[Math.floor(0.995 * all.length)]!;
}

const sphereOf = (radius: number): FieldNode => ({ type: 'shape', shape: { type: 'sphere', radius } });

describeGpu('meshes of bricks that the device finds', () => {
  it.each(Object.entries(BODIES))(
    'are those of the CPU: %s',
    async (_, node) => {
      expect(cullsOnDevice(node)).toBe(true);
      const field = bindField(node);
      const lattice = latticeAround(field.box!, CELLS);
      const [own, expected] = await withDevice(async (device) => {
        const polygonizer = gpuPolygonizer(device);
        const meshes = [lattice, bricksOf(node, lattice)].map(async (where) => {
          const mesh = await polygonizer.whole(node, where);
          return mesh.read();
        });
        const made = [await meshes[0]!, await meshes[1]!] as const;
        polygonizer.destroy();
        return made;
      });
      expect(topology(own)).toEqual(topology(expected));
      expect(own.positions.length).toBe(expected.positions.length);
      expect(own.indices.length).toBe(expected.indices.length);
      expect(off(field, own, lattice.step)).toBeLessThan(OFF);
      const painted = own.colours.every((c, i) => Math.abs(c - expected.colours[i]!) < 0.02);
      expect(painted).toBe(true);
    },
    PATIENCE,
  );

  it(
    'go before others and after them, whose bricks the CPU finds, on one polygonizer',
    async () => {
      const [large, small] = [bush(5), sphereOf(2)];
      await withDevice(async (device) => {
        const polygonizer = gpuPolygonizer(device);
        for (const [node, culls] of [
          [large, true],
          [small, false],
          [large, false],
          [small, true],
        ] as const) {
          const lattice = latticeAround(bindField(node).box!, CELLS);
          const mesh = await polygonizer.whole(node, culls ? lattice : bricksOf(node, lattice));
          expect(topology(await mesh.read())).toMatchObject({ watertight: true });
          mesh.destroy();
        }
        polygonizer.destroy();
      });
    },
    PATIENCE,
  );

  it(
    'say what they took, nearly',
    async () => {
      const node = bush(5);
      const field = bindField(node);
      const lattice = latticeAround(field.box!, CELLS);
      const tally = new Tally();
      const { nodes, aVertex } = gpuWork(finished(culling(field.near(tally), lattice)));
      await withDevice(async (device) => {
        const polygonizer = gpuPolygonizer(device);
        const { work, vertices } = await (await polygonizer.whole(node, lattice)).needed();
        // the device begins with smaller cubes
        const ratio = work / (tally.work + nodes + aVertex * vertices);
        expect(ratio).toBeGreaterThan(0.9);
        expect(ratio).toBeLessThan(1.1);
        polygonizer.destroy();
      });
    },
    PATIENCE,
  );

  it(
    'are empty where nothing is, and refuse what only the CPU culls',
    async () => {
      const lattice: Lattice = { origin: [-4, -4, -4], step: 0.5, counts: [17, 17, 17] };
      await withDevice(async (device) => {
        const polygonizer = gpuPolygonizer(device);
        const mesh = await polygonizer.whole({ ...body([BONE[0]!]), threshold: 1e3 }, lattice);
        expect((await mesh.read()).indices.length).toBe(0);
        const odd = { ...lattice, counts: [18, 17, 17] } as const;
        await expect(polygonizer.polygonize(sphere(2), odd)).rejects.toThrow('18 × 17 × 17');
        const flat = { ...body([BONE[2]!]), kernel: 'inverseCubic', params: {} };
        expect(cullsOnDevice(flat)).toBe(false);
        await expect(polygonizer.polygonize(flat, lattice)).rejects.toThrow('cannot find');
        await expect(polygonizer.polygonize(body([BONE[0]!], 0), lattice)).rejects.toThrow(
          'threshold must be above 0',
        );
        polygonizer.destroy();
      });
    },
    PATIENCE,
  );

  it(
    'have room made for them where there was too little',
    async () => {
      // blobs everywhere: four times the bricks that a surface is given room for
      const skels: Term[] = Array.from({ length: 343 }, (_, i) => ({
        skel: { type: 'point', at: [i % 7, Math.floor(i / 7) % 7, Math.floor(i / 49)], weight: 1 },
      }));
      const node = { ...body(skels), kernel: 'quartic', params: { R: 0.5 }, threshold: 0.4 } as const;
      const lattice: Lattice = { origin: [-0.6, -0.6, -0.6], step: 0.113, counts: [65, 65, 65] };
      await withDevice(async (device) => {
        const polygonizer = gpuPolygonizer(device);
        const first = await polygonizer.polygonize(node, lattice);
        expect(await first.overflowed()).toBe(true);
        await expect(first.read()).rejects.toThrow('did not fit');
        first.destroy();
        const mesh = await polygonizer.whole(node, lattice);
        expect(topology(await mesh.read())).toMatchObject({ watertight: true, components: 343, euler: 686 });
        // and at once the next time
        expect(await (await polygonizer.polygonize(node, lattice)).overflowed()).toBe(false);
        polygonizer.destroy();
      });
    },
    PATIENCE,
  );
});
