/**
 * Bricks of a field tree as a mesh, all of it on the GPU and nothing read back. Twin of field/brickMesh.ts: the same
 * loops around the same cells, the same points on creases. Where a mesh does not fit it stays empty and says so; what it needs is known then, and the next has it.
 */
import type { FieldNode } from '../../field/node.ts';
import type { PackedBricks } from '../../field/packedBricks.ts';
import type { Modules } from '../link.ts';
import { type Program, programOf } from '../program.ts';
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
import { type Capacity, type GpuMesh, gpuMesh, outputs } from './gpuMesh.ts';
import { type ListedBricks, packBricks } from './lists.ts';
import { type Stages, stagesOn } from './stages.ts';

export interface GpuPolygonizer {
  /**
   * Begins a mesh; resolves when the device has taken the work, not when it is done. FieldError for what has no field, RangeError for
   * what no device is promised to hold.
   */
  polygonize(node: FieldNode, bricks: ListedBricks | PackedBricks): Promise<GpuMesh>;
  /** A mesh that fits: asks the device, and begins again where it did not. */
  whole(node: FieldNode, bricks: ListedBricks | PackedBricks): Promise<GpuMesh>;
  /**
   * The same of so many bricks whose values `encode` brings onto the device, or has brought there before, in buffers of its own: it hands back
   * what encodeMesh reads.
   */
  meshOf(program: Program, bricks: MeshedBricks, encode: FieldEncoder): Promise<GpuMesh>;
  /** Gives all buffers back, those of meshes that were not destroyed excepted. */
  destroy(): void;
}

/** What the stages of the mesh know of bricks beforehand. */
export type MeshedBricks = Pick<PackedBricks, 'count' | 'hasCreases'>;

/** Records, lists, grid, lattice and values of bricks. */
export type FieldEncoder = (pass: GPUComputePassEncoder, stages: Stages, room: Capacity) => Bound;

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

  async polygonize(node: FieldNode, bricks: ListedBricks | PackedBricks): Promise<GpuMesh> {
    const program = programOf(node);
    const packed = 'lists' in bricks ? bricks : packBricks(node, bricks);
    return this.#meshOf(program, packed, (pass, stages, room) => {
      const field = uploadField(this.#work, program, packed, room);
      encodeField(this.#device, pass, stages, field, packed.count);
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
      return await this.#taken(() => this.#begin(stages, bricks, encode, own));
    } catch (error) {
      // among them may be some that there was no memory for
      for (const buffers of [own, this.#work]) buffers.destroy();
      throw error;
    }
  }

  async whole(node: FieldNode, bricks: ListedBricks | PackedBricks): Promise<GpuMesh> {
    const packed = 'lists' in bricks ? bricks : packBricks(node, bricks);
    return this.#fitting(packed.count, () => this.polygonize(node, packed));
  }

  async #fitting(bricks: number, make: () => Promise<GpuMesh>): Promise<GpuMesh> {
    for (;;) {
      const mesh = await make();
      if (!(await mesh.overflowed())) return mesh;
      this.#needed = { ...(await mesh.needed()), bricks };
      mesh.destroy();
    }
  }

  destroy(): void {
    this.#isGone = true;
    for (const buffers of [this.#work, ...this.#free]) buffers.destroy();
    this.#free.length = 0;
  }

  #begin(stages: Stages, bricks: MeshedBricks, encode: FieldEncoder, own: Buffers): GpuMesh {
    const room = this.#roomFor(bricks);
    const written = outputs(own, room);
    const encoder = this.#device.createCommandEncoder({ label: 'polygonize' });
    const pass = encoder.beginComputePass({ label: 'polygonize' });
    const field = encode(pass, stages, room);
    const creases = stages.creases ? creaseBuffers(this.#work, room) : {};
    const bound = { ...field, ...meshBuffers(this.#work, bricks.count, room), ...creases, ...written };
    encodeMesh(this.#device, pass, stages, bound, bricks.count);
    pass.end();
    this.#device.queue.submit([encoder.finish()]);
    const read = (slices: Parameters<typeof readBack>[1]) => this.#told(readBack(this.#device, slices));
    return gpuMesh(written, read, () => this.#takeBack(own));
  }

  #roomFor({ count, hasCreases }: MeshedBricks): Capacity {
    if (this.#first && !this.#needed) return this.#first;
    const guess = Math.max(FEWEST, (hasCreases ? CREASED : 1) * VERTICES_A_BRICK * count);
    const { vertices, triangles, bricks } = this.#needed ?? { vertices: 0, triangles: 0, bricks: 1 };
    const most = hasCreases ? MOST_CREASED : MOST.vertices;
    const alike = (known: number) => Math.ceil((known * count) / Math.max(1, bricks));
    return {
      vertices: Math.max(Math.min(guess, most), alike(vertices)),
      triangles: Math.max(Math.min(2 * guess, MOST.triangles), alike(triangles)),
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

/** What came of it, or what was thrown. */
function settled<T>(work: () => T): { readonly value: T } | { readonly error: unknown } {
  try {
    return { value: work() };
  } catch (error) {
    return { error };
  }
}
