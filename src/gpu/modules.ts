/**
 * The WGSL that is written here and not in shaders/: structs and tables declared in TypeScript, and the two modules that
 * know which kernels and skeletons take part. With one kernel `kernel` is a direct call, with several a switch, so
 * that a field may mix them.
 */
import { kernels } from '../kernel/index.ts';
import { GAUSS } from '../math/gaussLegendre.ts';
import type { Modules } from './link.ts';
import { SHADERS } from './shaders.ts';
import { EDGE, POINT, POLYGON, PRIMITIVES, type Primitive, SEGMENT } from './structs.ts';

/** What a pipeline is made for. */
export interface Ingredients {
  /** names, as in the registry */
  readonly kernels: readonly string[];
  readonly primitives: readonly Primitive[];
}

/** All modules, generated and from files, for fields of these kernels and primitives. */
export function fieldModules(ingredients: Ingredients): Modules {
  return {
    ...SHADERS,
    'record/point': POINT.wgsl,
    'record/segment': SEGMENT.wgsl,
    'record/polygon': POLYGON.wgsl,
    'record/edge': EDGE.wgsl,
    'table/gauss': gaussTables(),
    kernel: kernelModule(ingredients.kernels),
    skeleton: skeletonModule(ingredients.primitives),
  };
}

/** (node, weight) for ∫ from 0 to 1. */
function gaussTables(): string {
  const tables = Object.entries(GAUSS).map(([count, { nodes, weights }]) => {
    const rows = Array.from(nodes, (node, i) => `vec2f(${0.5 + 0.5 * node}, ${0.5 * weights[i]!})`);
    return `const GAUSS_${count} = array<vec2f, ${count}>(\n  ${rows.join(',\n  ')},\n);\n`;
  });
  return tables.join('');
}

function kernelModule(names: readonly string[]): string {
  const imports = ['frame', ...names].map((name) => `#import kernel/${name}\n`);
  return [
    ...imports,
    dispatch('kernel_value', 'r2: f32, exponent: f32', 'vec2f', names, '_value(r2, exponent)'),
    dispatch('kernel_line', 'f: LineFrame', 'vec3f', names, '_line(f)'),
    dispatch('kernel_edge', 'f: EdgeFrame', 'vec3f', names, '_edge(f)'),
  ].join('');
}

function dispatch(
  name: string,
  params: string,
  type: string,
  names: readonly string[],
  call: string,
): string {
  const cases = names.map((kernel) => [`case ${numberOf(kernel)}u`, `${snakeCase(kernel)}${call}`] as const);
  return `fn ${name}(kernel: u32, ${params}) -> ${type} {\n${choice('kernel', cases, type)}}\n`;
}

const numberOf = (name: string): number => kernels.findIndex((kernel) => kernel.name === name);

/** `inverseSquared` is inverse_squared in WGSL. */
const snakeCase = (name: string): string => name.replace(/[A-Z]/g, (letter) => `_${letter.toLowerCase()}`);

function skeletonModule(primitives: readonly Primitive[]): string {
  const cases = primitives.map(
    (name) => [`case ${PRIMITIVES.indexOf(name)}u`, `${name}_field(skel >> 2u, p)`] as const,
  );
  return [
    ...primitives.map((name) => `#import skeleton/${name}\n`),
    '// which primitive in the lowest two bits, which of its records above\n',
    '@group(1) @binding(0) var<storage, read> skels: array<u32>;\n',
    `fn skel_field(skel: u32, p: vec3f) -> vec4f {\n${choice('skel & 3u', cases, 'vec4f')}}\n`,
  ].join('');
}

function choice(
  of: string,
  cases: readonly (readonly [label: string, call: string])[],
  type: string,
): string {
  if (cases.length === 1) return `  return ${cases[0]![1]};\n`;
  const branches = cases.map(([label, call]) => `    ${label}: { return ${call}; }\n`);
  return `  switch ${of} {\n${branches.join('')}    default: { return ${type}(0.0); }\n  }\n`;
}
