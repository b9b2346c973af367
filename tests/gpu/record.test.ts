import { afterAll, expect, it } from 'vitest';
import { EDGE, POINT, POLYGON, SEGMENT } from '../../src/gpu/structs.ts';
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

describeGpu('a record', () => {
  for (const layout of [MIXED, POINT, SEGMENT, POLYGON, EDGE]) {
    it(`${layout.name} is read by the device as it was packed`, async () => {
      const members = [...layout.wgsl.matchAll(/^ {2}(\w+): (\w+),$/gm)].map(([, name, type]) => ({
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
      const width = members.flatMap(({ parts }) => parts).length;
      const lines = members.flatMap(({ name, parts }) =>
        parts.map((part) => `f32(values[i].${name}${part})`),
      );
      const entry = `#import record
        @group(0) @binding(0) var<storage, read> values: array<${layout.name}>;
        @group(0) @binding(1) var<storage, read_write> out: array<f32>;
        @compute @workgroup_size(64) fn main(@builtin(local_invocation_index) i: u32) {
          if (i >= 3u) { return; }
          ${lines.map((line, k) => `out[i * ${width}u + ${k}u] = ${line};`).join('\n')}
        }`;
      const bytes = (layout.pack as (values: readonly unknown[]) => ArrayBuffer)(values);
      expect(bytes.byteLength).toBe(3 * layout.size);
      const modules = { record: layout.wgsl, test: entry };
      const read = await withDevice((device) => compute(device, modules, bytes, 3 * width, 64));
      expect([...read]).toEqual(Array.from({ length: next }, (_, i) => i + 1));
    });
  }
});
