/** Nanoseconds a segment and a polygon edge on the GPU, and Jin & Tai's scene, for every kernel. */
import { kernels } from '../../src/kernel/index.ts';
import type { Kernel } from '../../src/kernel/kernel.ts';
import type { Skel } from '../../src/skeleton/skels.ts';
import { POLYGONS } from '../fixtures/polygons.ts';
import { bodyOf, leastOnGpu, pointsOf, valueOnly, withGradient } from './gpuTiming.ts';
import { CROSS, LINEAR } from './skels.ts';
import { cube, rounded } from './timing.ts';

const SEGMENTS = 64;
const SIDE = 32;
const POINTS = pointsOf(cube(5, SIDE));
const SCENE_SIDE = 150;

async function nanoseconds(device: GPUDevice, kernel: Kernel, skels: readonly Skel[], parts: number) {
  const node = bodyOf(kernel, skels);
  const least = await leastOnGpu(device, POINTS, 3, {
    value: await valueOnly(device, node),
    both: await withGradient(device, node),
  });
  const per = 1e6 / (SIDE ** 3 * parts);
  return { value: rounded(per * least.value), both: rounded(per * least.both) };
}

export async function timeSkels(device: GPUDevice): Promise<void> {
  const scene = pointsOf(cube(5, SCENE_SIDE));
  const rows = [];
  for (const kernel of kernels) {
    const line = await nanoseconds(device, kernel, new Array<Skel>(SEGMENTS).fill(LINEAR), SEGMENTS);
    const edge = await nanoseconds(device, kernel, [POLYGONS.star], POLYGONS.star.loops[0]!.length);
    const cross = { all: await valueOnly(device, bodyOf(kernel, CROSS)) };
    const { all } = await leastOnGpu(device, scene, 1, cross);
    rows.push({
      kernel: kernel.name,
      'segment, value, ns': line.value,
      'value + gradient': line.both,
      'edge, value, ns': edge.value,
      'value + gradient ': edge.both,
      'cross 150³, s': rounded(all / 1000, 2),
    });
  }
  console.table(rows);
}
