/** A group of buffers as a stage binds them, by their names. */
import type { Slice } from '../polygonize/buffers.ts';

export const bindGroup = (
  device: GPUDevice,
  pipeline: GPUComputePipeline,
  index: number,
  bindings: Readonly<Record<string, number>>,
  bound: Readonly<Record<string, Slice>>,
): GPUBindGroup =>
  device.createBindGroup({
    label: pipeline.label,
    layout: pipeline.getBindGroupLayout(index),
    entries: Object.entries(bindings).map(([name, binding]) => ({ binding, resource: bound[name]! })),
  });
