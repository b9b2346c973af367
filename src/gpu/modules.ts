/**
 * The WGSL that is written here and not in shaders/: structs and constants declared in TypeScript, and the modules that know
 * what takes part in a field. Each of those is one choice among the ingredients, or a direct call where there is one.
 */
import { GAUSS } from '../math/gaussLegendre.ts';
import { bindShape, shapes } from '../shape/index.ts';
import { type Ingredients, type Named, namesOf, numberOf } from './ingredients.ts';
import type { Modules } from './link.ts';
import { ROLE, SIDES, STACK, TAKE } from './program.ts';
import { SHADERS } from './shaders.ts';
import { RECORDS } from './structs.ts';

/** All modules, generated and from files, for fields of these ingredients. */
export function fieldModules(ingredients: Ingredients): Modules {
  const records = Object.entries(RECORDS).map(([name, { wgsl, loader }]) => {
    return [`record/${name}`, `#import field/records\n${wgsl}${loader}`] as const;
  });
  return {
    ...SHADERS,
    ...Object.fromEntries(records),
    'table/gauss': gaussTables(),
    kernel: kernelModule(namesOf(ingredients, 'kernels')),
    skeleton: skeletonModule(namesOf(ingredients, 'primitives')),
    section: sectionModule(namesOf(ingredients, 'sections')),
    // a field without cross sections does not pay for them
    term: `#import field/${ingredients.sections.size > 0 ? 'warpedTerm' : 'plainTerm'}\n`,
    // all terms of a sum, always; who knows which ones matter takes another
    list: '#import field/wholeList\n',
    // how far a skel was, for those who cast rays
    distance: '#import skeleton/unseen\n',
    shape: shapeModule(namesOf(ingredients, 'shapes')),
    shapes: sidedShapes(namesOf(ingredients, 'shapes')),
    operation: operationModule(namesOf(ingredients, 'operations')),
    program: [
      ...constants('TAKE_', TAKE),
      ...constants('ROLE_', ROLE),
      ...constants('', { SIDES, STACK }),
    ].join(''),
  };
}

/** `const TAKE_SUM = 0u;` and so on. */
export const constants = (prefix: string, values: Readonly<Record<string, number>>): string[] =>
  Object.entries(values).map(([name, value]) => `const ${prefix}${name} = ${value}u;\n`);

/** (node, weight) for ∫ from 0 to 1. */
function gaussTables(): string {
  const tables = Object.entries(GAUSS).map(([count, { nodes, weights }]) => {
    const rows = Array.from(nodes, (node, i) => `vec2f(${0.5 + 0.5 * node}, ${0.5 * weights[i]!})`);
    return `const GAUSS_${count} = array<vec2f, ${count}>(\n  ${rows.join(',\n  ')},\n);\n`;
  });
  return tables.join('');
}

function kernelModule(names: readonly Named<'kernels'>[]): string {
  const dispatch = (head: string, type: string, call: string) => {
    const cases = names.map((name) => [numberOf('kernels', name), `${snakeCase(name)}${call}`] as const);
    return choice(`${head} -> ${type}`, 'kernel', cases, type);
  };
  return [
    imports('kernel', ['frame', ...names]),
    dispatch('fn kernel_value(kernel: u32, r2: f32, exponent: f32)', 'vec2f', '_value(r2, exponent)'),
    dispatch('fn kernel_line(kernel: u32, f: LineFrame)', 'vec3f', '_line(f)'),
    dispatch('fn kernel_edge(kernel: u32, f: EdgeFrame)', 'vec3f', '_edge(f)'),
  ].join('');
}

function skeletonModule(names: readonly Named<'primitives'>[]): string {
  const cases = names.map((name) => [numberOf('primitives', name), `${name}_field(kernel, at, p)`] as const);
  const head = 'fn skel_field(primitive: u32, kernel: u32, at: u32, p: vec3f) -> vec4f';
  return imports('skeleton', names) + choice(head, 'primitive', cases, 'vec4f');
}

/** File and call of each section. */
const SECTIONS: Readonly<Record<Named<'sections'>, readonly [file: string | null, call: string]>> = {
  round: [null, 'vec3f(1.0, 0.0, 0.0)'],
  superQuadric: ['superQuadric', 'super_quadric(q, warp.exponent)'],
  extrusion: ['extrusion', 'extrusion(q, warp.exponent)'],
  polar: ['polarProfile', 'polar_profile(q, warp.profile)'],
};

function sectionModule(names: readonly Named<'sections'>[]): string {
  const files = names.flatMap((name) => SECTIONS[name][0] ?? []);
  const cases = names.map((name) => [numberOf('sections', name), SECTIONS[name][1]] as const);
  const head = 'fn section_stretch(section: u32, q: vec2f, warp: Warp) -> vec3f';
  return `#import record/warp\n${imports('field', files)}${choice(head, 'section', cases, 'vec3f')}`;
}

/** The numbers of a shape's record, in their order. */
const LANES = ['a', 'b', 'c'].flatMap((four) => [...'xyzw'].map((lane) => `shape.${four}.${lane}`));

function shapeModule(names: readonly Named<'shapes'>[]): string {
  const head = 'fn shape_field(shape: Shape, p: vec3f) -> vec4f';
  const cases = names.map((name) => [numberOf('shapes', name), shapeCall(name, 'field')] as const);
  return `#import record/shape\n${imports('shape', names)}${choice(head, 'shape.kind', cases, 'vec4f')}`;
}

/** Shapes whose sides are told apart (shaders/field/sides.wgsl). */
function sidedShapes(names: readonly Named<'shapes'>[]): string {
  const sided = names.filter((name) => bindShape(shapes[name].examples[0]!).facets);
  const calls = (among: typeof names, call: string, ...last: string[]) =>
    among.map((name) => [numberOf('shapes', name), shapeCall(name, call, ['p'], last)] as const);
  const make = (head: string, type: string, cases: ReturnType<typeof calls>) =>
    choice(`fn ${head} -> ${type}`, 'shape.kind', cases, type);
  return [
    `#import record/shape\n${imports('shape', names)}`,
    make('whole_shape(shape: Shape, p: vec3f)', 'vec4f', calls(names, 'field')),
    make('shape_side(shape: Shape, p: vec3f)', 'u32', calls(sided, 'side')),
    make('shape_on_side(shape: Shape, p: vec3f, side: u32)', 'vec4f', calls(sided, 'on_side', 'side')),
  ].join('');
}

/** `sphere_field(p, shape.a.x)` and so on. */
export function shapeCall(
  name: Named<'shapes'>,
  what: string,
  first: readonly string[] = ['p'],
  last: readonly string[] = [],
): string {
  const lanes = [...LANES];
  const numbers = shapes[name].takes.map((type) =>
    type === 'f32' ? lanes.shift() : `vec3f(${lanes.splice(0, 3).join(', ')})`,
  );
  return `${snakeCase(name)}_${what}(${[...first, ...numbers, ...last].join(', ')})`;
}

const OPERATIONS: Readonly<Record<Named<'operations'>, string>> = {
  hardUnion: 'hard_union(a, b)',
  smoothUnion: 'smooth_union(a, b)',
  blendUnion: 'blend_union(a, b, amounts.x, amounts.y, amounts.z)',
  morph: 'morph(a, b, amounts.x)',
};

function operationModule(names: readonly Named<'operations'>[]): string {
  const cases = names.map((name) => [numberOf('operations', name), OPERATIONS[name]] as const);
  const head = 'fn operation(number: u32, a: f32, b: f32, amounts: vec3f) -> vec3f';
  return imports('field', names) + choice(head, 'number', cases, 'vec3f');
}

export const imports = (folder: string, names: readonly string[]): string =>
  names.map((name) => `#import ${folder}/${name}\n`).join('');

/** `inverseSquared` is inverse_squared in WGSL. */
const snakeCase = (name: string): string => name.replace(/[A-Z]/g, (letter) => `_${letter.toLowerCase()}`);

/** A function that makes the call whose number `of` is. */
export function choice(
  head: string,
  of: string,
  cases: readonly (readonly [number: number, call: string])[],
  type: string,
): string {
  if (cases.length === 0) return `${head} {\n  return ${type}(0.0);\n}\n`;
  if (cases.length === 1) return `${head} {\n  return ${cases[0]![1]};\n}\n`;
  const branches = cases.map(([number, call]) => `    case ${number}u: { return ${call}; }\n`);
  return `${head} {\n  switch ${of} {\n${branches.join('')}    default: { return ${type}(0.0); }\n  }\n}\n`;
}
