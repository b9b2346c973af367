/** The pipelines that cull bricks, one a file of shaders/bricks; only `cull` is made for the ingredients of a field. */

import { GAUSS, type GaussPoints } from '../../math/gaussLegendre.ts';
import { shapes } from '../../shape/index.ts';
import { MOST_SOURCES, SHARES } from '../../skeleton/gaussSources.ts';
import { type Ingredients, keyOf, namesOf, numberOf } from '../ingredients.ts';
import { compile, link, type Modules } from '../link.ts';
import { choice, constants, imports, shapeCall } from '../modules.ts';
import { modulesOf } from '../polygonize/stages.ts';
import { LARGEST, type Sizes } from './cullsOnDevice.ts';
import { LEVEL } from './levels.ts';
import { CHANGE } from './termBound.ts';

/** Buffers of group 0 by their binding; `cull` has the records in group 1. */
export const BRICK_STAGES = {
  begin: { grid: 3, dispatches: 4, lattice: 8, level: 9 },
  cull: { outer: 0, lists: 1, counters: 2, grid: 3, dispatches: 4, lattice: 8, level: 9 },
  next: { counters: 2, dispatches: 4, lattice: 5, level: 9 },
  count: { grid: 3, runs: 6 },
  number: { lists: 1, grid: 3, runs: 6, level: 9 },
} as const;

export type BrickStage = keyof typeof BRICK_STAGES;
export type BrickStages = Readonly<Record<BrickStage, GPUComputePipeline>>;

const NAMES = Object.keys(BRICK_STAGES) as BrickStage[];

type Load = (ingredients: Ingredients, sizes?: Sizes) => Promise<BrickStages>;
const made = new WeakMap<GPUDevice, Load>();

/** The stages for ingredients and sizes, each compiled once a device. */
export function brickStagesOn(device: GPUDevice): Load {
  const load = made.get(device) ?? loader(device);
  made.set(device, load);
  return load;
}

function loader(device: GPUDevice): Load {
  const known = new Map<string, Promise<BrickStages>>();
  return (ingredients, sizes = LARGEST) => {
    const key = `${sizes.sums}, ${sizes.terms}, ${keyOf(ingredients)}`;
    const stages = known.get(key) ?? loadStages(device, brickModules(ingredients, sizes));
    known.set(key, stages);
    // what failed once is tried again
    stages.catch(() => known.delete(key));
    return stages;
  };
}

async function loadStages(device: GPUDevice, modules: Modules): Promise<BrickStages> {
  const pipelines = NAMES.map(async (name) => {
    const label = `bricks/${name}`;
    const module = await compile(device, label, link(modules, label));
    const compute = { module, entryPoint: name };
    return [name, await device.createComputePipelineAsync({ label, layout: 'auto', compute })] as const;
  });
  return Object.fromEntries(await Promise.all(pipelines)) as Record<BrickStage, GPUComputePipeline>;
}

/** All that the stages import. */
export function brickModules(ingredients: Ingredients, { sums, terms }: Sizes = LARGEST): Modules {
  return {
    ...modulesOf(ingredients),
    'record/level': LEVEL.wgsl,
    'table/sizes': constants('', { MOST_SUMS: sums, MOST_CHOICES: terms / 2 }).join(''),
    'table/change': [...constants('CHANGE_', CHANGE), ...whatThereIs(ingredients)].join(''),
    'table/numbers': ingredientNumbers(),
    shapeRange: shapeRanges(ingredients),
    'table/sources': sourceTables(),
  };
}

/** Software adapters walk through every branch, so that those that are not taken are not there. */
function whatThereIs({ kernels: used, primitives, sections }: Ingredients): readonly string[] {
  const has = {
    GAUSSIAN: used.has('gaussian'),
    QUARTIC: used.has('quartic'),
    SLOPES: used.has('gaussian') || used.has('quartic'),
    INVERSE: used.has('inverse'),
    ANY_POWER: used.has('power'),
    LINES: primitives.has('segment'),
    PLATES: primitives.has('polygon'),
    SECTIONS: sections.size > 0,
  };
  return Object.entries(has).map(([name, is]) => `const HAS_${name} = ${is};\n`);
}

const ingredientNumbers = (): string =>
  constants('', {
    ROUND: numberOf('sections', 'round'),
    POLAR: numberOf('sections', 'polar'),
    HARD_UNION: numberOf('operations', 'hardUnion'),
    SMOOTH_UNION: numberOf('operations', 'smoothUnion'),
    BLEND_UNION: numberOf('operations', 'blendUnion'),
  }).join('');

/** Distances change by what the place does; other shapes say themselves what they may be. */
function shapeRanges(ingredients: Ingredients): string {
  const names = namesOf(ingredients, 'shapes');
  const cases = names.map((name) => {
    if (!shapes[name].exact)
      return [numberOf('shapes', name), shapeCall(name, 'range', ['ball.centre', 'ball.radius'])] as const;
    return [numberOf('shapes', name), `distance_range(shape, ball, ${name !== 'torus'})`] as const;
  });
  const files = names.filter((name) => !shapes[name].exact).map((name) => `${name}Range`);
  const head = 'fn shape_range(shape: Shape, ball: Ball) -> vec2f';
  return `#import bricks/distanceRange\n${imports('shape', files)}${choice(head, 'shape.kind', cases, 'vec2f')}`;
}

/** One to six points, one after the other, as (place, weight) for ∫ from 0 to 1; and what their errors are parts of. */
function sourceTables(): string {
  const counts = Array.from({ length: MOST_SOURCES }, (_, i) => (i + 1) as GaussPoints);
  const rows = counts.flatMap((count) => {
    const { nodes, weights } = GAUSS[count];
    return Array.from(nodes, (node, i) => `vec2f(${0.5 + 0.5 * node}, ${0.5 * weights[i]!})`);
  });
  return [
    `const MOST_SOURCES = ${MOST_SOURCES}u;\n`,
    `const SOURCES = array<vec2f, ${rows.length}>(\n  ${rows.join(',\n  ')},\n);\n`,
    `const SOURCE_SHARES = array<f32, ${SHARES.length}>(${Array.from(SHARES).join(', ')});\n`,
  ].join('');
}
