/** What the device finds of the bricks of a tree: read back, for tests alone. */
import type { Lattice } from '../../../src/field/lattice.ts';
import type { FieldNode } from '../../../src/field/node.ts';
import { boundedProgram } from '../../../src/gpu/bricks/bounds.ts';
import { rowsOf } from '../../../src/gpu/bricks/cullsOnDevice.ts';
import { encodeCulling } from '../../../src/gpu/bricks/encode.ts';
import { COUNTERS, type LevelRoom, neededRooms, overflows } from '../../../src/gpu/bricks/levels.ts';
import { firstRooms, grownRooms } from '../../../src/gpu/bricks/rooms.ts';
import { brickStagesOn } from '../../../src/gpu/bricks/stages.ts';
import type { Ingredients } from '../../../src/gpu/ingredients.ts';
import { Buffers, readBack, USAGE } from '../../../src/gpu/polygonize/buffers.ts';
import { programOf } from '../../../src/gpu/program.ts';
import { loadScan } from '../../../src/gpu/scan.ts';

export interface Culled {
  readonly lattice: Lattice;
  readonly count: number;
  readonly grid: Int32Array;
  /** headers first */
  readonly lists: Uint32Array;
  readonly needed: readonly LevelRoom[];
}

export interface Scene {
  readonly node: FieldNode;
  readonly lattice: Lattice;
}

/** All by one pipeline, made for `ingredients`. */
export async function culledOn(
  device: GPUDevice,
  scenes: readonly Scene[],
  ingredients: Ingredients,
): Promise<readonly Culled[]> {
  const [stages, scan] = await Promise.all([brickStagesOn(device)(ingredients), loadScan(device)]);
  const work = new Buffers(device);
  const run = async ({ node, lattice }: Scene, rooms: readonly LevelRoom[]): Promise<Culled> => {
    const bounded = boundedProgram(node, programOf(node));
    const shared = USAGE.storage | USAGE.copySource;
    const counters = work.put('counters', new Uint32Array(COUNTERS), shared);
    const encoder = device.createCommandEncoder();
    const pass = encoder.beginComputePass();
    const culling = { lattice, stages, bounded, rooms };
    const bound = encodeCulling(device, pass, scan, work, culling, { vertices: 1, triangles: 1 }, counters);
    pass.end();
    device.queue.submit([encoder.finish()]);
    const [counted, grid, lists] = await readBack(device, [counters, bound.grid!, bound.lists!]);
    const needed = neededRooms(new Uint32Array(counted!));
    if (overflows(rooms, needed)) return run({ node, lattice }, grownRooms(rooms, needed));
    const found = { lattice, count: needed.at(-1)!.cubes, needed };
    return { ...found, grid: new Int32Array(grid!), lists: new Uint32Array(lists!) };
  };
  const found: Culled[] = [];
  for (const scene of scenes) {
    found.push(await run(scene, firstRooms(scene.lattice, rowsOf(programOf(scene.node)))));
  }
  work.destroy();
  return found;
}

/** The header of an active brick. */
export function headerOf({ lists }: Culled, number: number) {
  const [place, start] = lists.subarray(4 * number, 4 * number + 2);
  const error = new Float32Array(lists.buffer)[4 * number + 2]!;
  return { i: place! & 1023, j: (place! >> 10) & 1023, k: place! >> 20, start: start!, error };
}
