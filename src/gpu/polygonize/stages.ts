/**
 * The compute pipelines of the polygonizer, one a file of shaders/polygonize. Those that evaluate the field are made for its
 * ingredients, the others once a device.
 */
import { record } from '../../math/record.ts';
import { type Ingredients, keyOf } from '../ingredients.ts';
import { compile, link, type Modules } from '../link.ts';
import { constants, fieldModules } from '../modules.ts';
import { loadScan, type Scan } from '../scan.ts';
import { SHADERS } from '../shaders.ts';
import { ENTRY } from './lists.ts';
import { loopModule } from './loopTable.ts';

/** What all stages know. */
export const LATTICE = record('Lattice', {
  origin: 'vec3f',
  step: 'f32',
  /** along x, y, z; active ones */
  bricks: 'vec4u',
  /** vertices, indices, crossed cells */
  capacities: 'vec4u',
});

/** Group 0 of each stage: buffers by their binding. Group 1 of those that evaluate: the records and the lists. */
export const STAGES = {
  nodes: { grid: 0, values: 1, lattice: 8 },
  share: { grid: 0, values: 1, lists: 2, lattice: 8 },
  classify: { grid: 0, values: 1, lists: 2, crossings: 3, cells: 4, lattice: 8, loops: 9 },
  number: { crossings: 1, cells: 2, counts: 3, lattice: 8, loops: 9 },
  plan: { totals: 0, state: 1, dispatches: 2, draw: 3, edgeSpan: 4, middleSpan: 5, lattice: 8 },
  compact: {
    counts: 1,
    cells: 2,
    crossings: 3,
    vertexEdges: 4,
    crossedCells: 5,
    lattice: 8,
    loops: 9,
    state: 10,
  },
  vertices: { values: 1, vertexEdges: 2, positions: 3, normals: 4, colours: 5, lattice: 8, span: 10 },
  emit: {
    grid: 0,
    crossedCells: 1,
    crossings: 2,
    lists: 3,
    positions: 4,
    normals: 5,
    colours: 6,
    indices: 7,
    lattice: 8,
    loops: 9,
    state: 10,
  },
} as const;

export type StageName = keyof typeof STAGES;
const PLAIN = ['share', 'classify', 'number', 'plan', 'compact', 'emit'] as const;

/**
 * Of fields with creases, after the vertices on edges: points on creases, and the triangles around them (files and entry points, and
 * bindings as above).
 */
export const CREASE_STAGES = {
  countRings: {
    ...{ grid: 0, crossedCells: 1, crossings: 2, lists: 3, normals: 4, ringCounts: 5 },
    ...{ lattice: 8, loops: 9, state: 10 },
  },
  planCreases: { ringTotals: 0, state: 1, dispatches: 2, draw: 3, lattice: 8 },
  listRings: {
    ...{ grid: 0, crossedCells: 1, crossings: 2, lists: 3, normals: 4, ringCounts: 5, creasedLoops: 6 },
    ...{ lattice: 8, loops: 9, state: 10 },
  },
  creases: { creasedLoops: 1, positions: 2, normals: 3, colours: 4, lattice: 8, state: 10 },
  turned: {
    ...{ grid: 0, creasedLoops: 1, cells: 2, counts: 3, ringCounts: 4, normals: 5, lists: 6, indices: 7 },
    ...{ lattice: 8, loops: 9, state: 10 },
  },
} as const;

export type CreaseStageName = keyof typeof CREASE_STAGES;
const CREASE_NAMES = Object.keys(CREASE_STAGES) as CreaseStageName[];
const RINGS: Readonly<Partial<Record<CreaseStageName, string>>> = {
  countRings: 'count_rings',
  listRings: 'list_rings',
};

type Pipelines<Name extends string> = Readonly<Record<Name, GPUComputePipeline>>;

export interface Stages {
  readonly pipelines: Pipelines<StageName>;
  /** null for fields without creases */
  readonly creases: Pipelines<CreaseStageName> | null;
  readonly scan: Scan;
}

type Load = (ingredients: Ingredients, hasCreases?: boolean) => Promise<Stages>;

const made = new WeakMap<GPUDevice, Load>();

/** The stages for ingredients, each compiled once a device. `changed`: modules that stand in for others, for those who ask alone. */
export function stagesOn(device: GPUDevice, changed: Modules | null = null): Load {
  if (changed) return loader(device, changed);
  const load = made.get(device) ?? loader(device, {});
  made.set(device, load);
  return load;
}

function loader(device: GPUDevice, changed: Modules): Load {
  const known = new Map<string, Promise<Stages>>();
  // with creases or without, the same
  const nodes = new Map<string, Pipeline<'nodes'>>();
  let plain: Promise<Plain> | null = null;
  return (ingredients, hasCreases = false) => {
    const names = keyOf(ingredients);
    const key = `${names}, ${hasCreases ? 'creases' : 'smooth'}`;
    plain ??= loadPlain(device);
    const modules = { ...modulesOf(ingredients), ...changed };
    const ofNodes = nodes.get(names) ?? loadStage(device, modules, 'nodes');
    nodes.set(names, ofNodes);
    const stages = known.get(key) ?? loadStages(device, plain, ofNodes, modules, hasCreases);
    known.set(key, stages);
    // what failed once is tried again
    stages.catch(() => {
      known.delete(key);
      nodes.delete(names);
      plain = null;
    });
    return stages;
  };
}

/** All that the stages import. */
export function modulesOf(ingredients: Ingredients): Modules {
  const near = { near: '#import polygonize/near\n', list: '#import polygonize/nearList\n' };
  return { ...fieldModules(ingredients), ...TABLES, ...near };
}

/** In place of some of these: fields whose values know their branch. */
export const CREASED: Modules = {
  near: '#import polygonize/nearBranches\n',
  shape: '#import field/sides\n',
};

const TABLES: Modules = {
  bricks: '#import polygonize/eachBrick\n',
  'record/lattice': LATTICE.wgsl,
  'table/entries': constants('', ENTRY).join(''),
  'table/loops': loopModule(),
};

type Pipeline<Name extends StageName> = Promise<readonly [Name, GPUComputePipeline]>;
type Plain = readonly [Scan, readonly (readonly [StageName, GPUComputePipeline])[]];

async function loadPlain(device: GPUDevice): Promise<Plain> {
  const modules = { ...SHADERS, ...TABLES };
  return Promise.all([loadScan(device), Promise.all(PLAIN.map((name) => loadStage(device, modules, name)))]);
}

async function loadStages(
  device: GPUDevice,
  plain: Promise<Plain>,
  nodes: Pipeline<'nodes'>,
  modules: Modules,
  hasCreases: boolean,
): Promise<Stages> {
  const creased = hasCreases ? { ...modules, ...CREASED } : modules;
  const [[scan, others], ofNodes, vertices, creases] = await Promise.all([
    plain,
    nodes,
    loadStage(device, creased, 'vertices'),
    hasCreases ? Promise.all(CREASE_NAMES.map((name) => loadStage(device, creased, name))) : null,
  ]);
  const pipelines = Object.fromEntries([...others, ofNodes, vertices]) as Pipelines<StageName>;
  return {
    pipelines,
    creases: creases && (Object.fromEntries(creases) as Pipelines<CreaseStageName>),
    scan,
  };
}

/** One of them by its name. */
export async function loadStage<Name extends StageName | CreaseStageName>(
  device: GPUDevice,
  modules: Modules,
  name: Name,
) {
  const entryPoint = RINGS[name as CreaseStageName];
  const label = `polygonize/${entryPoint ? 'rings' : name}`;
  const module = await compile(device, label, link(modules, label));
  const pipeline = await device.createComputePipelineAsync({
    label,
    layout: 'auto',
    compute: { module, entryPoint: entryPoint ?? name },
  });
  return [name, pipeline] as const;
}
