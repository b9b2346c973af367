/**
 * Meshes of a body that is being edited: its lists and values stay on the device, and of an edit only what it made anew is written and evaluated
 * (liveLists.ts); the mesh is made of all values each time.
 */
import type { Lattice } from '../../field/lattice.ts';
import type { FieldNode } from '../../field/node.ts';
import type { PackedBricks, PackedEdit } from '../../field/packedBricks.ts';
import { type Ingredients, keyOf } from '../ingredients.ts';
import type { Modules } from '../link.ts';
import { type Program, programOf } from '../program.ts';
import { SHADERS } from '../shaders.ts';
import { Buffers, type Slice, USAGE } from './buffers.ts';
import { type Bound, groupsOf, NODES, putLattice } from './encode.ts';
import type { Capacity, GpuMesh } from './gpuMesh.ts';
import { type Dirty, LiveLists, type Write } from './liveLists.ts';
import type { GpuPolygonizer } from './polygonizer.ts';
import { loadStage, modulesOf } from './stages.ts';

/** Where the stages that are run for some bricks only have their buffers. */
const STAGES = {
  nodes: [
    { grid: 0, values: 1, evaluated: 5, lattice: 8 },
    { records: 0, lists: 1 },
  ],
  share: [{ grid: 0, values: 1, lists: 2, shared: 5, lattice: 8 }],
} as const;

type Name = keyof typeof STAGES;
type Pipelines = Readonly<Record<Name, GPUComputePipeline>>;

export interface LivePolygonizer {
  /** All bricks of a tree, whatever was there before. */
  whole(node: FieldNode, bricks: PackedBricks): Promise<GpuMesh>;
  /** What followed, one after the other, up to that tree. Rejects where there are no bricks that they could be edits of. */
  edit(node: FieldNode, edits: readonly PackedEdit[]): Promise<GpuMesh>;
  /** Of the last mesh: bricks whose nodes were evaluated. */
  readonly evaluated: number;
  destroy(): void;
}

interface State {
  readonly lists: LiveLists;
  readonly hasCreases: boolean;
  readonly lattice: Lattice;
}

/** `polygonizer` makes the meshes; both have buffers of their own. */
export function livePolygonizer(device: GPUDevice, polygonizer: GpuPolygonizer): LivePolygonizer {
  return new Live(device, polygonizer);
}

class Live implements LivePolygonizer {
  evaluated = 0;
  readonly #device: GPUDevice;
  readonly #polygonizer: GpuPolygonizer;
  readonly #buffers: Buffers;
  readonly #known = new Map<string, Promise<Pipelines>>();
  #state: State | null = null;

  constructor(device: GPUDevice, polygonizer: GpuPolygonizer) {
    this.#device = device;
    this.#polygonizer = polygonizer;
    this.#buffers = new Buffers(device);
  }

  async whole(node: FieldNode, bricks: PackedBricks): Promise<GpuMesh> {
    const { lattice, hasCreases } = bricks;
    const state = { lists: new LiveLists(bricks), lattice, hasCreases };
    return this.#made(node, state, () => [state.lists.whole]);
  }

  async edit(node: FieldNode, edits: readonly PackedEdit[]): Promise<GpuMesh> {
    const state = this.#state;
    if (!state) throw new Error('there are no bricks to be edited');
    const { hasCreases } = edits.at(-1) ?? state;
    return this.#made(node, { ...state, hasCreases }, () => edits.map((edit) => state.lists.edit(edit)));
  }

  destroy(): void {
    this.#state = null;
    this.#buffers.destroy();
  }

  /** What fails half-way leaves nothing that could be edited. */
  async #made(node: FieldNode, state: State, follow: () => readonly Dirty[]): Promise<GpuMesh> {
    this.#state = null;
    const program = programOf(node);
    const pipelines = await this.#pipelines(program.ingredients);
    let open: readonly Dirty[] = follow();
    this.evaluated = 0;
    const { lists, hasCreases } = state;
    const bricks = { count: lists.count, hasCreases };
    const mesh = await this.#polygonizer.meshOf(program, bricks, (pass, _, room) => {
      const bound = this.#upload(program, state, open, room);
      for (const dirty of merged(open, lists.count)) this.#evaluate(pass, pipelines, bound, dirty);
      // a mesh that does not fit is made again of the same values
      open = [];
      return bound;
    });
    this.#state = state;
    return mesh;
  }

  #upload(program: Program, { lists, lattice }: State, open: readonly Dirty[], room: Capacity): Bound {
    const { slots, rows } = lists.room;
    const buffers = this.#buffers;
    const written = USAGE.storage | USAGE.copyTarget;
    const bricks = lattice.counts.reduce((product, nodes) => (product * (nodes - 1)) / 4, 1);
    const targets = {
      lists: buffers.get('lists', 16 * rows, written),
      grid: buffers.get('grid', 4 * bricks, written),
    };
    for (const { writes } of open) for (const write of writes) this.#write(targets[write.buffer], write);
    const values = buffers.get('values', 4 * NODES * slots, USAGE.storage | USAGE.copySource);
    return {
      ...targets,
      values,
      records: buffers.put('records', program.records, USAGE.storage),
      lattice: putLattice(buffers, lattice, lists.count, room),
    };
  }

  #write({ buffer }: Slice, { at, words }: Write): void {
    this.#device.queue.writeBuffer(buffer, 4 * at, words);
  }

  #evaluate(pass: GPUComputePassEncoder, pipelines: Pipelines, bound: Bound, dirty: Chosen): void {
    this.evaluated += dirty.evaluated.length;
    for (const [name, chosen] of [
      ['nodes', 'evaluated'],
      ['share', 'shared'],
    ] as const) {
      const slots = dirty[chosen];
      if (slots.length === 0) continue;
      const own = { ...bound, [chosen]: this.#buffers.put(chosen, slots, USAGE.storage) };
      pass.setPipeline(pipelines[name]);
      STAGES[name].forEach((bindings, index) => {
        const layout = pipelines[name].getBindGroupLayout(index);
        pass.setBindGroup(
          index,
          this.#device.createBindGroup({ label: name, layout, entries: entriesOf(bindings, own) }),
        );
      });
      pass.dispatchWorkgroups(...groupsOf(slots.length));
    }
  }

  #pipelines(ingredients: Ingredients): Promise<Pipelines> {
    const key = keyOf(ingredients);
    const known = this.#known.get(key) ?? pipelinesOn(this.#device, modulesOf(ingredients));
    this.#known.set(key, known);
    // what failed once is tried again
    known.catch(() => this.#known.delete(key));
    return known;
  }
}

type Chosen = Pick<Dirty, 'evaluated' | 'shared'>;

/** All that several edits want, once. Slots that are there no more are nobody's. */
function merged(open: readonly Dirty[], count: number): readonly Chosen[] {
  if (open.length === 0) return [];
  const all = (of: keyof Chosen) => {
    const slots = new Set(open.flatMap((dirty) => [...dirty[of]]));
    return Uint32Array.from([...slots].filter((slot) => slot < count));
  };
  return [{ evaluated: all('evaluated'), shared: all('shared') }];
}

function entriesOf(bindings: Readonly<Record<string, number>>, bound: Bound): GPUBindGroupEntry[] {
  return Object.entries(bindings).map(([name, binding]) => ({ binding, resource: bound[name]! }));
}

async function pipelinesOn(device: GPUDevice, modules: Modules): Promise<Pipelines> {
  const own = { ...SHADERS, ...modules, bricks: '#import polygonize/chosenBrick\n' };
  const [nodes, share] = await Promise.all([
    loadStage(device, own, 'nodes'),
    loadStage(device, own, 'share'),
  ]);
  return { nodes: nodes[1], share: share[1] };
}
