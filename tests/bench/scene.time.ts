/**
 * Jin & Tai's scene of two crossed segments with cubic weights at 150³ points. Their own times are not in the text at hand, so
 * each kernel's is given relative to the Cauchy kernel's of the same run.
 */
import { kernels } from '../../src/kernel/index.ts';
import { CROSS } from './skels.ts';
import { bound, cube, leastOf, mixCalls, rounded, sumValues } from './timing.ts';

const GRID = cube(5, 150);

mixCalls(CROSS);
const seconds = kernels.map((kernel) => {
  const fields = CROSS.map((skel) => bound(skel, kernel));
  return leastOf(1, { all: () => sumValues(fields, GRID) }).all / 1000;
});
const cauchy = seconds[kernels.findIndex(({ name }) => name === 'cauchy')]!;
console.log('Two crossed segments, cubic weights, 150³ points');
console.table(
  kernels.map(({ name }, i) => ({
    kernel: name,
    seconds: rounded(seconds[i]!, 1),
    'relative to cauchy': rounded(seconds[i]! / cauchy, 2),
  })),
);
