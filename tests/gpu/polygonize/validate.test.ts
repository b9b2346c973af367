/** The stages are valid WGSL within the limits that every device has: on Dawn's null backend, which needs no driver. */
import { afterAll, describe, expect, it } from 'vitest';
import { create } from 'webgpu';
import { brickStagesOn } from '../../../src/gpu/bricks/stages.ts';
import { noIngredients } from '../../../src/gpu/ingredients.ts';
import { stagesOn } from '../../../src/gpu/polygonize/stages.ts';
import { EVERYTHING } from '../everything.ts';

const dawn: { gpu: GPU | null } = { gpu: create(['backend=null']) as GPU };
afterAll(() => {
  dawn.gpu = null;
});

const adapter = await dawn.gpu?.requestAdapter();
// asks for nothing, and has the defaults
const device = await adapter?.requestDevice();

describe('the stages of the polygonizer on the null backend', () => {
  it('have default limits to live in', () => {
    const { maxStorageBuffersPerShaderStage, maxComputeInvocationsPerWorkgroup } = device!.limits;
    expect([maxStorageBuffersPerShaderStage, maxComputeInvocationsPerWorkgroup]).toEqual([8, 256]);
  });

  it.each([
    ['everything', EVERYTHING, false],
    ['everything, with creases', EVERYTHING, true],
    ['a shape', { ...noIngredients(), shapes: new Set(['sphere'] as const) }, false],
    ['a shape with creases', { ...noIngredients(), shapes: new Set(['cylinder'] as const) }, true],
    [
      'one kernel',
      {
        ...noIngredients(),
        kernels: new Set(['cauchy'] as const),
        primitives: new Set(['segment'] as const),
      },
      true,
    ],
  ])('are valid for %s', async (_, ingredients, hasCreases) => {
    device!.pushErrorScope('validation');
    await Promise.all([stagesOn(device!)(ingredients, hasCreases), brickStagesOn(device!)(ingredients)]);
    expect((await device!.popErrorScope())?.message ?? null).toBeNull();
  });
});
