/** The life of a field on the GPU: it compiles when its make changes only, and may change at any time. */
import { afterAll, describe, expect, it } from 'vitest';
import { bindField } from '../../src/field/bind.ts';
import type { FieldNode, SkelsNode, Term } from '../../src/field/node.ts';
import { gpuField } from '../../src/gpu/field.ts';
import { kernelNamed } from '../../src/kernel/index.ts';
import type { PolygonSkel, Skel } from '../../src/skeleton/skels.ts';
import { BONE, body, evaluated, type Point, placed, points, sphere } from '../field/trees.ts';
import { withDevice } from './compute.ts';
import { closeDawn, describeGpu } from './dawn.ts';

afterAll(closeDawn);

const SQUARE: PolygonSkel = {
  type: 'polygon',
  origin: [0, 0, 0],
  u: [1, 0, 0],
  v: [0, 1, 0],
  loops: [
    [
      [-1, -1],
      [1, -1],
      [1, 1],
      [-1, 1],
    ],
  ],
  weight: 1,
};
const LINE: Skel = { type: 'segment', a: [-2, 0, 1], b: [2, 1, 0], weights: [1, 0.25] };
const DOT: Skel = { type: 'point', at: [0, 2, 0], weight: 1.5 };

const sum = (kernel: string, ...skels: readonly Skel[]): SkelsNode => {
  const params = Object.fromEntries(
    kernelNamed(kernel)!.params.map(({ name }) => [name, name === 's' ? 1 : 3]),
  );
  return { type: 'skels', kernel, params, threshold: 1, skels: skels.map((skel) => ({ skel })) };
};
const united = (...parts: readonly FieldNode[]): FieldNode => ({ type: 'union', form: 'smooth', parts });

const flat = (list: readonly Point[]): Float32Array => Float32Array.from(list.flat());
const SOMEWHERE = flat(points(100, 3, 33));

/** Counts what a device compiles from now on. */
function counting(device: GPUDevice): { pipelines: number; modules: number } {
  const counts = { pipelines: 0, modules: 0 };
  const count = <K extends 'createComputePipeline' | 'createComputePipelineAsync' | 'createShaderModule'>(
    name: K,
    what: keyof typeof counts,
  ) => {
    const made = device[name].bind(device) as (descriptor: never) => unknown;
    Object.defineProperty(device, name, {
      value: (descriptor: never) => {
        counts[what]++;
        return made(descriptor);
      },
    });
  };
  count('createComputePipeline', 'pipelines');
  count('createComputePipelineAsync', 'pipelines');
  count('createShaderModule', 'modules');
  return counts;
}

describeGpu('a field on the GPU', () => {
  it('is its twin at a list of points (seed 31)', async () => {
    const node = united(body(), placed(sphere(2), 3, 1, 0));
    const twin = bindField(node);
    const at = points(300, 6, 31).map((p) => p.map(Math.fround) as unknown as Point);
    await withDevice(async (device) => {
      const field = gpuField(device, node);
      const values = await field.evaluate(flat(at));
      at.forEach((p, i) => {
        evaluated(twin, p).forEach((number, k) => {
          expect(Math.abs(values[4 * i + k]! - number)).toBeLessThan(1e-5 * (1 + Math.abs(number)));
        });
      });
      field.destroy();
    });
  });

  it('compiles nothing when numbers, places, skels or the tree itself change', async () => {
    await withDevice(async (device) => {
      const counts = counting(device);
      const field = gpuField(device, united(sum('cauchy', LINE, DOT), sphere(1)));
      const before = await field.evaluate(SOMEWHERE);
      expect(counts).toEqual({ pipelines: 1, modules: 1 });
      const moved: Skel = { ...LINE, a: [-2, 0.5, 1], weights: [2, 0, 0.1] };
      const wider = { ...sum('cauchy', moved, DOT, DOT), params: { s: 0.7 }, threshold: 0.5 };
      field.update(united(placed(wider, 1, 0, 0), sphere(2)));
      expect(await field.evaluate(SOMEWHERE)).not.toEqual(before);
      // another structure of the same make
      field.update(united(sphere(1), united(sum('cauchy', DOT), sphere(3), sum('cauchy', LINE))));
      await field.evaluate(SOMEWHERE);
      const other = gpuField(device, united(sphere(1), sum('cauchy', DOT, LINE)));
      await other.evaluate(SOMEWHERE.subarray(0, 30));
      expect(counts).toEqual({ pipelines: 1, modules: 1 });
      field.update(united(sum('quartic', LINE), sphere(1)));
      await field.evaluate(SOMEWHERE);
      expect(counts).toEqual({ pipelines: 2, modules: 2 });
      field.destroy();
      other.destroy();
    });
  });

  it('may be changed and given up while values are on their way', async () => {
    await withDevice(async (device) => {
      device.pushErrorScope('validation');
      const field = gpuField(device, sum('cauchy', LINE));
      const steady = gpuField(device, sum('cauchy', LINE));
      const first = field.evaluate(SOMEWHERE);
      field.update(sum('cauchy', DOT));
      const second = field.evaluate(SOMEWHERE);
      field.destroy();
      expect(await first).toEqual(await steady.evaluate(SOMEWHERE));
      steady.update(sum('cauchy', DOT));
      expect(await second).toEqual(await steady.evaluate(SOMEWHERE));
      steady.destroy();
      expect(await device.popErrorScope()).toBeNull();
    });
  });

  it('says what the device refuses, in place of zeros, and that it was given back', async () => {
    await withDevice(async (device) => {
      const field = gpuField(device, sum('cauchy', DOT));
      const { createBindGroup } = device;
      // what belongs to no layout is invalid, as a buffer that there was no memory for would be
      device.createBindGroup = (descriptor) => createBindGroup.call(device, { ...descriptor, entries: [] });
      await expect(field.evaluate(SOMEWHERE)).rejects.toThrow('the graphics device refused a field');
      device.createBindGroup = createBindGroup;
      expect((await field.evaluate(SOMEWHERE)).some((number) => number !== 0)).toBe(true);
      field.destroy();
      await expect(field.evaluate(SOMEWHERE)).rejects.toThrow('given back');
    });
  });

  it('keeps no results', async () => {
    const points = new Float32Array(3 << 16);
    await withDevice(async (device) => {
      const field = gpuField(device, sum('quartic', DOT));
      const results: WeakRef<Float32Array>[] = [];
      for (let i = 0; i < 8; i++) results.push(new WeakRef(await field.evaluate(points)));
      await expect
        .poll(
          () => {
            // garbage is collected under pressure
            new Array(1 << 16).fill(0).map(() => new Float64Array(16));
            return results.filter((result) => result.deref()).length;
          },
          { timeout: 20_000 },
        )
        .toBeLessThan(8);
      field.destroy();
    });
  });

  it('stays finite inside of hundreds of smoothly united bodies', async () => {
    const node: FieldNode = { type: 'union', form: 'smooth', parts: new Array(400).fill(sphere(2)) };
    await withDevice(async (device) => {
      const field = gpuField(device, node);
      const values = await field.evaluate(Float32Array.of(0.5, 0, 0, 1.999, 0, 0, 3, 0, 0));
      expect([...values.subarray(0, 4)]).toEqual([Math.fround(1e30), 0, 0, 0]);
      expect(values.every(Number.isFinite)).toBe(true);
      expect(values[8]).toBeLessThan(0);
      await expect(field.evaluate(Float32Array.of(1, 2))).rejects.toThrow('no list of points');
      field.destroy();
    });
  });

  it('keeps the tree before when the next has no field', async () => {
    await withDevice(async (device) => {
      const field = gpuField(device, sum('cauchy', DOT));
      const before = await field.evaluate(SOMEWHERE);
      expect(() => field.update({ ...sum('cauchy', DOT), threshold: 0 })).toThrow(
        'threshold must be above 0',
      );
      expect(await field.evaluate(SOMEWHERE)).toEqual(before);
      expect(await field.evaluate(new Float32Array())).toEqual(new Float32Array());
      field.destroy();
    });
  });

  it('is finite on the skels themselves, also where the kernel is singular', async () => {
    const on = flat([
      [-2, 0, 1],
      [0, 0.5, 0.5],
      [2, 1, 0],
      [0, 2, 0],
      [0, 0, 0],
      [1, 0, 0],
      [1, 1, 0],
    ]);
    await withDevice(async (device) => {
      for (const name of ['inverse', 'inverseSquared', 'inverseCubic', 'inverseQuintic', 'cauchy']) {
        const field = gpuField(device, sum(name, LINE, DOT, SQUARE));
        const values = [...(await field.evaluate(on)), ...(await field.colours(on))];
        expect(values.every(Number.isFinite), `${name}: ${values}`).toBe(true);
        field.destroy();
      }
    });
  });

  it('is −T, exactly, beyond a support and without skels of a length', async () => {
    const none: Skel = { type: 'segment', a: [1, 1, 1], b: [1, 1, 1], weights: [1] };
    await withDevice(async (device) => {
      const field = gpuField(device, sum('quartic', SQUARE, LINE, DOT, none));
      const values = await field.evaluate(Float32Array.of(40, 0, 0, 0, 5.5, 5.5, 0, 0, 4.5));
      expect([...values]).toEqual([-1, 0, 0, 0, -1, 0, 0, 0, -1, 0, 0, 0]);
      field.destroy();
    });
  });

  it('has the colours of its skels, and the first where none reaches', async () => {
    const terms: readonly Term[] = [
      { skel: DOT, colour: [1, 0.5, 0] },
      { skel: { ...DOT, at: [50, 0, 0] }, colour: [0, 0, 1] },
    ];
    await withDevice(async (device) => {
      const field = gpuField(device, { ...sum('quartic'), skels: terms });
      const colours = await field.colours(Float32Array.of(0, 2, 0, 50, 0, 0, 0, 99, 0));
      expect([...colours]).toEqual([0.5, 1, 0.5, 0, 0.5, 0, 0, 1, -1, 1, 0.5, 0]);
      field.destroy();
    });
  });
});

describe('records of a tree', () => {
  it('are not made of what has no field, before any device is asked', () => {
    const flatSquare = { ...SQUARE, v: [2, 0, 0] } as const;
    expect(() => gpuField({} as GPUDevice, sum('cauchy', flatSquare))).toThrow('skels[0]: ');
    expect(() => gpuField({} as GPUDevice, { ...body(), skels: BONE, kernel: 'none' })).toThrow('none');
  });
});
