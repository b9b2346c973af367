/**
 * Fields on the CPU, bundled first (a test runner's import accessors cost more than a segment does): nanoseconds per segment
 * and per polygon edge, and Jin & Tai's scene of two crossed segments with cubic weights at 150³ points. Their own numbers
 * are not in the text at hand, so each kernel's cost is given relative to the Cauchy kernel's of the same run.
 */
import { kernels } from '../../src/kernel/index.ts';
import type { Kernel, KernelParams } from '../../src/kernel/kernel.ts';
import { bindSkel } from '../../src/skeleton/index.ts';
import type { SkelField } from '../../src/skeleton/skeleton.ts';
import type { Skel } from '../../src/skeleton/skels.ts';

const LINEAR: Skel = { type: 'segment', a: [-4, 0, 0], b: [4, 0, 0], weights: [1, 0.1] };
const CROSS: readonly Skel[] = [
  { type: 'segment', a: [-4, 0, 0], b: [4, 0, 0], weights: [0.4, 0.3, -0.02, 0.001] },
  { type: 'segment', a: [0, -4, 0], b: [0, 4, 0], weights: [0.4, 0.3, -0.02, 0.001] },
];
const EDGES = 69;
const STAR: Skel = {
  type: 'polygon',
  origin: [0, 0, 0],
  u: [1, 0, 0],
  v: [0, 1, 0],
  loops: [
    Array.from({ length: EDGES }, (_, i) => {
      const angle = (2 * Math.PI * i) / EDGES;
      const radius = 3 + Math.sin(5 * angle);
      return [radius * Math.cos(angle), radius * Math.sin(angle)] as const;
    }),
  ],
  weight: 1,
};
/** mm: the widths are alike */
const PARAMS: KernelParams = { s: 1.5, R: 1.2, n: 3.5 };
const SIDE = 40;
const SCENE_SIDE = 150;

const paramsOf = ({ params }: Kernel): KernelParams =>
  Object.fromEntries(params.map(({ name }) => [name, PARAMS[name]]));

/** ns a point, the least of `runs`, over a grid of the cube of ±5 */
function nanoseconds(side: number, evaluate: (x: number, y: number, z: number) => void, runs = 3): number {
  let least = Infinity;
  for (let run = 0; run < runs; run++) {
    const start = performance.now();
    for (let i = 0; i < side; i++)
      for (let j = 0; j < side; j++)
        for (let k = 0; k < side; k++)
          evaluate(-5 + (10 * (i + 0.5)) / side, -5 + (10 * (j + 0.5)) / side, -5 + (10 * (k + 0.5)) / side);
    least = Math.min(least, performance.now() - start);
  }
  return (1e6 * least) / side ** 3;
}

const out = new Float64Array(4);
let sum = 0;
const values = (fields: readonly SkelField[]) => (x: number, y: number, z: number) => {
  for (const field of fields) sum += field.value(x, y, z);
};
const gradients = (fields: readonly SkelField[]) => (x: number, y: number, z: number) => {
  for (const field of fields) field.add(x, y, z, 1, out);
};

const rows = kernels.map((kernel) => {
  const bound = (skel: Skel) => bindSkel(skel, kernel, paramsOf(kernel));
  const [line, star, cross] = [[bound(LINEAR)], [bound(STAR)], CROSS.map(bound)];
  return {
    kernel: kernel.name,
    'segment, value': nanoseconds(SIDE, values(line)),
    'segment, value + gradient': nanoseconds(SIDE, gradients(line)),
    'edge, value': nanoseconds(SIDE / 4, values(star)) / EDGES,
    'edge, value + gradient': nanoseconds(SIDE / 4, gradients(star)) / EDGES,
    'cross 150³, ms': (nanoseconds(SCENE_SIDE, values(cross), 1) * SCENE_SIDE ** 3) / 1e6,
  };
});
const cauchy = rows[0]!['cross 150³, ms'];
console.table(
  rows.map((row) => ({
    ...Object.fromEntries(
      Object.entries(row).map(([key, value]) => [key, typeof value === 'number' ? Math.round(value) : value]),
    ),
    'cross / cauchy': Number((row['cross 150³, ms'] / cauchy).toFixed(2)),
  })),
);
// What nobody reads is not computed.
if (!Number.isFinite(sum + out[0]!)) console.log('a field is no finite number');
