import { afterAll, expect, it } from 'vitest';
import { Heap } from '../../src/gpu/heap.ts';
import { PROGRAM, RECORDS } from '../../src/gpu/structs.ts';
import { record } from '../../src/math/record.ts';
import { compute, withDevice } from './compute.ts';
import { closeDawn, describeGpu } from './dawn.ts';

afterAll(closeDawn);

const MIXED = record('Mixed', {
  flag: 'u32',
  p: 'vec3f',
  q: 'vec2f',
  delta: 'i32',
  m: 'mat3x3f',
  range: 'vec2u',
  n: 'mat4x4f',
  four: 'vec4u',
});

const COMPONENTS: Readonly<Record<string, readonly string[]>> = {
  f32: [''],
  u32: [''],
  i32: [''],
  vec2f: ['.x', '.y'],
  vec2u: ['.x', '.y'],
  vec3f: ['.x', '.y', '.z'],
  vec4f: ['.x', '.y', '.z', '.w'],
  vec4u: ['.x', '.y', '.z', '.w'],
  mat3x3f: [0, 1, 2].flatMap((c) => [0, 1, 2].map((r) => `[${c}][${r}]`)),
  mat4x4f: [0, 1, 2, 3].flatMap((c) => [0, 1, 2, 3].map((r) => `[${c}][${r}]`)),
};

/** A struct's members with the components of each, and three values made of 1, 2, 3, … */
function sampled(wgsl: string) {
  const members = [...wgsl.matchAll(/^ {2}(\w+): (\w+),$/gm)].map(([, name, type]) => ({
    name: name!,
    parts: COMPONENTS[type!]!,
  }));
  let next = 0;
  const values = [0, 1, 2].map(() =>
    Object.fromEntries(
      members.map(({ name, parts }) => {
        const numbers = parts.map(() => ++next);
        return [name, parts.length === 1 ? numbers[0]! : numbers];
      }),
    ),
  );
  const components = members.flatMap(({ name, parts }) => parts.map((part) => `${name}${part}`));
  return { values, components, all: Array.from({ length: next }, (_, i) => i + 1) };
}

/** Writes out every component of `value`, an expression of i. */
function entry(head: string, value: string, components: readonly string[]): string {
  const width = components.length;
  const lines = components.map((component, k) => `out[i * ${width}u + ${k}u] = f32(value.${component});`);
  return `#import record
    ${head}
    @group(0) @binding(1) var<storage, read_write> out: array<f32>;
    @compute @workgroup_size(64) fn main(@builtin(local_invocation_index) i: u32) {
      if (i >= 3u) { return; }
      let value = ${value};
      ${lines.join('\n')}
    }`;
}

describeGpu('a record', () => {
  for (const layout of [MIXED, ...Object.values(RECORDS)]) {
    const { values, components, all } = sampled(layout.wgsl);

    it(`${layout.name} is read by the device as it was packed`, async () => {
      const head = `@group(0) @binding(0) var<storage, read> values: array<${layout.name}>;`;
      const bytes = (layout.pack as (values: readonly unknown[]) => ArrayBuffer)(values);
      expect(bytes.byteLength).toBe(3 * layout.size);
      const modules = { record: layout.wgsl, test: entry(head, 'values[i]', components) };
      const read = await withDevice((device) => compute(device, modules, bytes, all.length, 64));
      expect([...read]).toEqual(all);
    });

    it(`${layout.name} is loaded from a heap`, async () => {
      const head = '@group(0) @binding(0) var<storage, read> records: array<vec4u>;';
      const name = /fn (load_\w+)/.exec(layout.loader)![1]!;
      const value = `${name}(1u + i * ${name.replace('load_', '').toUpperCase()}_STRIDE)`;
      const heap = new Heap();
      heap.add(PROGRAM, { first: 0, end: 0 });
      for (const one of values) heap.add(layout as never, one as never);
      const modules = { record: layout.wgsl + layout.loader, test: entry(head, value, components) };
      const read = await withDevice((device) => compute(device, modules, heap.bytes(), all.length, 64));
      expect([...read]).toEqual(all);
    });
  }
});
