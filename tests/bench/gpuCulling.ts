/**
 * From a tree to a mesh that can be drawn, of scenes of 64 and 178 segments: bricks found by the device, nothing but records going up,
 * against bricks and lists made by the CPU and sent, against all skels at all nodes.
 */
import type { Lattice } from '../../src/field/lattice.ts';
import type { FieldNode } from '../../src/field/node.ts';
import { boundedProgram } from '../../src/gpu/bricks/bounds.ts';
import { rowsOf, sizesFor } from '../../src/gpu/bricks/cullsOnDevice.ts';
import { encodeCulling } from '../../src/gpu/bricks/encode.ts';
import { COUNTERS, neededRooms } from '../../src/gpu/bricks/levels.ts';
import { firstRooms, grownRooms } from '../../src/gpu/bricks/rooms.ts';
import { brickStagesOn } from '../../src/gpu/bricks/stages.ts';
import { dispatch } from '../../src/gpu/dispatch.ts';
import { Buffers, readBack, USAGE } from '../../src/gpu/polygonize/buffers.ts';
import { packBricks } from '../../src/gpu/polygonize/lists.ts';
import { gpuPolygonizer, type Where } from '../../src/gpu/polygonize/polygonizer.ts';
import { programOf } from '../../src/gpu/program.ts';
import { loadScan } from '../../src/gpu/scan.ts';
import { nodeCount } from '../field/nodeCount.ts';
import { bricksOf } from '../fixtures/bricks.ts';
import { layersOf, least } from './gpuPolygonize.ts';
import { valueOnly } from './gpuTiming.ts';
import { type SceneName, sceneNode } from './scenes/index.ts';
import { rounded } from './timing.ts';

const CELLS = 128;
const ROUNDS = 4;
/** of the layers of nodes one in so many is evaluated densely */
const LAYERS = 32;
const LATTICE: Lattice = { origin: [-1, -1, -1], step: 2 / CELLS, counts: [CELLS + 1, CELLS + 1, CELLS + 1] };

export async function timeCulling(device: GPUDevice): Promise<void> {
  const rows = [];
  for (const name of ['tree64', 'tree178'] as const) rows.push(await timesOf(device, name));
  console.log(`Bricks by the device, ${CELLS}³ cells, ms`);
  console.table(rows);
}

async function timesOf(device: GPUDevice, name: SceneName) {
  const node = sceneNode(name);
  const dense = await denseTime(device, node);
  const culling = await cullingTime(device, node);
  const own = await meshTime(device, node, () => LATTICE);
  const cpu = await meshTime(device, node, () => packBricks(node, bricksOf(node, LATTICE)));
  const packed = packBricks(node, bricksOf(node, LATTICE));
  const given = await meshTime(device, node, () => packed);
  return {
    scene: name,
    'all skels at all nodes': rounded(dense),
    'culling, device': rounded(culling),
    'tree to mesh, device': rounded(own),
    'tree to mesh, culled by the CPU': rounded(cpu),
    'bricks to mesh': rounded(given),
    'dense / device': rounded(dense / own),
  };
}

async function meshTime(device: GPUDevice, node: FieldNode, where: () => Where): Promise<number> {
  const polygonizer = gpuPolygonizer(device);
  const { ms } = await least(ROUNDS, async () => {
    const mesh = await polygonizer.whole(node, where());
    await device.queue.onSubmittedWorkDone();
    mesh.destroy();
  });
  polygonizer.destroy();
  return ms;
}

/** Records made and sent, and all levels of cubes. */
async function cullingTime(device: GPUDevice, node: FieldNode): Promise<number> {
  const program = programOf(node);
  const [stages, scan] = await Promise.all([
    brickStagesOn(device)(program.ingredients, sizesFor(program)!),
    loadScan(device),
  ]);
  const buffers = new Buffers(device);
  let rooms = firstRooms(LATTICE, rowsOf(program));
  const run = async () => {
    const counters = buffers.put('counters', new Uint32Array(COUNTERS), USAGE.storage | USAGE.copySource);
    const culling = { lattice: LATTICE, stages, bounded: boundedProgram(node, programOf(node)), rooms };
    const encoder = device.createCommandEncoder();
    const pass = encoder.beginComputePass();
    encodeCulling(device, pass, scan, buffers, culling, { vertices: 1, triangles: 1 }, counters);
    pass.end();
    device.queue.submit([encoder.finish()]);
    await device.queue.onSubmittedWorkDone();
    return counters;
  };
  for (const _ of rooms) {
    const [bytes] = await readBack(device, [await run()]);
    rooms = grownRooms(rooms, neededRooms(new Uint32Array(bytes!)));
  }
  const { ms } = await least(ROUNDS, run);
  buffers.destroy();
  return ms;
}

async function denseTime(device: GPUDevice, node: FieldNode): Promise<number> {
  const { bound, pipeline } = await valueOnly(device, node);
  const some = layersOf(LATTICE, LAYERS);
  // the first run compiles on some drivers
  await dispatch(device, bound, pipeline, some.subarray(0, 3));
  const { ms } = await least(1, () => dispatch(device, bound, pipeline, some));
  bound.destroy();
  return (ms * 3 * nodeCount(LATTICE)) / some.length;
}
