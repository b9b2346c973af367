/**
 * A tree on the GPU, flat program against straight-line code generated for its structure: time to the first result (which is
 * mostly compiling, and comes again for the one with every new structure, for the other with every new ingredient) and
 * nanoseconds a point once both are there.
 */
import type { FieldNode, SkelsNode } from '../../src/field/node.ts';
import { type Bound, bindRecords, dispatch } from '../../src/gpu/dispatch.ts';
import { compile, link } from '../../src/gpu/link.ts';
import { fieldModules } from '../../src/gpu/modules.ts';
import { fieldPipelines } from '../../src/gpu/pipelines.ts';
import { type Program, programOf } from '../../src/gpu/program.ts';
import { random } from '../fixtures/random.ts';
import { straightTree } from './straightTree.ts';

const POINTS = 32 ** 3;

const uniform = random(7);
const near = (): [number, number, number] => [6 * uniform() - 3, 6 * uniform() - 3, 6 * uniform() - 3];

const body = (skels: number): SkelsNode => ({
  type: 'skels',
  kernel: 'cauchy',
  params: { s: 2 },
  threshold: 1,
  skels: Array.from({ length: skels }, () => ({
    skel: { type: 'segment', a: near(), b: near(), weights: [1, 0.1] },
  })),
});

const joined = (form: 'hard' | 'smooth', parts: readonly FieldNode[]): FieldNode => ({
  type: 'union',
  form,
  parts,
});
const carved = (part: FieldNode, i: number): FieldNode => ({
  type: 'subtraction',
  form: i % 2 ? 'hard' : 'smooth',
  parts: [part, { type: 'shape', shape: { type: 'sphere', radius: 1 } }],
});

const SCENES: readonly (readonly [name: string, node: FieldNode])[] = [
  ['one body of 64 segments', body(64)],
  [
    '8 bodies of 8',
    joined(
      'smooth',
      Array.from({ length: 8 }, () => body(8)),
    ),
  ],
  [
    '8 carved bodies of 8',
    joined(
      'smooth',
      Array.from({ length: 8 }, (_, i) => carved(body(8), i)),
    ),
  ],
  [
    '32 carved bodies of 2',
    joined(
      'hard',
      Array.from({ length: 32 }, (_, i) => carved(body(2), i)),
    ),
  ],
];

type MakePipeline = (device: GPUDevice, program: Program) => Promise<GPUComputePipeline>;

const flat: MakePipeline = (device, { ingredients }) =>
  fieldPipelines(device, ingredients).pipeline('points');

const straight: MakePipeline = async (device, program) => {
  const modules = { ...fieldModules(program.ingredients), 'field/tree': straightTree(program) };
  const module = await compile(device, 'straight', link(modules, 'field/points'));
  const { pass, field } = fieldPipelines(device, program.ingredients);
  const layout = device.createPipelineLayout({ bindGroupLayouts: [pass, field] });
  return device.createComputePipelineAsync({ layout, compute: { module } });
};

export async function timeTrees(device: GPUDevice): Promise<void> {
  const points = Float32Array.from({ length: 3 * POINTS }, () => 6 * uniform() - 3);
  const rows = [];
  for (const [scene, node] of SCENES) {
    const program = programOf(node);
    const bound = bindRecords(device, fieldPipelines(device, program.ingredients), program.records);
    const one = await begin(device, bound, program, flat);
    const other = await begin(device, bound, program, straight);
    const [a = 0, b = 0] = await raced(device, bound, points, [one.pipeline, other.pipeline]);
    bound.destroy();
    rows.push({
      scene,
      'flat, first result, ms': Math.round(one.first),
      'straight, first result, ms': Math.round(other.first),
      'flat, ns a point': Math.round(a),
      'straight, ns a point': Math.round(b),
      'flat / straight': Number((a / b).toFixed(2)),
    });
  }
  console.table(rows);
}

async function begin(device: GPUDevice, bound: Bound, program: Program, make: MakePipeline) {
  const start = performance.now();
  const pipeline = await make(device, program);
  await dispatch(device, bound, pipeline, new Float32Array(3));
  return { pipeline, first: performance.now() - start };
}

/** ns a point of each, the least of five turns: a busy machine is busy for both. */
async function raced(
  device: GPUDevice,
  bound: Bound,
  points: Float32Array,
  pipelines: readonly GPUComputePipeline[],
): Promise<number[]> {
  const least = pipelines.map(() => Infinity);
  for (let turn = 0; turn < 5; turn++) {
    for (const [i, pipeline] of pipelines.entries()) {
      const start = performance.now();
      await dispatch(device, bound, pipeline, points);
      least[i] = Math.min(least[i]!, (1e6 * (performance.now() - start)) / POINTS);
    }
  }
  return least;
}
