import { afterAll, describe, expect, it } from 'vitest';
import { gpuField } from '../../src/gpu/field.ts';
import type { KernelSkel } from '../../src/gpu/records.ts';
import { kernelNamed } from '../../src/kernel/index.ts';
import type { PolygonSkel, Skel } from '../../src/skeleton/skels.ts';
import { random } from '../fixtures/random.ts';
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

const of = (name: string, ...skels: readonly Skel[]): KernelSkel[] => {
  const kernel = kernelNamed(name)!;
  const params = Object.fromEntries(kernel.params.map((spec) => [spec.name, spec.name === 'R' ? 3 : 1]));
  return skels.map((skel) => ({ skel, kernel, params: { ...params, ...(params.n ? { n: 2.5 } : {}) } }));
};

/** x, y, z, x, … in [−3, 3) */
function somewhere(count: number, seed: number): Float32Array {
  const uniform = random(seed);
  return Float32Array.from({ length: 3 * count }, () => 6 * uniform() - 3);
}

const largest = (numbers: ArrayLike<number>): number => Math.max(...Array.from(numbers, Math.abs));

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
  it('is the sum of its skels, whatever kernels they mix (seed 31)', async () => {
    await withDevice(async (device) => {
      const skels = [...of('cauchy', SQUARE, LINE), ...of('quartic', LINE, DOT), ...of('gaussian', DOT)];
      const points = somewhere(200, 31);
      const whole = gpuField(device, skels);
      const together = await whole.evaluate(points);
      const apart = new Float64Array(together.length);
      for (const skel of skels) {
        const alone = gpuField(device, [skel]);
        (await alone.evaluate(points)).forEach((number, i) => {
          apart[i] = apart[i]! + number;
        });
        alone.destroy();
      }
      whole.destroy();
      const scale = largest(apart);
      expect(scale).toBeGreaterThan(1);
      expect(largest(together.map((number, i) => number - apart[i]!))).toBeLessThan(2e-6 * scale);
    });
  });

  it('gives each skel its own point when asked for pairs (seed 32)', async () => {
    await withDevice(async (device) => {
      const skels = [...of('inverse', SQUARE, LINE, DOT), ...of('quartic', LINE)];
      const points = somewhere(skels.length, 32);
      const field = gpuField(device, skels);
      const pairs = await field.evaluatePairs(points);
      for (const [i, skel] of skels.entries()) {
        field.update([skel]);
        const alone = await field.evaluate(points.subarray(3 * i, 3 * i + 3));
        const error = largest(alone.map((number, k) => number - pairs[4 * i + k]!));
        expect(error).toBeLessThanOrEqual(1e-6 * largest(alone));
      }
      await expect(async () => field.evaluatePairs(points)).rejects.toThrow('4 points for 1 skels');
      field.destroy();
    });
  });

  it('compiles nothing when parameters, weights or places change, or points are added', async () => {
    await withDevice(async (device) => {
      const counts = counting(device);
      const field = gpuField(device, of('cauchy', LINE, DOT));
      const points = somewhere(100, 33);
      const before = await field.evaluate(points);
      expect(counts).toEqual({ pipelines: 1, modules: 1 });
      const moved: Skel = { ...LINE, a: [-2, 0.5, 1], weights: [2, 0, 0.1] };
      const wider = of('cauchy', moved, DOT, DOT).map((skel) => ({ ...skel, params: { s: 0.7 } }));
      field.update(wider);
      const after = await field.evaluate(somewhere(150, 33));
      expect(after.subarray(0, 400)).not.toEqual(before);
      const other = gpuField(device, of('cauchy', DOT, LINE));
      await other.evaluate(points);
      expect(counts).toEqual({ pipelines: 1, modules: 1 });
      field.update(of('cauchy', SQUARE));
      await field.evaluate(points);
      expect(counts).toEqual({ pipelines: 2, modules: 2 });
      field.destroy();
      other.destroy();
    });
  });

  it('may be changed and given up while values are on their way', async () => {
    await withDevice(async (device) => {
      device.pushErrorScope('validation');
      const points = somewhere(100, 34);
      const field = gpuField(device, of('cauchy', LINE));
      const steady = gpuField(device, of('cauchy', LINE));
      const first = field.evaluate(points);
      field.update(of('cauchy', DOT));
      const second = field.evaluate(points);
      field.destroy();
      expect(await first).toEqual(await steady.evaluate(points));
      steady.update(of('cauchy', DOT));
      expect(await second).toEqual(await steady.evaluate(points));
      steady.destroy();
      expect(await device.popErrorScope()).toBeNull();
    });
  });

  it('is 0 without skels, and nothing without points', async () => {
    await withDevice(async (device) => {
      const field = gpuField(device, []);
      expect(await field.evaluate(Float32Array.of(1, 2, 3))).toEqual(new Float32Array(4));
      field.update(of('cauchy', DOT));
      expect(await field.evaluate(new Float32Array())).toEqual(new Float32Array());
      field.destroy();
    });
  });

  it('is finite on the skels themselves, also where the kernel is singular', async () => {
    await withDevice(async (device) => {
      const none: Skel = { type: 'segment', a: [1, 1, 1], b: [1, 1, 1], weights: [1] };
      for (const name of ['inverse', 'inverseSquared', 'inverseCubic', 'inverseQuintic', 'cauchy']) {
        const skels = of(name, LINE, LINE, LINE, DOT, SQUARE, SQUARE, SQUARE, none);
        const field = gpuField(device, skels);
        const at = [
          [-2, 0, 1],
          [0, 0.5, 0.5],
          [2, 1, 0],
          [0, 2, 0],
          [0, 0, 0],
          [1, 0, 0],
          [1, 1, 0],
          [1, 1, 1],
        ];
        const values = await field.evaluatePairs(Float32Array.from(at.flat()));
        expect(values.every(Number.isFinite), `${name}: ${values}`).toBe(true);
        expect([...values.subarray(28)].map(Math.abs)).toEqual([0, 0, 0, 0]);
        field.destroy();
      }
    });
  });

  it('leaves an exact 0 beyond a support', async () => {
    await withDevice(async (device) => {
      const field = gpuField(device, of('quartic', SQUARE, LINE, DOT));
      const values = await field.evaluate(Float32Array.of(40, 0, 0, 0, 4.5, 4.5, 0, 0, 3.01));
      expect([...values.subarray(0, 8)].map(Math.abs)).toEqual(new Array(8).fill(0));
      field.destroy();
    });
  });
});

describe('records of skels', () => {
  it('refuse what has no field, before any device is asked', () => {
    const device = {} as GPUDevice;
    const flat = { ...SQUARE, v: [2, 0, 0] } as const;
    expect(() => gpuField(device, of('cauchy', flat))).toThrow();
  });
});
