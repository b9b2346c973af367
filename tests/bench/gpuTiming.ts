/** How fields are timed on the GPU: contenders in turn, the least of many rounds; points up and values back are counted in. */
import type { FieldNode, SkelsNode } from '../../src/field/node.ts';
import { type Bound, bindRecords, dispatch } from '../../src/gpu/dispatch.ts';
import { compile, link, type Modules } from '../../src/gpu/link.ts';
import { fieldModules } from '../../src/gpu/modules.ts';
import { fieldPipelines } from '../../src/gpu/pipelines.ts';
import { type Program, programOf } from '../../src/gpu/program.ts';
import type { Kernel } from '../../src/kernel/kernel.ts';
import type { Skel } from '../../src/skeleton/skels.ts';
import { type Grid, paramsOf } from './timing.ts';

export interface Contender {
  readonly bound: Bound;
  readonly pipeline: GPUComputePipeline;
}

/** A body of a kernel as all benchmarks take it. */
export const bodyOf = (kernel: Kernel, skels: readonly Skel[]): SkelsNode => ({
  type: 'skels',
  kernel: kernel.name,
  params: paramsOf(kernel),
  threshold: 1,
  skels: skels.map((skel) => ({ skel })),
});

/** Compilers leave out what only gradients need. */
const VALUES = `#import field/tree
@group(0) @binding(0) var<storage, read> points: array<vec4f>;
@group(0) @binding(1) var<storage, read_write> values: array<vec4f>;
@compute @workgroup_size(64)
fn values_at_points(@builtin(global_invocation_id) id: vec3u) {
  if (id.x < arrayLength(&points)) {
    values[id.x] = vec4f(tree_field(points[id.x].xyz).x);
  }
}
`;

export const withGradient = (device: GPUDevice, node: FieldNode): Promise<Contender> =>
  contender(device, node, ({ ingredients }) => fieldPipelines(device, ingredients).pipeline('points'));

export const valueOnly = (device: GPUDevice, node: FieldNode): Promise<Contender> =>
  contender(device, node, (program) => linked(device, program, { 'field/points': VALUES }));

/** A pipeline of other modules than the program's own. */
export async function linked(device: GPUDevice, program: Program, changed: Modules) {
  const modules = { ...fieldModules(program.ingredients), ...changed };
  const module = await compile(device, 'benchmark', link(modules, 'field/points'));
  const { pass, field } = fieldPipelines(device, program.ingredients);
  const layout = device.createPipelineLayout({ bindGroupLayouts: [pass, field] });
  return device.createComputePipelineAsync({ layout, compute: { module } });
}

export async function contender(
  device: GPUDevice,
  node: FieldNode,
  make: (program: Program) => Promise<GPUComputePipeline>,
): Promise<Contender> {
  const program = programOf(node);
  const bound = bindRecords(device, fieldPipelines(device, program.ingredients), program.records);
  return { bound, pipeline: await make(program) };
}

/** Least milliseconds of each. Gives the records back. */
export async function leastOnGpu<Name extends string>(
  device: GPUDevice,
  points: Float32Array,
  rounds: number,
  contenders: Readonly<Record<Name, Contender>>,
): Promise<Record<Name, number>> {
  const names = Object.keys(contenders) as Name[];
  const least = Object.fromEntries(names.map((name) => [name, Infinity])) as Record<Name, number>;
  // the first run compiles on some drivers
  for (let round = -1; round < rounds; round++) {
    for (const name of names) {
      const { bound, pipeline } = contenders[name];
      const start = performance.now();
      await dispatch(device, bound, pipeline, points);
      if (round >= 0) least[name] = Math.min(least[name], performance.now() - start);
    }
  }
  for (const name of names) contenders[name].bound.destroy();
  return least;
}

/** x, y, z, x, … */
export function pointsOf({ x, y, z, count }: Grid): Float32Array {
  const points = new Float32Array(3 * count);
  let at = 0;
  for (const px of x)
    for (const py of y)
      for (const pz of z) {
        points.set([px, py, pz], at);
        at += 3;
      }
  return points;
}
