/**
 * The stages one after the other: nodes → share → classify → number → scan → plan → compact → vertices on edges → emit → vertices in
 * the middle of loops; where there are creases, before emit: rings counted → scan → plan → rings listed → points on creases, and after it
 * their triangles. How many vertices and cells there are only the device knows: it plans its own dispatches and the draw
 * (Kravtsov §1.3.1 in five steps, but indexed).
 */
import type { Lattice } from '../../field/lattice.ts';
import type { PackedBricks } from '../../field/packedBricks.ts';
import type { Program } from '../program.ts';
import { ITEM, totalsOf } from '../scan.ts';
import { type Buffers, type Slice, USAGE } from './buffers.ts';
import type { Capacity, Outputs } from './gpuMesh.ts';
import { MOST_ALONG } from './lists.ts';
import { loopTable } from './loopTable.ts';
import {
  CREASE_STAGES,
  type CreaseStageName,
  LATTICE,
  STAGES,
  type StageName,
  type Stages,
} from './stages.ts';

/** By the names that STAGES binds. */
export type Bound = Readonly<Record<string, Slice>> & {
  readonly brickGroups?: Slice & { readonly offset: number };
};

/** Per brick: 128 places for nodes, 64 cells. */
export const NODES = 128;
const CELLS = 64;
const LOOPS = loopTable();
/** bytes, as in shaders/polygonize/creased.wgsl */
export const CREASED_LOOP = 64;
/** a closed mesh has four cells around each vertex on an edge, and three such vertices around each cell */
const CELLS_A_VERTEX = 4 / 3;

/** What the field stages read: uploaded, in work buffers. RangeError for more than every device binds. */
export function uploadField(
  buffers: Buffers,
  program: Program,
  { lattice, count, grid, lists }: PackedBricks,
  room: Capacity,
): Bound {
  return {
    records: buffers.put('records', program.records, USAGE.storage),
    lists: buffers.put('lists', lists, USAGE.storage),
    grid: buffers.put('grid', grid, USAGE.storage),
    ...latticeBuffers(buffers, lattice, count, room),
  };
}

/** The lattice, whose active bricks may be the device's to count, and room for values in so many. RangeError for one without whole bricks. */
export function latticeBuffers(buffers: Buffers, lattice: Lattice, bricks: number, room: Capacity): Bound {
  return {
    lattice: putLattice(buffers, lattice, bricks, room),
    values: buffers.get('values', 4 * NODES * roomsOf(bricks), USAGE.storage | USAGE.copySource),
  };
}

/** The lattice, and how many bricks of it are active. RangeError for one without whole bricks. */
export function putLattice(buffers: Buffers, lattice: Lattice, count: number, room: Capacity): Slice {
  const along = lattice.counts.map((nodes) => (nodes - 1) / 4);
  if (!along.every((number) => Number.isInteger(number) && number >= 1 && number <= MOST_ALONG))
    throw new RangeError(`a lattice of ${lattice.counts.join(' × ')} nodes has no bricks of four cells`);
  const { origin, step } = lattice;
  const capacities = [room.vertices, 3 * room.triangles, cellsOf(room), 0];
  const header = LATTICE.pack([{ origin, step, bricks: [...along, count], capacities }]);
  return buffers.put('lattice', header, USAGE.uniform | USAGE.storage);
}

/** What lies between the stages. */
export function meshBuffers(buffers: Buffers, bricks: number, room: Capacity): Bound {
  const count = roomsOf(bricks);
  return {
    crossings: buffers.get('crossings', 4 * NODES * count, USAGE.storage),
    cells: buffers.get('cells', 8 * CELLS * count, USAGE.storage),
    counts: buffers.get('counts', ITEM * count, USAGE.storage),
    totals: buffers.get('totals', ITEM * totalsOf(count), USAGE.storage),
    loops: buffers.put('loops', LOOPS, USAGE.uniform),
    dispatches: buffers.get('dispatches', 48, USAGE.storage | USAGE.indirect),
    edgeSpan: buffers.get('edgeSpan', 16, USAGE.storage | USAGE.uniform),
    middleSpan: buffers.get('middleSpan', 16, USAGE.storage | USAGE.uniform),
    vertexEdges: buffers.get('vertexEdges', 4 * room.vertices, USAGE.storage),
    crossedCells: buffers.get('crossedCells', 16 * cellsOf(room), USAGE.storage),
  };
}

/** The same for creases. */
export function creaseBuffers(buffers: Buffers, room: Capacity): Bound {
  const cells = cellsOf(room);
  return {
    ringCounts: buffers.get('ringCounts', ITEM * cells, USAGE.storage),
    ringTotals: buffers.get('ringTotals', ITEM * totalsOf(cells), USAGE.storage),
    // each has two vertices at least
    creasedLoops: buffers.get('creasedLoops', CREASED_LOOP * Math.ceil(room.vertices / 2), USAGE.storage),
  };
}

/** There are no empty buffers. */
const roomsOf = (bricks: number) => Math.max(1, bricks);
const cellsOf = ({ vertices }: Capacity) => Math.ceil(CELLS_A_VERTEX * vertices);

/** The values at all nodes of so many active bricks; of `brickGroups` where the device counts them. */
export function encodeField(
  device: GPUDevice,
  pass: GPUComputePassEncoder,
  stages: Stages,
  bound: Bound,
  bricks: number,
) {
  if (bricks === 0) return;
  for (const name of ['nodes', 'share'] as const) {
    bind(device, pass, stages, name, bound);
    dispatchBricks(pass, bound, bricks);
  }
}

/** The mesh of those values. */
export function encodeMesh(
  device: GPUDevice,
  pass: GPUComputePassEncoder,
  stages: Stages,
  bound: Bound & Outputs,
  bricks: number,
) {
  const start = (name: StageName | CreaseStageName) => bind(device, pass, stages, name, bound);
  start('classify');
  dispatchBricks(pass, bound, roomsOf(bricks));
  start('number');
  pass.dispatchWorkgroups(Math.ceil(roomsOf(bricks) / 64));
  stages.scan.encode(pass, bound.counts!, bound.totals!);
  start('plan');
  pass.dispatchWorkgroups(1);
  start('compact');
  dispatchBricks(pass, bound, roomsOf(bricks));
  bind(device, pass, stages, 'vertices', { ...bound, span: bound.edgeSpan! });
  pass.dispatchWorkgroupsIndirect(bound.dispatches!.buffer, 0);
  if (stages.creases) encodeCreases(device, pass, stages, bound);
  start('emit');
  pass.dispatchWorkgroupsIndirect(bound.dispatches!.buffer, 12);
  if (stages.creases) {
    start('turned');
    pass.dispatchWorkgroupsIndirect(bound.dispatches!.buffer, 36);
  }
  bind(device, pass, stages, 'vertices', { ...bound, span: bound.middleSpan! });
  pass.dispatchWorkgroupsIndirect(bound.dispatches!.buffer, 24);
}

/** Points on creases: which loops are around some is counted, scanned and listed. */
function encodeCreases(device: GPUDevice, pass: GPUComputePassEncoder, stages: Stages, bound: Bound) {
  const { ringCounts, ringTotals, dispatches } = bound;
  const start = (name: CreaseStageName) => bind(device, pass, stages, name, bound);
  start('countRings');
  pass.dispatchWorkgroups(...groupsOf(Math.ceil(ringCounts!.size / ITEM / 64)));
  stages.scan.encode(pass, ringCounts!, ringTotals!);
  start('planCreases');
  pass.dispatchWorkgroups(1);
  start('listRings');
  pass.dispatchWorkgroupsIndirect(dispatches!.buffer, 12);
  start('creases');
  pass.dispatchWorkgroupsIndirect(dispatches!.buffer, 36);
}

const ALL_STAGES = { ...STAGES, ...CREASE_STAGES };
const EVALUATING: readonly string[] = ['nodes', 'vertices', 'creases'];

function bind(
  device: GPUDevice,
  pass: GPUComputePassEncoder,
  { pipelines, creases }: Stages,
  name: StageName | CreaseStageName,
  bound: Bound,
) {
  const pipeline = { ...pipelines, ...creases }[name]!;
  const group = (index: number, bindings: Readonly<Record<string, number>>) => {
    const entries = Object.entries(bindings).map(([buffer, binding]) => ({
      binding,
      resource: bound[buffer]!,
    }));
    const layout = pipeline.getBindGroupLayout(index);
    pass.setBindGroup(index, device.createBindGroup({ label: name, layout, entries }));
  };
  pass.setPipeline(pipeline);
  group(0, ALL_STAGES[name]);
  if (EVALUATING.includes(name)) group(1, { records: 0, lists: 1 });
}

/** A group a brick: `bricks` of them, or as many as the device has found (src/gpu/bricks). */
function dispatchBricks(pass: GPUComputePassEncoder, { brickGroups }: Bound, bricks: number): void {
  if (brickGroups) pass.dispatchWorkgroupsIndirect(brickGroups.buffer, brickGroups.offset);
  else pass.dispatchWorkgroups(...groupsOf(bricks));
}

/** In rows that no device refuses. */
export function groupsOf(count: number): [x: number, y: number] {
  const rows = Math.max(1, Math.ceil(count / 65535));
  return [Math.ceil(count / rows), rows];
}
