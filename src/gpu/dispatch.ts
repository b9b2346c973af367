/** A field evaluated at a list of points: bytes up, one thread a point, bytes back; large lists in several dispatches. */
import type { FieldPipelines } from './pipelines.ts';
import { USAGE } from './usage.ts';

const MAP_READ = 0x1;

/** points of one dispatch: 16 MiB a buffer, and 16 384 of the 65 535 workgroups that every device has */
export const BATCH = 1 << 20;
const WORKGROUP = 64;
/** bytes that every device binds */
const MOST = 1 << 27;

/** The records of a field where the device reads them. */
export interface Bound {
  readonly pipelines: FieldPipelines;
  readonly group: GPUBindGroup;
  destroy(): void;
}

/** Throws a RangeError for more records than every device binds. What the device itself refuses, `dispatch` tells. */
export function bindRecords(device: GPUDevice, pipelines: FieldPipelines, records: ArrayBuffer): Bound {
  const buffer = upload(device, 'records', records);
  const entries = [{ binding: 0, resource: { buffer } }];
  const group = device.createBindGroup({ label: 'records', layout: pipelines.field, entries });
  return { pipelines, group, destroy: () => buffer.destroy() };
}

/** Four numbers a point (x, y, z, x, …); any number of points, none included. Rejects when the device refuses the work. */
export async function dispatch(
  device: GPUDevice,
  bound: Bound,
  pipeline: GPUComputePipeline,
  points: Float32Array,
): Promise<Float32Array> {
  const count = points.length / 3;
  const values = new Float32Array(4 * count);
  for (let start = 0; start < count; start += BATCH) {
    const batch = points.subarray(3 * start, 3 * Math.min(count, start + BATCH));
    values.set(await dispatchBatch(device, bound, pipeline, batch), 4 * start);
  }
  return values;
}

/** What is invalid or does not fit reads back as zeros, which no one could tell from a field: it rejects instead. */
async function dispatchBatch(
  device: GPUDevice,
  bound: Bound,
  pipeline: GPUComputePipeline,
  points: Float32Array,
): Promise<Float32Array> {
  device.pushErrorScope('out-of-memory');
  device.pushErrorScope('validation');
  const buffers = submit(device, bound, pipeline, points);
  const refusals = Promise.all([device.popErrorScope(), device.popErrorScope()]);
  const { readable } = buffers;
  try {
    // its failure is told by the scopes too, in better words
    const mapped = readable.mapAsync(MAP_READ).catch((error: unknown) => error);
    const refusal = (await refusals).find((error) => error !== null);
    if (refusal) throw new Error(`the graphics device refused a field: ${refusal.message}`);
    const failure = await mapped;
    if (failure) throw failure;
    return new Float32Array(readable.getMappedRange().slice(0));
  } finally {
    for (const buffer of Object.values(buffers)) buffer.destroy();
  }
}

function submit(device: GPUDevice, bound: Bound, pipeline: GPUComputePipeline, at: Float32Array) {
  const count = at.length / 3;
  const size = 16 * count;
  const points = upload(device, 'points', fourWide(at));
  const values = device.createBuffer({ label: 'values', size, usage: USAGE.storage | USAGE.copySource });
  const readable = device.createBuffer({
    label: 'values, read back',
    size,
    usage: USAGE.mapRead | USAGE.copyTarget,
  });
  const entries = [points, values].map((buffer, binding) => ({ binding, resource: { buffer } }));
  const { pass: layout } = bound.pipelines;
  const encoder = device.createCommandEncoder({ label: pipeline.label });
  const pass = encoder.beginComputePass({ label: pipeline.label });
  pass.setPipeline(pipeline);
  pass.setBindGroup(0, device.createBindGroup({ label: 'points and values', layout, entries }));
  pass.setBindGroup(1, bound.group);
  pass.dispatchWorkgroups(Math.ceil(count / WORKGROUP));
  pass.end();
  encoder.copyBufferToBuffer(values, 0, readable, 0, size);
  device.queue.submit([encoder.finish()]);
  return { points, values, readable };
}

function upload(device: GPUDevice, label: string, data: ArrayBuffer): GPUBuffer {
  const size = data.byteLength;
  if (size > MOST) throw new RangeError(`${label}: ${size} bytes are more than every device binds (${MOST})`);
  const buffer = device.createBuffer({ label, size, usage: USAGE.storage | USAGE.copyTarget });
  device.queue.writeBuffer(buffer, 0, data);
  return buffer;
}

/** x, y, z, and a fourth that nobody reads: WGSL's vec3f would be as wide. */
function fourWide(points: Float32Array): ArrayBuffer {
  const wide = new Float32Array((points.length / 3) * 4);
  for (let i = 0, k = 0; i < points.length; i += 3, k += 4) {
    wide[k] = points[i]!;
    wide[k + 1] = points[i + 1]!;
    wide[k + 2] = points[i + 2]!;
  }
  return wide.buffer;
}
