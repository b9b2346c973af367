/**
 * Bricks of a field tree as a mesh, all of it on the GPU and nothing read back. Twin of field/brickMesh.ts, creases
 * excepted: the same loops around the same cells. Where a mesh does not fit it stays empty and says so; what it needs is known then, and the next has it.
 */

import type { Lattice } from '../../field/lattice.ts';
import type { FieldNode } from '../../field/node.ts';
import type { PackedBricks } from '../../field/packedBricks.ts';
import { boundedProgram } from '../bricks/bounds.ts';
import { isCulledOnDevice, rowsOf, sizesFor } from '../bricks/cullsOnDevice.ts';
import { type Culling, encodeCulling } from '../bricks/encode.ts';
import { Rooms } from '../bricks/rooms.ts';
import { brickStagesOn } from '../bricks/stages.ts';
import type { Modules } from '../link.ts';
import { type Program, programOf } from '../program.ts';
import { Buffers, MOST_BYTES, readBack } from './buffers.ts';
import { encodeField, encodeMesh, meshBuffers, uploadField } from './encode.ts';
import { type Capacity, type GpuMesh, gpuMesh, outputs } from './gpuMesh.ts';
import { type ListedBricks, packBricks } from './lists.ts';
import { type Stages, stagesOn } from './stages.ts';

/** Bricks of that very tree; or a lattice, whose bricks the device finds itself where it can (bricks/cullsOnDevice.ts). */
export type Where = ListedBricks | PackedBricks | Lattice;

export interface GpuPolygonizer {
  /**
   * Begins a mesh; resolves when the device has taken the work, not when it is done. FieldError for what has no field, RangeError for
   * what no device is promised to hold.
   */
  polygonize(node: FieldNode, where: Where): Promise<GpuMesh>;
  /** A mesh that fits: asks the device, and begins again where it did not. */
  whole(node: FieldNode, where: Where): Promise<GpuMesh>;
  /** Gives all buffers back, those of meshes that were not destroyed excepted. */
  destroy(): void;
}

/** A brick that the surface crosses has some 40 vertices; two of three active ones are crossed. */
const VERTICES_A_BRICK = 40;
const FEWEST = 64;
/** what every device binds of cells and indices */
const MOST: Capacity = { vertices: 0.75 * (MOST_BYTES / 16), triangles: Math.floor(MOST_BYTES / 12) };

/** `capacity`: in place of what is guessed of the first mesh. `changed`: WGSL modules that stand in for others. */
export function gpuPolygonizer(
  device: GPUDevice,
  capacity: Capacity | null = null,
  changed: Modules | null = null,
): GpuPolygonizer {
  return new Polygonizer(device, capacity, changed);
}

class Polygonizer implements GpuPolygonizer {
  readonly #device: GPUDevice;
  readonly #stages: ReturnType<typeof stagesOn>;
  readonly #work: Buffers;
  /** of meshes that were destroyed */
  readonly #free: Buffers[] = [];
  /** of the first mesh */
  readonly #first: Capacity | null;
  /** of one that did not fit */
  #needed: Capacity | null = null;
  /** of bricks that the device culls */
  readonly #rooms = new Rooms();
  #isGone = false;
  #lost: string | null = null;

  constructor(device: GPUDevice, capacity: Capacity | null, changed: Modules | null) {
    this.#device = device;
    this.#first = capacity;
    this.#stages = stagesOn(device, changed);
    this.#work = new Buffers(device);
    void device.lost.then(({ message, reason }) => {
      this.#lost = message || reason || 'unknown reason';
    });
  }

  async polygonize(node: FieldNode, where: Where): Promise<GpuMesh> {
    const program = programOf(node);
    const [ground, stages] = await Promise.all([
      'origin' in where ? this.#cullingOf(node, program, where) : packed(node, where),
      this.#told(this.#stages(program.ingredients)),
    ]);
    if (this.#isGone) throw new Error('the polygonizer was given back');
    const own = this.#free.pop() ?? new Buffers(this.#device);
    try {
      return await this.#taken(() => this.#begin(stages, program, ground, own));
    } catch (error) {
      // among them may be some that there was no memory for
      for (const buffers of [own, this.#work]) buffers.destroy();
      throw error;
    }
  }

  async whole(node: FieldNode, where: Where): Promise<GpuMesh> {
    const ground = 'origin' in where ? where : packed(node, where);
    for (;;) {
      const mesh = await this.polygonize(node, ground);
      if (!(await mesh.overflowed())) return mesh;
      const needed = await mesh.needed();
      if ('origin' in ground) this.#rooms.grow(ground, needed.bricks);
      if (needed.vertices > 0) this.#needed = needed;
      mesh.destroy();
    }
  }

  destroy(): void {
    this.#isGone = true;
    for (const buffers of [this.#work, ...this.#free]) buffers.destroy();
    this.#free.length = 0;
  }

  /** How the device culls that tree. */
  async #cullingOf(node: FieldNode, program: Program, lattice: Lattice): Promise<Culling> {
    const sizes = sizesFor(program);
    if (!sizes || !isCulledOnDevice(program))
      throw new RangeError('a tree whose bricks the device cannot find');
    const stages = await this.#told(brickStagesOn(this.#device)(program.ingredients, sizes));
    const rooms = this.#rooms.of(lattice, rowsOf(program));
    return { lattice, stages, bounded: boundedProgram(node, program), rooms };
  }

  #begin(stages: Stages, program: Program, ground: PackedBricks | Culling, own: Buffers): GpuMesh {
    const count = 'count' in ground ? ground.count : ground.rooms.at(-1)!.cubes;
    const room = this.#roomFor(count);
    const written = outputs(own, room);
    const [device, work] = [this.#device, this.#work];
    const encoder = device.createCommandEncoder({ label: 'polygonize' });
    const pass = encoder.beginComputePass({ label: 'polygonize' });
    const field =
      'count' in ground
        ? uploadField(work, program, ground, room)
        : encodeCulling(device, pass, stages.scan, work, ground, room, written.counters);
    const bound = { ...field, ...meshBuffers(work, count, room), ...written };
    encodeField(device, pass, stages, field, count);
    encodeMesh(device, pass, stages, bound, count);
    pass.end();
    device.queue.submit([encoder.finish()]);
    const read = (slices: Parameters<typeof readBack>[1]) => this.#told(readBack(device, slices));
    return gpuMesh(written, read, () => this.#takeBack(own), 'count' in ground ? [] : ground.rooms);
  }

  #roomFor(count: number): Capacity {
    if (this.#first && !this.#needed) return this.#first;
    const guess = Math.max(FEWEST, VERTICES_A_BRICK * count);
    const { vertices, triangles } = this.#needed ?? { vertices: 0, triangles: 0 };
    return {
      vertices: Math.max(Math.min(guess, MOST.vertices), vertices),
      triangles: Math.max(Math.min(2 * guess, MOST.triangles), triangles),
    };
  }

  #takeBack(own: Buffers): void {
    if (this.#isGone) own.destroy();
    else this.#free.push(own);
  }

  /** What `work` begins, once the device has taken it. */
  async #taken<T>(work: () => T): Promise<T> {
    const device = this.#device;
    for (const filter of ['out-of-memory', 'validation'] as const) device.pushErrorScope(filter);
    const pop = () => this.#told(Promise.all([device.popErrorScope(), device.popErrorScope()]));
    const begun = settled(work);
    const refusal = (await pop()).find((error) => error !== null);
    if ('error' in begun) throw begun.error;
    if (refusal) throw new Error(`the graphics device refused a mesh: ${refusal.message}`);
    return begun.value;
  }

  /** What comes of it; or, in words, that the device is gone. */
  async #told<T>(work: Promise<T>): Promise<T> {
    const result = await work.catch((error: unknown) => {
      if (this.#lost === null) throw error;
      return null;
    });
    if (this.#lost !== null) throw new Error(`the graphics device was lost: ${this.#lost}`);
    return result as T;
  }
}

const packed = (node: FieldNode, bricks: ListedBricks | PackedBricks): PackedBricks =>
  'lists' in bricks ? bricks : packBricks(node, bricks);

/** What came of it, or what was thrown. */
function settled<T>(work: () => T): { readonly value: T } | { readonly error: unknown } {
  try {
    return { value: work() };
  } catch (error) {
    return { error };
  }
}
