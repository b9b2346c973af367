/** The life of meshes on the GPU: what does not fit is told and made again, buffers stay, a lost device is named. */
import { afterAll, expect, it } from 'vitest';
import { bindField } from '../../../src/field/bind.ts';
import { latticeAround } from '../../../src/field/lattice.ts';
import { readBack } from '../../../src/gpu/polygonize/buffers.ts';
import type { GpuMesh } from '../../../src/gpu/polygonize/gpuMesh.ts';
import { packBricks } from '../../../src/gpu/polygonize/lists.ts';
import { gpuPolygonizer } from '../../../src/gpu/polygonize/polygonizer.ts';
import { sphere } from '../../field/trees.ts';
import { bricksOf } from '../../fixtures/bricks.ts';
import { withDevice } from '../compute.ts';
import { closeDawn, describeGpu } from '../dawn.ts';

afterAll(closeDawn);

const BALL = sphere(2);
const BRICKS = bricksOf(BALL, latticeAround(bindField(BALL).box!, 16));
const LARGER = bricksOf(sphere(2.5), latticeAround(bindField(sphere(2.5)).box!, 24));

/** The five numbers of an indexed draw. */
async function drawn(device: GPUDevice, { draw }: GpuMesh): Promise<readonly number[]> {
  const [bytes] = await readBack(device, [{ buffer: draw, size: 20 }]);
  return [...new Uint32Array(bytes!)];
}

/** Counts what a device makes from now on. */
function counting(device: GPUDevice): { buffers: number; pipelines: number } {
  const counts = { buffers: 0, pipelines: 0 };
  const { createBuffer, createComputePipelineAsync } = device;
  device.createBuffer = (descriptor) => {
    // what is read back is no part of the work
    if (descriptor.label !== 'read back') counts.buffers++;
    return createBuffer.call(device, descriptor);
  };
  device.createComputePipelineAsync = (descriptor) => {
    counts.pipelines++;
    return createComputePipelineAsync.call(device, descriptor);
  };
  return counts;
}

describeGpu('a mesh on the GPU', () => {
  it.each([
    ['vertices', { vertices: 50, triangles: 5000 }],
    ['triangles', { vertices: 2500, triangles: 50 }],
    ['either', { vertices: 1, triangles: 1 }],
  ] as const)(
    'that has too little room for %s draws nothing, says so, and fits when made again',
    async (_, room) => {
      await withDevice(async (device) => {
        const whole = gpuPolygonizer(device);
        const expected = await (await whole.polygonize(BALL, BRICKS)).read();
        const polygonizer = gpuPolygonizer(device, room);
        const small = await polygonizer.polygonize(BALL, BRICKS);
        expect(await small.overflowed()).toBe(true);
        expect(await drawn(device, small)).toEqual([0, 1, 0, 0, 0]);
        expect(await small.needed()).toMatchObject({
          vertices: expected.positions.length / 3,
          triangles: expected.indices.length / 3,
        });
        await expect(small.read()).rejects.toThrow('did not fit');
        const mesh = await polygonizer.whole(BALL, BRICKS);
        expect(await mesh.overflowed()).toBe(false);
        expect(await drawn(device, mesh)).toEqual([expected.indices.length, 1, 0, 0, 0]);
        expect(await mesh.read()).toEqual(expected);
        polygonizer.destroy();
        whole.destroy();
      });
    },
  );

  it('just fits', async () => {
    await withDevice(async (device) => {
      const first = gpuPolygonizer(device);
      const room = await (await first.polygonize(BALL, BRICKS)).needed();
      const exact = gpuPolygonizer(device, room);
      expect(await (await exact.polygonize(BALL, BRICKS)).overflowed()).toBe(false);
      const less = gpuPolygonizer(device, { ...room, triangles: room.triangles - 1 });
      expect(await (await less.polygonize(BALL, BRICKS)).overflowed()).toBe(true);
      for (const polygonizer of [first, exact, less]) polygonizer.destroy();
    });
  });

  it('takes the buffers of those that were destroyed, and is whole beside others', async () => {
    await withDevice(async (device) => {
      const polygonizer = gpuPolygonizer(device);
      const first = await polygonizer.polygonize(sphere(2.5), LARGER);
      const kept = await first.read();
      const counts = counting(device);
      const beside = await polygonizer.polygonize(BALL, BRICKS);
      const small = await beside.read();
      expect(await first.read()).toEqual(kept);
      expect(counts.pipelines).toBe(0);
      beside.destroy();
      await expect(beside.read()).rejects.toThrow('given back');
      counts.buffers = 0;
      // as a worker would hand them over
      const again = await polygonizer.polygonize(BALL, structuredClone(packBricks(BALL, BRICKS)));
      expect(counts.buffers).toBe(0);
      expect(await again.read()).toEqual(small);
      expect(await first.read()).toEqual(kept);
      polygonizer.destroy();
      await expect(polygonizer.polygonize(BALL, BRICKS)).rejects.toThrow('given back');
    });
  });

  it('refuses a lattice without whole bricks, and goes on after it', async () => {
    await withDevice(async (device) => {
      const polygonizer = gpuPolygonizer(device);
      const lattice = { ...BRICKS.lattice, counts: [18, 17, 17] } as const;
      await expect(polygonizer.polygonize(BALL, { ...BRICKS, lattice })).rejects.toThrow('18 × 17 × 17');
      expect((await (await polygonizer.polygonize(BALL, BRICKS)).read()).indices.length).toBeGreaterThan(0);
      polygonizer.destroy();
    });
  });

  it('is told from a lost device', async () => {
    await withDevice(async (device) => {
      const polygonizer = gpuPolygonizer(device);
      const mesh = await polygonizer.polygonize(BALL, BRICKS);
      device.destroy();
      await device.lost;
      await expect(mesh.read()).rejects.toThrow('the graphics device was lost');
      await expect(mesh.overflowed()).rejects.toThrow('the graphics device was lost');
      await expect(polygonizer.polygonize(BALL, BRICKS)).rejects.toThrow('the graphics device was lost');
    });
  });
});
