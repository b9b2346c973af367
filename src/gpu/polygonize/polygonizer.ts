/**
 * Bricks of a field tree as a mesh, all of it on the GPU and nothing read back. Twin of field/brickMesh.ts: the same
 * loops around the same cells, the same points on creases. Where a mesh does not fit it stays empty and says so; what it needs is known then, and the next has it.
 */
import { bindField } from '../../field/bind.ts';
import { isSmooth } from '../../field/bricks.ts';
import type { Lattice } from '../../field/lattice.ts';
import type { FieldNode } from '../../field/node.ts';
import type { PackedBricks } from '../../field/packedBricks.ts';
import { boundedProgram } from '../bricks/bounds.ts';
import { isCulledOnDevice, rowsOf, sizesFor } from '../bricks/cullsOnDevice.ts';
import { type Culling, encodeCulling } from '../bricks/encode.ts';
import type { LevelRoom } from '../bricks/levels.ts';
import { Rooms } from '../bricks/rooms.ts';
import { brickStagesOn } from '../bricks/stages.ts';
import type { Modules } from '../link.ts';
import { type Program, programOf } from '../program.ts';
import { taken } from '../taken.ts';
import { Buffers, MOST_BYTES, readBack } from './buffers.ts';
import {
  type Bound,
  CREASED_LOOP,
  creaseBuffers,
  encodeField,
  encodeMesh,
  meshBuffers,
  uploadField,
} from './encode.ts';
import { type Capacity, type GpuMesh, gpuMesh, type Outputs, outputs } from './gpuMesh.ts';
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
  /**
   * The same of so many bricks whose values `encode` brings onto the device, or has brought there before, in buffers of its own: it hands back
   * what encodeMesh reads.
   */
  meshOf(program: Program, bricks: MeshedBricks, encode: FieldEncoder): Promise<GpuMesh>;
  /** Gives all buffers back, those of meshes that were not destroyed excepted. */
  destroy(): void;
}

/** What the stages of the mesh know of bricks beforehand. */
export interface MeshedBricks extends Pick<PackedBricks, 'count' | 'hasCreases'> {
  /** of levels, where the device finds them */
  readonly rooms?: readonly LevelRoom[];
}

/** Records, lists, grid, lattice and values of bricks; what is counted of those that the device finds goes into `outputs`. */
export type FieldEncoder = (
  pass: GPUComputePassEncoder,
  stages: Stages,
  room: Capacity,
  outputs: Outputs,
) => Bound;

/** A brick that the surface crosses has some 40 vertices; two of three active ones are crossed. */
const VERTICES_A_BRICK = 40;
/** of those of smooth ones */
const CREASED = 1.25;
const FEWEST = 64;
/** what every device binds of cells and indices */
const MOST: Capacity = { vertices: 0.75 * (MOST_BYTES / 16), triangles: Math.floor(MOST_BYTES / 12) };
/** and of loops around creases, each with two vertices at least */
const MOST_CREASED = 2 * (MOST_BYTES / CREASED_LOOP);

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
  /** of the last that did not fit, of so many bricks: others are taken to need as much a brick */
  #needed: (Capacity & { readonly bricks: number }) | null = null;
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
    if ('origin' in where) {
      const culling = await this.#cullingOf(node, program, where);
      return this.#culled(program, culling, !isSmooth(bindField(node)));
    }
    const bricks = packed(node, where);
    return this.#meshOf(program, bricks, (pass, stages, room) => {
      const field = uploadField(this.#work, program, bricks, room);
      encodeField(this.#device, pass, stages, field, bricks.count);
      return field;
    });
  }

  /** Of bricks that the device finds, as many as there is room for. Whether creases are in them only the device knows. */
  #culled(program: Program, culling: Culling, hasCreases: boolean): Promise<GpuMesh> {
    const { rooms } = culling;
    const bricks = { count: rooms.at(-1)!.cubes, hasCreases, rooms };
    return this.#meshOf(program, bricks, (pass, stages, room, { counters }) => {
      const field = encodeCulling(this.#device, pass, stages.scan, this.#work, culling, room, counters);
      encodeField(this.#device, pass, stages, field, bricks.count);
      return field;
    });
  }

  async meshOf(program: Program, bricks: MeshedBricks, encode: FieldEncoder): Promise<GpuMesh> {
    return this.#fitting(bricks.count, () => this.#meshOf(program, bricks, encode));
  }

  async #meshOf(program: Program, bricks: MeshedBricks, encode: FieldEncoder): Promise<GpuMesh> {
    const stages = await this.#told(this.#stages(program.ingredients, bricks.hasCreases));
    if (this.#isGone) throw new Error('the polygonizer was given back');
    const own = this.#free.pop() ?? new Buffers(this.#device);
    try {
      return await this.#told(taken(this.#device, 'a mesh', () => this.#begin(stages, bricks, encode, own)));
    } catch (error) {
      // among them may be some that there was no memory for
      for (const buffers of [own, this.#work]) buffers.destroy();
      throw error;
    }
  }

  async whole(node: FieldNode, where: Where): Promise<GpuMesh> {
    if ('origin' in where) return this.#fitting(0, () => this.polygonize(node, where), where);
    const bricks = packed(node, where);
    return this.#fitting(bricks.count, () => this.polygonize(node, bricks));
  }

  /** Makes it again until it fits. `culled`: the lattice whose bricks the device finds. */
  async #fitting(
    bricks: number,
    make: () => Promise<GpuMesh>,
    culled: Lattice | null = null,
  ): Promise<GpuMesh> {
    for (;;) {
      const mesh = await make();
      if (!(await mesh.overflowed())) return mesh;
      const needed = await mesh.needed();
      if (culled) this.#rooms.grow(culled, needed.bricks);
      const count = culled ? needed.bricks.at(-1)!.cubes : bricks;
      const { vertices, triangles } = needed;
      if (vertices > MOST.vertices || triangles > MOST.triangles)
        throw new RangeError(
          `${vertices} vertices and ${triangles} triangles are more than every device binds`,
        );
      if (needed.vertices > 0) this.#needed = { ...needed, bricks: count };
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

  #begin(stages: Stages, bricks: MeshedBricks, encode: FieldEncoder, own: Buffers): GpuMesh {
    const room = this.#roomFor(bricks);
    const written = outputs(own, room);
    const encoder = this.#device.createCommandEncoder({ label: 'polygonize' });
    const pass = encoder.beginComputePass({ label: 'polygonize' });
    const field = encode(pass, stages, room, written);
    const creases = stages.creases ? creaseBuffers(this.#work, room) : {};
    const bound = { ...field, ...meshBuffers(this.#work, bricks.count, room), ...creases, ...written };
    encodeMesh(this.#device, pass, stages, bound, bricks.count);
    pass.end();
    this.#device.queue.submit([encoder.finish()]);
    const read = (slices: Parameters<typeof readBack>[1]) => this.#told(readBack(this.#device, slices));
    return gpuMesh(written, read, () => this.#takeBack(own), bricks.rooms);
  }

  #roomFor({ count, hasCreases }: MeshedBricks): Capacity {
    if (this.#first && !this.#needed) return this.#first;
    const guess = Math.max(FEWEST, (hasCreases ? CREASED : 1) * VERTICES_A_BRICK * count);
    const { vertices, triangles, bricks } = this.#needed ?? { vertices: 0, triangles: 0, bricks: 1 };
    const most = hasCreases ? MOST_CREASED : MOST.vertices;
    const alike = (known: number) => Math.ceil((known * count) / Math.max(1, bricks));
    return {
      vertices: Math.min(Math.max(guess, alike(vertices)), most),
      triangles: Math.min(Math.max(2 * guess, alike(triangles)), MOST.triangles),
    };
  }

  #takeBack(own: Buffers): void {
    if (this.#isGone) own.destroy();
    else this.#free.push(own);
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
