/**
 * Culling on the device: cubes of eight bricks, all of them against all terms, then their eighths, down to bricks, each with its lists;
 * last the bricks in the order of the grid. What is written is what uploadField uploads, and how many bricks there are stays there too.
 *
 * Theory: Kravtsov's five steps (§1.3.1) sample the whole volume; here their scan and compaction serve cubes. Departure from field/bricks.ts:
 * no octree from the root, whose first levels have fewer cubes than a device has threads.
 */
import type { Lattice } from '../../field/lattice.ts';
import { type Buffers, type Slice, USAGE } from '../polygonize/buffers.ts';
import { type Bound, groupsOf, latticeBuffers } from '../polygonize/encode.ts';
import type { Capacity } from '../polygonize/gpuMesh.ts';
import { ITEM, type Scan, totalsOf } from '../scan.ts';
import type { BoundedProgram } from './bounds.ts';
import { alongOf, type LevelRoom, levelsOf, ROW, SIZES } from './levels.ts';
import { BRICK_STAGES, type BrickStage, type BrickStages } from './stages.ts';

/** bricks that one thread puts into order */
const RUN = 16;
/** cubes of a group, a thread each */
const GROUP = 32;
const LAST = SIZES.length - 1;

/** What of a tree is culled where. */
export interface Culling {
  readonly lattice: Lattice;
  readonly stages: BrickStages;
  readonly bounded: BoundedProgram;
  /** of each level */
  readonly rooms: readonly LevelRoom[];
}

/** `counters`: two zeros a level. Returns what the later stages read. RangeError for more than every device binds. */
export function encodeCulling(
  device: GPUDevice,
  pass: GPUComputePassEncoder,
  scan: Scan,
  buffers: Buffers,
  { lattice, stages, bounded, rooms }: Culling,
  room: Capacity,
  counters: Slice,
): Bound {
  const { records, leaves } = bounded;
  const ground = latticeBuffers(buffers, lattice, rooms[LAST]!.cubes, room);
  const levels = levelsOf(lattice, rooms, leaves);
  const [x, y, z] = alongOf(lattice, 1);
  const runs = Math.ceil((x * y * z) / RUN);
  const lists = levels.map(({ rows }, depth) =>
    buffers.get(depth === LAST ? 'lists' : `lists ${depth}`, ROW * rows, USAGE.storage | USAGE.copySource),
  );
  const shared = {
    ...ground,
    counters,
    records: buffers.put('records', records, USAGE.storage),
    grid: buffers.get('grid', 4 * x * y * z, USAGE.storage | USAGE.copySource),
    dispatches: buffers.get('brick groups', ROW * (SIZES.length + 1), USAGE.storage | USAGE.indirect),
    runs: buffers.get('brick runs', ITEM * runs, USAGE.storage),
  };
  const totals = buffers.get('brick totals', ITEM * totalsOf(runs), USAGE.storage);
  const uniform = levels.map(({ bytes }, depth) => buffers.put(`level ${depth}`, bytes, USAGE.uniform));
  const start = (name: BrickStage, depth: number) => {
    // the first level looks at nothing above
    const around = {
      outer: lists[depth - 1] ?? shared.records,
      lists: lists[depth]!,
      level: uniform[depth]!,
    };
    bind(device, pass, stages, name, { ...shared, ...around });
  };
  start('begin', 0);
  pass.dispatchWorkgroups(Math.min(Math.ceil((x * y * z) / 64), 65535));
  for (let depth = 0; depth <= LAST; depth++) {
    start('cull', depth);
    const [cx, cy, cz] = alongOf(lattice, SIZES[depth]!);
    if (depth === 0) pass.dispatchWorkgroups(...groupsOf(Math.ceil((cx * cy * cz) / GROUP)));
    else pass.dispatchWorkgroupsIndirect(shared.dispatches.buffer, ROW * depth);
    start('next', depth);
    pass.dispatchWorkgroups(1);
  }
  start('count', LAST);
  pass.dispatchWorkgroups(Math.ceil(runs / 64));
  scan.encode(pass, shared.runs, totals);
  start('number', LAST);
  pass.dispatchWorkgroups(Math.ceil(runs / 64));
  const brickGroups = { ...shared.dispatches, offset: ROW * SIZES.length };
  const { records: own, grid } = shared;
  return { ...ground, records: own, grid, lists: lists[LAST]!, brickGroups };
}

function bind(
  device: GPUDevice,
  pass: GPUComputePassEncoder,
  stages: BrickStages,
  name: BrickStage,
  bound: Readonly<Record<string, Slice>>,
) {
  const pipeline = stages[name];
  const group = (index: number, bindings: Readonly<Record<string, number>>) => {
    const entries = Object.entries(bindings).map(([buffer, binding]) => ({
      binding,
      resource: bound[buffer]!,
    }));
    const layout = pipeline.getBindGroupLayout(index);
    pass.setBindGroup(index, device.createBindGroup({ label: name, layout, entries }));
  };
  pass.setPipeline(pipeline);
  group(0, BRICK_STAGES[name]);
  if (name === 'cull') group(1, { records: 0 });
}
