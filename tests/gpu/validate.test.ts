/** All that can be linked is valid WGSL: on Dawn's null backend, which needs no driver, so that this runs everywhere. */
import { afterAll, describe, expect, it } from 'vitest';
import { create } from 'webgpu';
import {
  type Ingredient,
  type Ingredients,
  KINDS,
  type Named,
  noIngredients,
  REGISTRY,
} from '../../src/gpu/ingredients.ts';
import { type Entry, fieldPipelines } from '../../src/gpu/pipelines.ts';
import { EVERYTHING } from './everything.ts';

const dawn: { gpu: GPU | null } = { gpu: create(['backend=null']) as GPU };
afterAll(() => {
  dawn.gpu = null;
});

const adapter = await dawn.gpu?.requestAdapter();
const device = await adapter?.requestDevice();

const { kernels, primitives, sections, shapes, operations } = REGISTRY;
const ENTRIES: readonly Entry[] = ['points', 'colours', 'pairs'];

type Wanted = { readonly [K in Ingredient]?: readonly Named<K>[] };

const of = (wanted: Wanted): Ingredients => {
  const made = noIngredients() as Record<Ingredient, Set<string>>;
  for (const kind of KINDS) made[kind] = new Set(wanted[kind] ?? []);
  return made as unknown as Ingredients;
};

async function validate(ingredients: Ingredients, entries: readonly Entry[] = ['points']): Promise<void> {
  if (!device) throw new Error('no null backend');
  const pipelines = fieldPipelines(device, ingredients);
  device.pushErrorScope('validation');
  await Promise.all(entries.map((entry) => pipelines.pipeline(entry)));
  expect((await device.popErrorScope())?.message ?? null).toBeNull();
}

/** all subsets but the empty one */
const mixes = <T>(names: readonly T[]): readonly (readonly T[])[] =>
  Array.from({ length: 2 ** names.length - 1 }, (_, bits) => names.filter((_, i) => (bits + 1) & (1 << i)));

describe('on the null backend', () => {
  it.each(kernels)('%s is valid with every primitive and every section', async (kernel) => {
    for (const primitive of primitives) {
      await validate(of({ kernels: [kernel], primitives: [primitive] }), ENTRIES);
      for (const section of sections) {
        await validate(of({ kernels: [kernel], primitives: [primitive], sections: [section] }));
      }
    }
  });

  it('every pair of kernels is valid with all primitives', async () => {
    for (const [i, one] of kernels.entries()) {
      for (const other of kernels.slice(i + 1)) await validate(of({ kernels: [one, other], primitives }));
    }
  });

  it('all kernels together are valid with every mix of primitives, of sections', async () => {
    for (const some of mixes(primitives)) await validate(of({ kernels, primitives: some }));
    for (const some of mixes(sections))
      await validate(of({ kernels: ['cauchy'], primitives, sections: some }));
  });

  it.each(shapes)('the shape %s is valid alone and with every operation', async (shape) => {
    await validate(of({ shapes: [shape] }), ['points', 'colours']);
    for (const operation of operations) {
      await validate(of({ shapes: [shape], operations: [operation] }));
      await validate(of({ kernels: ['cauchy'], primitives, shapes: [shape], operations: [operation] }));
    }
  });

  it('every mix of operations is valid, and everything together', async () => {
    for (const some of mixes(operations)) {
      await validate(of({ kernels: ['quartic'], primitives: ['segment'], shapes, operations: some }));
    }
    await validate(EVERYTHING, ENTRIES);
  });
});
