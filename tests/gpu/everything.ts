/** One pipeline for all fields: suites over many trees compile once. */
import type { FieldNode } from '../../src/field/node.ts';
import { bindRecords, dispatch } from '../../src/gpu/dispatch.ts';
import { type Ingredients, REGISTRY } from '../../src/gpu/ingredients.ts';
import { type Entry, fieldPipelines } from '../../src/gpu/pipelines.ts';
import { programOf } from '../../src/gpu/program.ts';

export const EVERYTHING = Object.fromEntries(
  Object.entries(REGISTRY).map(([kind, names]) => [kind, new Set(names)]),
) as unknown as Ingredients;

/** As gpuField does, four numbers a point. */
export async function evaluated(
  device: GPUDevice,
  node: FieldNode,
  entry: Entry,
  points: Float32Array,
): Promise<Float32Array> {
  const pipelines = fieldPipelines(device, EVERYTHING);
  const bound = bindRecords(device, pipelines, programOf(node).records);
  const pipeline = await pipelines.pipeline(entry);
  return dispatch(device, bound, pipeline, points).finally(() => bound.destroy());
}
