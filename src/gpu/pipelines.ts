/**
 * Compute pipelines, made once a device for each entry × kernels × primitives: parameters, weights and places are data,
 * so that nothing compiles when they change.
 */
import { compile, link } from './link.ts';
import { fieldModules, type Ingredients } from './modules.ts';
import type { Primitive } from './structs.ts';

/** Files in shaders/field and the function that each begins with. */
const ENTRIES = { points: 'sum_at_points', pairs: 'each_at_its_point' } as const;
export type Entry = keyof typeof ENTRIES;

/** In group 1: the list of skels, and the records of each primitive that takes part. */
export const BINDINGS: Readonly<Record<Primitive, readonly number[]>> = {
  point: [1],
  segment: [2],
  polygon: [3, 4],
};

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

/** The pipelines for these kernels and primitives; none is compiled before it is asked for. */
export function fieldPipelines(device: GPUDevice, ingredients: Ingredients): FieldPipelines {
  const known = made.get(device) ?? new Map<string, FieldPipelines>();
  made.set(device, known);
  const key = [...ingredients.kernels, ...ingredients.primitives].join(' ');
  const pipelines = known.get(key) ?? prepare(device, ingredients, key);
  known.set(key, pipelines);
  return pipelines;
}

function prepare(device: GPUDevice, ingredients: Ingredients, key: string): FieldPipelines {
  const bindings = [0, ...ingredients.primitives.flatMap((primitive) => BINDINGS[primitive])];
  const field = layout(device, `records of ${key}`, bindings, []);
  const pass = layout(device, 'points and values', [0], [1]);
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
      return pipeline;
    },
  };
}

function layout(
  device: GPUDevice,
  label: string,
  read: readonly number[],
  written: readonly number[],
): GPUBindGroupLayout {
  const entry = (type: GPUBufferBindingType) => (binding: number) => ({
    binding,
    visibility: COMPUTE,
    buffer: { type },
  });
  return device.createBindGroupLayout({
    label,
    entries: [...read.map(entry('read-only-storage')), ...written.map(entry('storage'))],
  });
}
