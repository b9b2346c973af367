/**
 * Zhu et al. 2011, table 2, on the GPU. CI: the polygon's edges; CIT: the edges of its triangles; DIT: a double integral over
 * each triangle, whose inner one is a segment in closed form (exact for both kernels) and whose outer one takes Gauss points, the
 * fewest that are right to float32.
 */
import { kernelNamed } from '../../src/kernel/index.ts';
import { POLYGONS } from '../fixtures/polygons.ts';
import { bodyOf, leastOnGpu, pointsOf, valueOnly } from './gpuTiming.ts';
import { slicesOf } from './slices.ts';
import { trianglesOf } from './triangulated.ts';
import { around, PAPER_GPU, rowOf } from './zhu.ts';

export async function timePolygons(device: GPUDevice): Promise<void> {
  const rows = [];
  for (const [title, seconds] of Object.entries(PAPER_GPU)) {
    const [kernelName, name] = title.split(' ') as [string, keyof typeof POLYGONS];
    const kernel = kernelNamed(kernelName)!;
    const skel = POLYGONS[name];
    const grid = around(skel);
    const triangles = trianglesOf(skel);
    const slices = slicesOf(skel, kernel, grid);
    const least = await leastOnGpu(device, pointsOf(grid), 5, {
      ci: await valueOnly(device, bodyOf(kernel, [skel])),
      cit: await valueOnly(
        device,
        bodyOf(
          kernel,
          triangles.map((loop) => ({ ...skel, loops: [loop] })),
        ),
      ),
      dit: await valueOnly(device, bodyOf(kernel, slices.segments)),
    });
    rows.push({
      ...rowOf(title, skel, grid, least, seconds, slices.error),
      slices: slices.segments.length,
    });
  }
  console.log('Zhu et al. 2011, table 2');
  console.table(rows);
}
