/** How fields are timed: contenders in turn, the least of many rounds, so that a busy machine decides nothing. */
import { kernels } from '../../src/kernel/index.ts';
import type { Kernel, KernelParams } from '../../src/kernel/kernel.ts';
import type { Vec3 } from '../../src/math/vec.ts';
import { bindSkel } from '../../src/skeleton/index.ts';
import type { Box, SkelField } from '../../src/skeleton/skeleton.ts';
import type { Skel } from '../../src/skeleton/skels.ts';

/** What is timed of a field. */
export type Timed = Pick<SkelField, 'value'>;
export type TimedGradient = Pick<SkelField, 'value' | 'add'>;

/** mm: the widths are alike */
const PARAMS: KernelParams = { s: 1.5, R: 1.2, n: 3.5 };

export const paramsOf = ({ params }: Kernel): KernelParams =>
  Object.fromEntries(params.map(({ name }) => [name, PARAMS[name]]));

export const bound = (skel: Skel, kernel: Kernel): SkelField => bindSkel(skel, kernel, paramsOf(kernel));

/** The middles of a grid's cells. */
export interface Grid {
  readonly x: Float64Array;
  readonly y: Float64Array;
  readonly z: Float64Array;
  readonly count: number;
}

export function gridOf({ min, max }: Box, [nx, ny, nz]: Vec3): Grid {
  const axis = (i: 0 | 1 | 2, n: number) =>
    Float64Array.from({ length: n }, (_, k) => min[i] + ((max[i] - min[i]) * (k + 0.5)) / n);
  return { x: axis(0, nx), y: axis(1, ny), z: axis(2, nz), count: nx * ny * nz };
}

export const cube = (half: number, side: number): Grid =>
  gridOf({ min: [-half, -half, -half], max: [half, half, half] }, [side, side, side]);

/** Sum of the values over the grid: the loop of a sum of skels. */
export function sumValues(fields: readonly Timed[], { x, y, z }: Grid): number {
  let sum = 0;
  for (const px of x)
    for (const py of y) for (const pz of z) for (const field of fields) sum += field.value(px, py, pz);
  return sum;
}

const gradient = new Float64Array(4);

export function sumGradients(fields: readonly TimedGradient[], { x, y, z }: Grid): number {
  for (const px of x)
    for (const py of y) for (const pz of z) for (const field of fields) field.add(px, py, pz, 1, gradient);
  return gradient[0]!;
}

let unread = 0;

/** Least milliseconds of each, of as many rounds, all in turn. */
export function leastOf<Name extends string>(
  rounds: number,
  contenders: Readonly<Record<Name, () => number>>,
): Record<Name, number> {
  const names = Object.keys(contenders) as Name[];
  const least = Object.fromEntries(names.map((name) => [name, Infinity])) as Record<Name, number>;
  for (let round = 0; round < rounds; round++) {
    for (const name of names) {
      const start = performance.now();
      // what nobody reads is not computed
      unread += contenders[name]();
      least[name] = Math.min(least[name], performance.now() - start);
    }
  }
  if (Number.isNaN(unread)) console.log('a field is no number');
  return least;
}

/** ms of the processor, the least of some rounds. */
export function processorTime(task: () => unknown, rounds = 5): number {
  const times = Array.from({ length: rounds }, () => {
    const before = process.cpuUsage();
    task();
    const { user, system } = process.cpuUsage(before);
    return (user + system) / 1000;
  });
  return rounded(Math.min(...times), 1);
}

/** Every kernel once, so that no call has but one target, as in the application. */
export function mixCalls(skels: readonly Skel[]): void {
  const grid = cube(5, 8);
  for (let i = 0; i < 4; i++) {
    for (const kernel of kernels) {
      const fields = skels.map((skel) => bound(skel, kernel));
      unread += sumValues(fields, grid) + sumGradients(fields, grid);
    }
  }
}

export const rounded = (x: number, digits = 0): number => Number(x.toFixed(digits));
