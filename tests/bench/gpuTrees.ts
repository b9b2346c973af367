/**
 * A tree on the GPU, flat program against straight-line code generated for its structure: time to the first result (which is
 * mostly compiling, and comes again for the one with every new structure, for the other with every new ingredient) and
 * nanoseconds a point once both are there.
 */
import type { FieldNode, SkelsNode } from '../../src/field/node.ts';
import { dispatch } from '../../src/gpu/dispatch.ts';
import { random } from '../fixtures/random.ts';
import { type Contender, contender, leastOnGpu, linked, withGradient } from './gpuTiming.ts';
import { straightTree } from './straightTree.ts';
import { rounded } from './timing.ts';

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
];

export async function timeTrees(device: GPUDevice): Promise<void> {
  const points = Float32Array.from({ length: 3 * POINTS }, () => 6 * uniform() - 3);
  const rows = [];
  for (const [scene, node] of SCENES) {
    const flat = await begun(device, () => withGradient(device, node));
    const straight = await begun(device, () =>
      contender(device, node, (program) => linked(device, program, { 'field/tree': straightTree(program) })),
    );
    const least = await leastOnGpu(device, points, 5, { flat: flat.contender, straight: straight.contender });
    rows.push({
      scene,
      'flat, first result, ms': rounded(flat.ms),
      'straight, first result, ms': rounded(straight.ms),
      'flat, ns a point': rounded((1e6 * least.flat) / POINTS),
      'straight, ns a point': rounded((1e6 * least.straight) / POINTS),
      'flat / straight': rounded(least.flat / least.straight, 2),
    });
  }
  console.log('Trees: a flat program against straight-line code');
  console.table(rows);
}

/** Until the first result is there: some drivers compile when a pipeline is made, some when it is used. */
async function begun(device: GPUDevice, make: () => Promise<Contender>) {
  const start = performance.now();
  const contender = await make();
  await dispatch(device, contender.bound, contender.pipeline, new Float32Array(3));
  return { contender, ms: performance.now() - start };
}
