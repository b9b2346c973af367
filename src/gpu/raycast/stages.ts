/** The pipelines of the ray-caster; only `cast` is made for the ingredients of a field, the others' modules are the same for all. */
import { record } from '../../math/record.ts';
import { type ShapeName, shapes } from '../../shape/index.ts';
import { brickModules } from '../bricks/stages.ts';
import { type Ingredients, keyOf, namesOf, numberOf } from '../ingredients.ts';
import { compile, link, type Modules } from '../link.ts';
import { choice } from '../modules.ts';
import { SHADERS } from '../shaders.ts';

/** What is looked at, and from where. */
export const RAY_CAMERA = record('RayCamera', {
  pivot: 'vec3f',
  /** mm of a pixel at the pivot */
  pixel: 'f32',
  right: 'vec3f',
  /** from the eye to the pivot, mm; 0: orthographic */
  distance: 'f32',
  up: 'vec3f',
  /** of the lattice: its longest side, mm */
  size: 'f32',
  back: 'vec3f',
  /** of the records: where leaves begin */
  leaves: 'u32',
  /** pixels */
  picture: 'vec2u',
  offset: 'vec2f',
  /** of all the body, where it has one colour; the fourth 1 then, else 0 */
  colour: 'vec4f',
  /** pixels that are cast: from … to before …, to the right and down */
  first: 'vec2u',
  end: 'vec2u',
  /** from the body's frame into the model's */
  turn: 'mat3x3f',
  /** pixels from row to row */
  stride: 'u32',
  /** the fourth of the colours where the body is seen */
  number: 'f32',
});

/** Buffers of group 0 by their binding; `cast` has records and lists in group 1. */
export const RAY_STAGES = {
  clear: { surface: 2, colours: 3, camera: 9 },
  blocks: { grid: 0, blocks: 1, lattice: 8 },
  cast: { grid: 0, blocks: 1, surface: 2, colours: 3, work: 4, lattice: 8, camera: 9 },
} as const;

export interface RayStages {
  readonly blocks: GPUComputePipeline;
  readonly cast: GPUComputePipeline;
}

type Load = (ingredients: Ingredients) => Promise<RayStages>;
const made = new WeakMap<GPUDevice, Load>();

/** The stages for ingredients, each compiled once a device. */
export function rayStagesOn(device: GPUDevice): Load {
  const load = made.get(device) ?? loader(device);
  made.set(device, load);
  return load;
}

function loader(device: GPUDevice): Load {
  const known = new Map<string, Promise<RayStages>>();
  return (ingredients) => {
    const key = keyOf(ingredients);
    const stages = known.get(key) ?? loadStages(device, rayModules(ingredients));
    known.set(key, stages);
    // what failed once is tried again
    stages.catch(() => known.delete(key));
    return stages;
  };
}

async function loadStages(device: GPUDevice, modules: Modules): Promise<RayStages> {
  const [blocks, cast] = await Promise.all([
    loadStage(device, modules, 'blocks', 'blocks_of_bricks'),
    loadStage(device, modules, 'cast', 'cast_pixels'),
  ]);
  return { blocks, cast };
}

async function loadStage(device: GPUDevice, modules: Modules, name: string, entryPoint: string) {
  const label = `raycast/${name}`;
  const module = await compile(device, label, link(modules, label));
  return device.createComputePipelineAsync({ label, layout: 'auto', compute: { module, entryPoint } });
}

/** What empties a picture, whatever comes into it. */
export const loadClear = (device: GPUDevice): Promise<GPUComputePipeline> =>
  loadStage(device, { ...SHADERS, 'record/rayCamera': RAY_CAMERA.wgsl }, 'clear', 'clear_pixels');

/** All that the stages import. */
const rayModules = (ingredients: Ingredients): Modules => ({
  ...brickModules(ingredients),
  distance: '#import raycast/distance\n',
  isDistance: `${shapesThat('is_distance', ingredients, isDistance)}${shapesThat('is_convex', ingredients, isConvex)}`,
  'record/rayCamera': RAY_CAMERA.wgsl,
});

/** Whether it is as far away as its value says. */
const isDistance = (name: ShapeName): boolean => shapes[name].exact;

/** Whether minus its value is a convex function. */
export const isConvex = (name: ShapeName): boolean => isDistance(name) && name !== 'torus';

function shapesThat(named: string, ingredients: Ingredients, are: (name: ShapeName) => boolean): string {
  const cases = namesOf(ingredients, 'shapes').map(
    (name) => [numberOf('shapes', name), String(are(name))] as const,
  );
  return choice(`fn ${named}(kind: u32) -> bool`, 'kind', cases, 'bool');
}
