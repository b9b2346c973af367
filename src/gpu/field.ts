/**
 * Fields on the GPU: records bound once, evaluated at lists of points. The twin of the sums in src/skeleton, in float32.
 */
import { kernels } from '../kernel/index.ts';
import type { Ingredients } from './modules.ts';
import { BINDINGS, type Entry, type FieldPipelines, fieldPipelines } from './pipelines.ts';
import { type KernelSkel, type Records, recordsOf } from './records.ts';
import { EDGE, POINT, POLYGON, PRIMITIVES, SEGMENT } from './structs.ts';

/** The numbers of the standard, whose names are globals of browsers only. */
const USAGE = { mapRead: 0x1, copySource: 0x4, copyTarget: 0x8, storage: 0x80 } as const;
const MAP_READ = 0x1;

/** points of one dispatch: 16 MiB a buffer, and 16 384 of the 65 535 workgroups that every device has */
const BATCH = 1 << 20;
const WORKGROUP = 64;
/** bytes that every device binds */
const MOST = 1 << 27;

export interface GpuField {
  /** Takes other skels, parameters or places; compiles only when kernels or primitives take part that did not before. */
  update(skels: readonly KernelSkel[]): void;
  /** The sum of all skels at points (x, y, z, x, …), mm: value and gradient of each, four numbers a point. */
  evaluate(points: Float32Array): Promise<Float32Array>;
  /** The first skel at the first point, the second at the second, …: as many points as skels, a million at most. */
  evaluatePairs(points: Float32Array): Promise<Float32Array>;
  /** Gives the buffers back. */
  destroy(): void;
}

/** A field of skels on a device. Throws a RangeError for more records than every device binds. */
export function gpuField(device: GPUDevice, skels: readonly KernelSkel[]): GpuField {
  let bound = bind(device, skels);
  let busy: Promise<unknown> = Promise.resolve();
  const evaluate = (entry: Entry, points: Float32Array) => {
    const values = run(device, bound, entry, points);
    busy = Promise.allSettled([busy, values]);
    return values;
  };
  // What is under way still reads the buffers.
  const discard = (old: Bound) => void busy.then(() => old.destroy());
  return {
    update(next) {
      const old = bound;
      bound = bind(device, next);
      discard(old);
    },
    evaluate: (points) => evaluate('points', points),
    evaluatePairs(points) {
      if (points.length !== 3 * bound.count || bound.count > BATCH) {
        throw new RangeError(`${points.length / 3} points for ${bound.count} skels`);
      }
      return evaluate('pairs', points);
    },
    destroy: () => discard(bound),
  };
}

interface Bound {
  /** skels */
  readonly count: number;
  readonly pipelines: FieldPipelines;
  readonly group: GPUBindGroup;
  destroy(): void;
}

function bind(device: GPUDevice, skels: readonly KernelSkel[]): Bound {
  const ingredients = ingredientsOf(skels);
  const pipelines = fieldPipelines(device, ingredients);
  const records = recordsOf(skels);
  // WebGPU binds no empty buffer.
  const skelList = Uint32Array.from(skels.length > 0 ? records.skels : [0]);
  const buffers = new Map<number, GPUBuffer>([[0, upload(device, 'skels', skelList)]]);
  for (const primitive of ingredients.primitives) {
    packed(records, primitive).forEach((bytes, i) => {
      const label = i === 0 ? `${primitive}s` : 'edges';
      buffers.set(BINDINGS[primitive][i]!, upload(device, label, bytes));
    });
  }
  const entries = Array.from(buffers, ([binding, buffer]) => ({ binding, resource: { buffer } }));
  const group = device.createBindGroup({ label: 'records', layout: pipelines.field, entries });
  return {
    count: skels.length,
    pipelines,
    group,
    destroy() {
      for (const buffer of buffers.values()) buffer.destroy();
    },
  };
}

/** Each once, in the order of the registries: the same field asks for the same pipeline. */
function ingredientsOf(skels: readonly KernelSkel[]): Ingredients {
  const named = new Set(skels.map(({ kernel }) => kernel.name));
  const primitives = new Set(skels.map(({ skel }) => skel.type));
  return {
    kernels: kernels.map(({ name }) => name).filter((name) => named.has(name)),
    primitives: PRIMITIVES.filter((name) => primitives.has(name)),
  };
}

function packed(records: Records, primitive: Ingredients['primitives'][number]): ArrayBuffer[] {
  if (primitive === 'point') return [POINT.pack(records.points)];
  if (primitive === 'segment') return [SEGMENT.pack(records.segments)];
  return [POLYGON.pack(records.polygons), EDGE.pack(records.edges)];
}

function upload(device: GPUDevice, label: string, data: ArrayBuffer | Uint32Array<ArrayBuffer>): GPUBuffer {
  const size = data.byteLength;
  if (size > MOST) throw new RangeError(`${label}: ${size} bytes are more than every device binds (${MOST})`);
  const buffer = device.createBuffer({ label, size, usage: USAGE.storage | USAGE.copyTarget });
  device.queue.writeBuffer(buffer, 0, data);
  return buffer;
}

async function run(
  device: GPUDevice,
  bound: Bound,
  entry: Entry,
  points: Float32Array,
): Promise<Float32Array> {
  const count = points.length / 3;
  const values = new Float32Array(4 * count);
  if (bound.count === 0 || count === 0) return values;
  const pipeline = await bound.pipelines.pipeline(entry);
  for (let start = 0; start < count; start += BATCH) {
    const batch = points.subarray(3 * start, 3 * Math.min(count, start + BATCH));
    values.set(await runBatch(device, bound, pipeline, batch), 4 * start);
  }
  return values;
}

/** One dispatch and the copy back. */
async function runBatch(
  device: GPUDevice,
  bound: Bound,
  pipeline: GPUComputePipeline,
  points: Float32Array,
): Promise<Float32Array> {
  const count = points.length / 3;
  const places = upload(device, 'points', fourWide(points));
  const size = 16 * count;
  const values = device.createBuffer({ label: 'values', size, usage: USAGE.storage | USAGE.copySource });
  const readable = device.createBuffer({
    label: 'values, read back',
    size,
    usage: USAGE.mapRead | USAGE.copyTarget,
  });
  const encoder = device.createCommandEncoder({ label: pipeline.label });
  const pass = encoder.beginComputePass({ label: pipeline.label });
  const entries = [places, values].map((buffer, binding) => ({ binding, resource: { buffer } }));
  pass.setPipeline(pipeline);
  pass.setBindGroup(
    0,
    device.createBindGroup({ label: 'points and values', layout: bound.pipelines.pass, entries }),
  );
  pass.setBindGroup(1, bound.group);
  pass.dispatchWorkgroups(Math.ceil(count / WORKGROUP));
  pass.end();
  encoder.copyBufferToBuffer(values, 0, readable, 0, size);
  device.queue.submit([encoder.finish()]);
  await readable.mapAsync(MAP_READ);
  const result = new Float32Array(readable.getMappedRange().slice(0));
  for (const buffer of [places, values, readable]) buffer.destroy();
  return result;
}

/** x, y, z, and a fourth that nobody reads: WGSL's vec3f would be as wide. */
function fourWide(points: Float32Array): ArrayBuffer {
  const wide = new Float32Array((points.length / 3) * 4);
  for (let i = 0, k = 0; i < points.length; i += 3, k += 4) wide.set(points.subarray(i, i + 3), k);
  return wide.buffer;
}
