/**
 * A body on the device, ready for rays from anywhere: records, bricks and near lists, found by the device itself (src/gpu/bricks) or sent, and
 * what blocks of bricks hold. Kept from one picture to the next, so that another view sends up its camera alone.
 */
import { bindField } from '../../field/bind.ts';
import type { Lattice } from '../../field/lattice.ts';
import { Tally } from '../../field/near.ts';
import type { Colour, FieldNode } from '../../field/node.ts';
import { type BoundedProgram, boundedProgram } from '../bricks/bounds.ts';
import { rowsOf, sizesFor } from '../bricks/cullsOnDevice.ts';
import { encodeCulling } from '../bricks/encode.ts';
import { COUNTERS, neededRooms, overflows, ROW } from '../bricks/levels.ts';
import { Rooms } from '../bricks/rooms.ts';
import { brickStagesOn } from '../bricks/stages.ts';
import { Buffers, readBack, type Slice, USAGE } from '../polygonize/buffers.ts';
import { putLattice } from '../polygonize/encode.ts';
import { packBricks } from '../polygonize/lists.ts';
import type { Where } from '../polygonize/polygonizer.ts';
import { type Program, programOf } from '../program.ts';
import { loadScan, type Scan } from '../scan.ts';
import { taken } from '../taken.ts';
import { bindGroup } from './bindGroup.ts';
import { isCastOnDevice } from './castsOnDevice.ts';
import { RAY_STAGES, type RayStages, rayStagesOn } from './stages.ts';

export interface DeviceBody {
  readonly lattice: Lattice;
  /** active ones */
  readonly bricks: number;
  /** what it takes of the device's memory */
  readonly bytes: number;
  readonly stages: RayStages;
  /** by the names that RAY_STAGES binds */
  readonly bound: Readonly<Record<'records' | 'lists' | 'grid' | 'blocks' | 'lattice', Slice>>;
  /** of the records: where leaves begin */
  readonly leaves: number;
  /** of all the body, where it has one colour */
  readonly plain: Colour | null;
  destroy(): void;
}

/** Where the surface may be, as the device has it. */
interface Bricks {
  readonly lattice: Lattice;
  readonly count: number;
  readonly grid: Slice;
  readonly lists: Slice;
}

/** there is no mesh */
const NO_MESH = { vertices: 1, triangles: 1 };

export class BodyMaker {
  readonly #device: GPUDevice;
  readonly #rooms = new Rooms();
  /** of culling, which is one body's at a time */
  readonly #work: Buffers;
  #turn: Promise<unknown> = Promise.resolve();
  #scan: Promise<Scan> | null = null;

  constructor(device: GPUDevice) {
    this.#device = device;
    this.#work = new Buffers(device);
  }

  /** RangeError for trees that the device has no bounds for, and for what no device is promised to hold. */
  async make(node: FieldNode, where: Where): Promise<DeviceBody> {
    const program = programOf(node);
    if (!isCastOnDevice(program)) throw new RangeError('a tree that rays on the device know no bounds of');
    const stages = await rayStagesOn(this.#device)(program.ingredients);
    const own = new Buffers(this.#device);
    try {
      const bounded = boundedProgram(node, program);
      const bricks = await this.#bricksOf(own, node, program, bounded, where);
      const plain = bindField(node).near(new Tally()).plain;
      return await taken(this.#device, 'a body', () => this.#bodyOf(own, stages, bounded, bricks, plain));
    } catch (error) {
      own.destroy();
      throw error;
    }
  }

  destroy(): void {
    this.#work.destroy();
  }

  async #bricksOf(
    own: Buffers,
    node: FieldNode,
    program: Program,
    bounded: BoundedProgram,
    where: Where,
  ): Promise<Bricks> {
    if ('origin' in where) {
      const turn = this.#turn.then(() => this.#found(own, program, bounded, where));
      // buffers that the device had no memory for would be taken for good ones by the next
      this.#turn = turn.catch(() => this.#work.destroy());
      return turn;
    }
    const { lattice, count, grid, lists } = 'lists' in where ? where : packBricks(node, where);
    const put = (name: string, words: Int32Array<ArrayBuffer> | Uint32Array<ArrayBuffer>) =>
      own.put(name, words, USAGE.storage);
    return { lattice, count, grid: put('grid', grid), lists: put('lists', lists) };
  }

  /** By the device; in buffers that are no larger than they have to be. */
  async #found(own: Buffers, program: Program, bounded: BoundedProgram, lattice: Lattice): Promise<Bricks> {
    const device = this.#device;
    const work = this.#work;
    this.#scan ??= loadScan(device);
    const sizes = sizesFor(program);
    if (!sizes) throw new RangeError('a tree whose bricks the device cannot find');
    const [stages, scan] = await Promise.all([brickStagesOn(device)(program.ingredients, sizes), this.#scan]);
    for (;;) {
      const rooms = this.#rooms.of(lattice, rowsOf(program));
      const { bound, counters } = await taken(device, 'bricks', () => {
        const counters = work.put('counters', new Uint32Array(COUNTERS), USAGE.storage | USAGE.copySource);
        const encoder = device.createCommandEncoder({ label: 'bricks for rays' });
        const pass = encoder.beginComputePass({ label: 'bricks for rays' });
        const culling = { lattice, stages, bounded, rooms };
        const bound = encodeCulling(device, pass, scan, work, culling, NO_MESH, counters);
        pass.end();
        device.queue.submit([encoder.finish()]);
        return { bound, counters };
      });
      const [bytes] = await readBack(device, [counters]);
      const needed = neededRooms(new Uint32Array(bytes!));
      if (!overflows(rooms, needed)) {
        const { cubes, rows } = needed.at(-1)!;
        // headers twice, as they came and in the order of the grid
        const used = { ...bound.lists!, size: ROW * (2 * rooms.at(-1)!.cubes + rows) };
        const [ownGrid, ownLists] = await taken(device, 'bricks', () =>
          copied(device, own, { grid: bound.grid!, lists: used }),
        );
        return { lattice, count: cubes, grid: ownGrid!, lists: ownLists! };
      }
      this.#rooms.grow(lattice, needed);
    }
  }

  #bodyOf(
    own: Buffers,
    stages: RayStages,
    { records, leaves }: BoundedProgram,
    { lattice, count, grid, lists }: Bricks,
    plain: Colour | null,
  ): DeviceBody {
    const blocks = lattice.counts.reduce((product, nodes) => product * Math.ceil((nodes - 1) / 16), 1);
    const bound = {
      records: own.put('records', records, USAGE.storage),
      lists,
      grid,
      blocks: own.get('blocks', 4 * blocks, USAGE.storage),
      lattice: putLattice(own, lattice, count, NO_MESH),
    };
    const device = this.#device;
    const encoder = device.createCommandEncoder({ label: 'raycast blocks' });
    const pass = encoder.beginComputePass({ label: 'raycast blocks' });
    pass.setPipeline(stages.blocks);
    pass.setBindGroup(0, bindGroup(device, stages.blocks, 0, RAY_STAGES.blocks, bound));
    pass.dispatchWorkgroups(Math.ceil(blocks / 64));
    pass.end();
    device.queue.submit([encoder.finish()]);
    const bytes = Object.values(bound).reduce((sum, { size }) => sum + size, 0);
    return { lattice, bricks: count, bytes, stages, bound, leaves, plain, destroy: () => own.destroy() };
  }
}

/** The same bytes in buffers of one's own. */
function copied(device: GPUDevice, own: Buffers, slices: Readonly<Record<string, Slice>>): readonly Slice[] {
  const encoder = device.createCommandEncoder({ label: 'bricks kept' });
  const kept = Object.entries(slices).map(([name, { buffer, size }]) => {
    const slice = own.get(name, size, USAGE.storage | USAGE.copyTarget);
    encoder.copyBufferToBuffer(buffer, 0, slice.buffer, 0, size);
    return slice;
  });
  device.queue.submit([encoder.finish()]);
  return kept;
}
