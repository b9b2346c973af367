/**
 * Segments, nanoseconds a point: every kernel, and the Cauchy kernel against the papers' form of it (target: 0.8 of its time for
 * the value, and value + gradient in 1.5 of our value's).
 */
import { kernels } from '../../src/kernel/index.ts';
import type { SegmentSkel } from '../../src/skeleton/skels.ts';
import { plainCauchy } from './plainCauchy.ts';
import { bound, cube, leastOf, mixCalls, paramsOf, rounded, sumGradients, sumValues } from './timing.ts';

const ENDS = [
  [-4, 0, 0, 4, 0, 0],
  [0, -4, 0, 0, 4, 0],
  [-2, -3, 1, 3, 2, -1],
  [1, 2, -4, -1, 0, 4],
] as const;
const SEGMENTS = ENDS.map(
  ([ax, ay, az, bx, by, bz]): SegmentSkel => ({
    type: 'segment',
    a: [ax, ay, az],
    b: [bx, by, bz],
    weights: [1, 0.1],
  }),
);
const GRID = cube(5, 30);
const NS = 1e6 / (GRID.count * SEGMENTS.length);

mixCalls(SEGMENTS);

const cauchy = kernels.find(({ name }) => name === 'cauchy')!;
const ours = SEGMENTS.map((skel) => bound(skel, cauchy));
const plain = SEGMENTS.map((skel) => plainCauchy(skel, paramsOf(cauchy).s!));
const least = leastOf(60, {
  ours: () => sumValues(ours, GRID),
  plain: () => sumValues(plain, GRID),
  oursGradient: () => sumGradients(ours, GRID),
  plainGradient: () => sumGradients(plain, GRID),
});
console.log('Cauchy segments with linear weights against d² − h² and two Math.atan, ns');
console.table({
  value: row(least.ours, least.plain),
  'value + gradient': row(least.oursGradient, least.plainGradient),
});
console.log(`value + gradient / value: ${rounded(least.oursGradient / least.ours, 2)} (target 1.5)`);

console.log('Segments with linear weights, ns');
console.table(
  kernels.map((kernel) => {
    const fields = SEGMENTS.map((skel) => bound(skel, kernel));
    const { value, add } = leastOf(4, {
      value: () => sumValues(fields, GRID),
      add: () => sumGradients(fields, GRID),
    });
    return { kernel: kernel.name, value: rounded(value * NS), 'value + gradient': rounded(add * NS) };
  }),
);

function row(own: number, other: number) {
  return { ours: rounded(own * NS), plain: rounded(other * NS), ratio: rounded(own / other, 2) };
}
