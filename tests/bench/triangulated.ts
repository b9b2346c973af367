/**
 * Zhu et al.'s other two strategies, on the triangles of a polygon. CIT: our sum over edges, a triangle at a time. DIT: a double
 * integral over each triangle, which the papers do not give; ours goes along the longest side in the kernel's closed form, and
 * across it in closed form too (quartic, clippedQuartic.ts) or with Gauss points (Cauchy): for each triangle the fewest that are right
 * to a tenth of TOLERANCE.
 */
import earcut, { deviation, flatten } from 'earcut';
import type { Kernel } from '../../src/kernel/kernel.ts';
import type { Vec2 } from '../../src/math/vec.ts';
import type { SkelField } from '../../src/skeleton/skeleton.ts';
import type { PolygonSkel } from '../../src/skeleton/skels.ts';
import { based, type Triangle } from './basedTriangle.ts';
import { clippedQuartic } from './clippedQuartic.ts';
import { fewestSlices } from './slicedCauchy.ts';
import { bound, type Grid, paramsOf, type Timed } from './timing.ts';

/** of the whole plate's value, that DIT may miss in all */
export const TOLERANCE = 1e-6;

/** Throws for an outline that crosses itself: its triangles cover something else. */
export function trianglesOf({ loops }: PolygonSkel): readonly Triangle[] {
  const { vertices, holes, dimensions } = flatten(loops.map((loop) => loop.map(([x, y]) => [x, y])));
  const indices = earcut(vertices, holes, dimensions);
  if (deviation(vertices, holes, dimensions, indices) > 1e-12) throw new Error('the outline crosses itself');
  const corner = (i: number): Vec2 => [vertices[2 * indices[i]!]!, vertices[2 * indices[i]! + 1]!];
  return Array.from({ length: indices.length / 3 }, (_, i) => [
    corner(3 * i),
    corner(3 * i + 1),
    corner(3 * i + 2),
  ]);
}

/** CIT: the sum over edges of every triangle. */
export function edgesOfTriangles(skel: PolygonSkel, kernel: Kernel): readonly SkelField[] {
  return trianglesOf(skel).map((triangle) => bound({ ...skel, loops: [triangle] }, kernel));
}

/** DIT: a double integral over every triangle. The polygon lies in the plane z = 0. */
export function doubleIntegrals(skel: PolygonSkel, kernel: Kernel, grid: Grid): readonly Timed[] {
  const triangles = trianglesOf(skel);
  const per = 1 / kernel.unit(paramsOf(kernel), 1);
  if (kernel.name === 'quartic') return triangles.map((triangle) => clippedQuartic(based(triangle, per)));
  if (kernel.name !== 'cauchy') throw new Error(`no double integral of ${kernel.name}`);
  const edges = edgesOfTriangles(skel, kernel);
  const allowed = (0.1 * TOLERANCE * kernel.wholePlane!(0, 4)) / (per * per);
  return triangles.map((triangle, i) => fewestSlices(based(triangle, per), edges[i]!, grid, allowed));
}
