/** All that can be linked is valid WGSL: on Dawn's null backend, which needs no driver, so that this runs everywhere. */
import { afterAll, describe, expect, it } from 'vitest';
import { create } from 'webgpu';
import { fieldPipelines } from '../../src/gpu/pipelines.ts';
import { PRIMITIVES, type Primitive } from '../../src/gpu/structs.ts';
import { kernels } from '../../src/kernel/index.ts';

const dawn: { gpu: GPU | null } = { gpu: create(['backend=null']) as GPU };
afterAll(() => {
  dawn.gpu = null;
});

const adapter = await dawn.gpu?.requestAdapter();
const device = await adapter?.requestDevice();

const KERNELS = kernels.map(({ name }) => name);

/** all subsets but the empty one */
const MIXES: readonly (readonly Primitive[])[] = [1, 2, 3, 4, 5, 6, 7].map((bits) =>
  PRIMITIVES.filter((_, i) => bits & (1 << i)),
);

async function validate(named: readonly string[], primitives: readonly Primitive[]): Promise<void> {
  if (!device) throw new Error('no null backend');
  const pipelines = fieldPipelines(device, { kernels: named, primitives });
  device.pushErrorScope('validation');
  await Promise.all([pipelines.pipeline('points'), pipelines.pipeline('pairs')]);
  expect((await device.popErrorScope())?.message ?? null).toBeNull();
}

describe('on the null backend', () => {
  for (const kernel of KERNELS) {
    it(`${kernel} is valid with every primitive`, async () => {
      for (const primitive of PRIMITIVES) await validate([kernel], [primitive]);
    });
  }

  it('every pair of kernels is valid with all primitives', async () => {
    for (const one of KERNELS) {
      for (const other of KERNELS.slice(KERNELS.indexOf(one) + 1)) {
        await validate([one, other], PRIMITIVES);
      }
    }
  });

  it('all kernels together are valid with every mix of primitives', async () => {
    for (const primitives of MIXES) await validate(KERNELS, primitives);
  });

  it('a kernel that is none is refused, with its importer', async () => {
    await expect(validate(['none'], ['point'])).rejects.toThrow('kernel.wgsl imports kernel/none');
  });
});
