/**
 * Polygons: nanoseconds an edge for every kernel, and Zhu et al. 2011, table 2, on outlines of ours: CI, the sum over the
 * polygon's edges; CIT, that over the edges of its triangles; DIT, double integrals over those (triangulated.ts). Triangulation is not
 * timed, as in the paper. Points: the middles of 24 × 24 × 12 cells of the polygon's box and 1.2 mm more on all sides.
 */
import { kernelNamed, kernels } from '../../src/kernel/index.ts';
import type { Kernel } from '../../src/kernel/kernel.ts';
import { POLYGONS } from '../fixtures/polygons.ts';
import {
  bound,
  type Grid,
  leastOf,
  mixCalls,
  paramsOf,
  rounded,
  sumGradients,
  sumValues,
  type Timed,
} from './timing.ts';
import { doubleIntegrals, edgesOfTriangles, TOLERANCE } from './triangulated.ts';
import { around, PAPER, rowOf } from './zhu.ts';

mixCalls(Object.values(POLYGONS));

const rows = Object.entries(PAPER).map(([title, seconds]) => {
  const [kernelName, name] = title.split(' ') as [string, keyof typeof POLYGONS];
  const kernel = kernelNamed(kernelName)!;
  const skel = POLYGONS[name];
  const grid = around(skel);
  const own = [bound(skel, kernel)];
  const edges = edgesOfTriangles(skel, kernel);
  const slices = doubleIntegrals(skel, kernel, grid);
  const miss = apart(slices, own, kernel, grid);
  if (!(miss <= TOLERANCE)) throw new Error(`the double integrals miss ${miss} of the plate`);
  const least = leastOf(9, {
    dit: () => sumValues(slices, grid),
    cit: () => sumValues(edges, grid),
    ci: () => sumValues(own, grid),
  });
  return rowOf(title, skel, grid, least, seconds, miss);
});
console.log('Zhu et al. 2011, table 2');
console.table(rows);

console.log('A polygon of 69 edges, ns an edge');
console.table(
  kernels.map((kernel) => {
    const fields = [bound(POLYGONS.star, kernel)];
    const grid = around(POLYGONS.star);
    const perEdge = 1e6 / (grid.count * POLYGONS.star.loops[0]!.length);
    const { value, add } = leastOf(3, {
      value: () => sumValues(fields, grid),
      add: () => sumGradients(fields, grid),
    });
    return {
      kernel: kernel.name,
      value: rounded(value * perEdge),
      'value + gradient': rounded(add * perEdge),
    };
  }),
);

/** The largest difference, of the whole plate's value. */
function apart(some: readonly Timed[], others: readonly Timed[], kernel: Kernel, { x, y, z }: Grid): number {
  const sum = (fields: readonly Timed[], at: readonly [number, number, number]) =>
    fields.reduce((total, field) => total + field.value(...at), 0);
  let most = 0;
  for (const px of x)
    for (const py of y)
      for (const pz of z) {
        most = Math.max(most, Math.abs(sum(some, [px, py, pz]) - sum(others, [px, py, pz])));
      }
  const unit = kernel.unit(paramsOf(kernel), 1);
  return most / (kernel.wholePlane!(0, 4) * unit * unit);
}
