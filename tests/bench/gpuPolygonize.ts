/**
 * The polygonizer on the GPU, a branching tree of 64 segments: values at the nodes of active bricks by near lists, against all skels at
 * all nodes of the lattice on the same adapter; then all stages of the mesh. Culling and lists are the CPU's and timed apart.
 */

import { bindField } from '../../src/field/bind.ts';
import type { Lattice } from '../../src/field/lattice.ts';
import type { FieldNode } from '../../src/field/node.ts';
import type { PackedBricks } from '../../src/field/packedBricks.ts';
import { type Located, locating } from '../../src/field/polygonize.ts';
import { dispatch } from '../../src/gpu/dispatch.ts';
import { Buffers } from '../../src/gpu/polygonize/buffers.ts';
import { encodeField, uploadField } from '../../src/gpu/polygonize/encode.ts';
import { packBricks } from '../../src/gpu/polygonize/lists.ts';
import { gpuPolygonizer } from '../../src/gpu/polygonize/polygonizer.ts';
import { stagesOn } from '../../src/gpu/polygonize/stages.ts';
import { programOf } from '../../src/gpu/program.ts';
import { finished } from '../../src/math/finished.ts';
import { nodeCount } from '../field/nodeCount.ts';
import { askedOf, bricksOf } from '../fixtures/bricks.ts';
import { valueOnly } from './gpuTiming.ts';
import { timeKravtsovOnGpu } from './kravtsov.ts';
import { sceneNode } from './scenes/index.ts';
import { rounded } from './timing.ts';

const CELLS = 128;
const ROUNDS = 5;
/** of the layers of nodes one in so many is evaluated densely, for all of them take too long on software adapters */
const LAYERS = 8;

const NODE = sceneNode('tree64');
const LATTICE: Lattice = {
  origin: [-1, -1, -1],
  step: 2 / CELLS,
  counts: [CELLS + 1, CELLS + 1, CELLS + 1],
};

export async function timePolygonizer(device: GPUDevice): Promise<void> {
  bindField(NODE);
  const culling = await least(1, async () => bricksOf(NODE, LATTICE));
  const bricks = culling.result;
  const packing = await least(ROUNDS, async () => packBricks(NODE, bricks));
  const dense = await denseTime(device);
  const nodes = await fieldTime(device, packing.result);
  const mesh = await meshTime(device, packing.result);
  console.log(`Polygonizer on the GPU, 64 segments, ${CELLS}³ cells, ${bricks.active.length} active bricks`);
  console.table([
    {
      'all skels at all nodes, ms': rounded(dense),
      'nodes by lists, ms': rounded(nodes),
      ratio: rounded(dense / nodes),
      'whole mesh, ms': rounded(mesh.ms),
      triangles: mesh.triangles,
      'vertex error, cells, 99.9 %': rounded(mesh.errors[Math.floor(0.999 * mesh.errors.length)]!, 4),
      most: rounded(mesh.errors.at(-1)!, 4),
      'CPU: bricks and lists, ms': rounded(culling.ms),
      'packed, ms': rounded(packing.ms),
      'near a brick': rounded(askedOf(bricks) / bricks.active.length),
    },
  ]);
}

/** Kravtsov's table: from the tree to a mesh that can be drawn, culling and lists by the CPU counted in. */
export async function timeKravtsov(device: GPUDevice): Promise<void> {
  const polygonizer = gpuPolygonizer(device);
  await timeKravtsovOnGpu(async (node, cells) => {
    const { ms } = await least(ROUNDS, async () => {
      const { bricks } = located(node, cells);
      const mesh = await polygonizer.whole(node, bricks);
      await device.queue.onSubmittedWorkDone();
      mesh.destroy();
    });
    return ms;
  });
  polygonizer.destroy();
}

function located(node: FieldNode, cells: number): Located {
  return finished(locating(bindField(node), cells));
}

/** Values come back, as from any field; that is a small part of it. */
async function denseTime(device: GPUDevice): Promise<number> {
  const { bound, pipeline } = await valueOnly(device, NODE);
  const some = layersOf(LATTICE, LAYERS);
  // the first run compiles on some drivers
  await dispatch(device, bound, pipeline, some.subarray(0, 3));
  const { ms } = await least(1, () => dispatch(device, bound, pipeline, some));
  bound.destroy();
  return (ms * 3 * nodeCount(LATTICE)) / some.length;
}

/** x, y, z of the nodes of one layer in so many. */
export function layersOf({ origin, step, counts }: Lattice, every: number): Float32Array {
  const [nx, ny, nz] = counts;
  const layers = Math.ceil(nz / every);
  return Float32Array.from({ length: 3 * nx * ny * layers }, (_, i) => {
    const node = Math.floor(i / 3);
    const at = [node % nx, Math.floor(node / nx) % ny, every * Math.floor(node / (nx * ny))];
    return origin[i % 3]! + at[i % 3]! * step;
  });
}

/** The values of all nodes of active bricks, once lists are on the device. */
async function fieldTime(device: GPUDevice, bricks: PackedBricks): Promise<number> {
  const program = programOf(NODE);
  const stages = await stagesOn(device)(program.ingredients);
  const buffers = new Buffers(device);
  const bound = uploadField(buffers, program, bricks, { vertices: 1, triangles: 1 });
  const { ms } = await least(ROUNDS, async () => {
    const encoder = device.createCommandEncoder();
    const pass = encoder.beginComputePass();
    encodeField(device, pass, stages, bound, bricks.count);
    pass.end();
    device.queue.submit([encoder.finish()]);
    await device.queue.onSubmittedWorkDone();
  });
  buffers.destroy();
  return ms;
}

/** All stages, the sending of lists counted in. */
async function meshTime(device: GPUDevice, bricks: PackedBricks) {
  const polygonizer = gpuPolygonizer(device);
  const { ms } = await least(ROUNDS, async () => {
    const mesh = await polygonizer.polygonize(NODE, bricks);
    await device.queue.onSubmittedWorkDone();
    mesh.destroy();
  });
  const mesh = await polygonizer.whole(NODE, bricks);
  const { positions, indices } = await mesh.read();
  polygonizer.destroy();
  return { ms, triangles: indices.length / 3, errors: errorsOf(positions) };
}

/** How far each vertex is from the surface of all skels, in cells; sorted. */
function errorsOf(positions: Float32Array): Float64Array {
  const field = bindField(NODE);
  const out = new Float64Array(4);
  const errors = Float64Array.from({ length: positions.length / 3 }, (_, vertex) => {
    field.evaluate(positions[3 * vertex]!, positions[3 * vertex + 1]!, positions[3 * vertex + 2]!, out);
    return Math.abs(out[0]!) / (Math.sqrt(out[1]! ** 2 + out[2]! ** 2 + out[3]! ** 2) * LATTICE.step);
  });
  return errors.sort();
}

/** Least milliseconds of so many rounds, after one that does not count where there are several. */
export async function least<T>(rounds: number, work: () => Promise<T>): Promise<{ ms: number; result: T }> {
  let result = rounds > 1 ? await work() : null;
  let ms = Infinity;
  for (let round = 0; round < rounds; round++) {
    const start = performance.now();
    result = await work();
    ms = Math.min(ms, performance.now() - start);
  }
  return { ms, result: result as T };
}
