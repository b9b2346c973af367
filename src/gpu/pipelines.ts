/**
 * Compute pipelines, made once a device for each entry × ingredients: parameters, weights, places and the tree itself are
 * data, so that nothing compiles when they change.
 */
import { type Ingredients, keyOf } from './ingredients.ts';
import { compile, link } from './link.ts';
import { fieldModules } from './modules.ts';

/** Files in shaders/field and the function that each begins with. */
const ENTRIES = {
  points: 'field_at_points',
  colours: 'colours_at_points',
  pairs: 'each_at_its_point',
} as const;
export type Entry = keyof typeof ENTRIES;

/** GPUShaderStage.COMPUTE, which is a global of browsers only. */
const COMPUTE = 0x4;

export interface FieldPipelines {
  /** of group 0: points in, values out */
  readonly pass: GPUBindGroupLayout;
  /** of group 1: the records */
  readonly field: GPUBindGroupLayout;
  pipeline(entry: Entry): Promise<GPUComputePipeline>;
}

const made = new WeakMap<GPUDevice, Map<string, FieldPipelines>>();

/** The pipelines for these ingredients; none is compiled before it is asked for. */
export function fieldPipelines(device: GPUDevice, ingredients: Ingredients): FieldPipelines {
  const known = made.get(device) ?? new Map<string, FieldPipelines>();
  made.set(device, known);
  const key = keyOf(ingredients);
  const pipelines = known.get(key) ?? prepare(device, ingredients, key);
  known.set(key, pipelines);
  return pipelines;
}

function prepare(device: GPUDevice, ingredients: Ingredients, key: string): FieldPipelines {
  const field = layout(device, 'records', ['read-only-storage']);
  const pass = layout(device, 'points and values', ['read-only-storage', 'storage']);
  const pipelineLayout = device.createPipelineLayout({ label: key, bindGroupLayouts: [pass, field] });
  const begun = new Map<Entry, Promise<GPUComputePipeline>>();
  const begin = async (entry: Entry): Promise<GPUComputePipeline> => {
    const label = `field/${entry}: ${key}`;
    const module = await compile(device, label, link(fieldModules(ingredients), `field/${entry}`));
    const compute = { module, entryPoint: ENTRIES[entry] };
    return device.createComputePipelineAsync({ label, layout: pipelineLayout, compute });
  };
  return {
    pass,
    field,
    pipeline(entry) {
      const pipeline = begun.get(entry) ?? begin(entry);
      begun.set(entry, pipeline);
      // what failed once is tried again
      pipeline.catch(() => begun.delete(entry));
      return pipeline;
    },
  };
}

function layout(
  device: GPUDevice,
  label: string,
  types: readonly GPUBufferBindingType[],
): GPUBindGroupLayout {
  const entries = types.map((type, binding) => ({ binding, visibility: COMPUTE, buffer: { type } }));
  return device.createBindGroupLayout({ label, entries });
}
