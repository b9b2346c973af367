/**
 * The stages one after the other: nodes → share → classify → number → scan → plan → compact → vertices on edges → emit → vertices in
 * the middle of loops. How many vertices and cells there are only the device knows: it plans its own dispatches and the draw
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
import { LATTICE, STAGES, type StageName, type Stages } from './stages.ts';

/** By the names that STAGES binds. */
export type Bound = Readonly<Record<string, Slice>> & {
  readonly brickGroups?: Slice & { readonly offset: number };
};

/** Per brick: 128 places for nodes, 64 cells. */
const NODES = 128;
const CELLS = 64;
const LOOPS = loopTable();
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
export function latticeBuffers(
  buffers: Buffers,
  { origin, step, counts }: Lattice,
  bricks: number,
  room: Capacity,
): Bound {
  const along = counts.map((nodes) => (nodes - 1) / 4);
  if (!along.every((number) => Number.isInteger(number) && number >= 1 && number <= MOST_ALONG))
    throw new RangeError(`a lattice of ${counts.join(' × ')} nodes has no bricks of four cells`);
  const capacities = [room.vertices, 3 * room.triangles, cellsOf(room), 0];
  const header = LATTICE.pack([{ origin, step, bricks: [...along, bricks], capacities }]);
  return {
    lattice: buffers.put('lattice', header, USAGE.uniform | USAGE.storage),
    values: buffers.get('values', 4 * NODES * roomsOf(bricks), USAGE.storage | USAGE.copySource),
  };
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
    dispatches: buffers.get('dispatches', 36, USAGE.storage | USAGE.indirect),
    edgeSpan: buffers.get('edgeSpan', 16, USAGE.storage | USAGE.uniform),
    middleSpan: buffers.get('middleSpan', 16, USAGE.storage | USAGE.uniform),
    vertexEdges: buffers.get('vertexEdges', 4 * room.vertices, USAGE.storage),
    crossedCells: buffers.get('crossedCells', 16 * cellsOf(room), USAGE.storage),
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
  const start = (name: StageName) => bind(device, pass, stages, name, bound);
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
  start('emit');
  pass.dispatchWorkgroupsIndirect(bound.dispatches!.buffer, 12);
  bind(device, pass, stages, 'vertices', { ...bound, span: bound.middleSpan! });
  pass.dispatchWorkgroupsIndirect(bound.dispatches!.buffer, 24);
}

function bind(
  device: GPUDevice,
  pass: GPUComputePassEncoder,
  { pipelines }: Stages,
  name: StageName,
  bound: Bound,
) {
  const pipeline = pipelines[name];
  const group = (index: number, bindings: Readonly<Record<string, number>>) => {
    const entries = Object.entries(bindings).map(([buffer, binding]) => ({
      binding,
      resource: bound[buffer]!,
    }));
    const layout = pipeline.getBindGroupLayout(index);
    pass.setBindGroup(index, device.createBindGroup({ label: name, layout, entries }));
  };
  pass.setPipeline(pipeline);
  group(0, STAGES[name]);
  if (name === 'nodes' || name === 'vertices') group(1, { records: 0, lists: 1 });
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
