import { describe, expect, it } from 'vitest';
import { type Members, type MemberType, record } from '../../src/math/record.ts';
import { random } from '../fixtures/random.ts';

/** AlignOf and SizeOf of the standard's table, written down a second time. */
const STANDARD: Readonly<Record<MemberType, readonly [align: number, size: number]>> = {
  f32: [4, 4],
  u32: [4, 4],
  i32: [4, 4],
  vec2f: [8, 8],
  vec3f: [16, 12],
  vec4f: [16, 16],
  vec2u: [8, 8],
  vec4u: [16, 16],
  mat3x3f: [16, 48],
  mat4x4f: [16, 64],
};

describe('record', () => {
  it('writes the struct as WGSL', () => {
    expect(record('Segment', { a: 'vec3f', length: 'f32' }).wgsl).toBe(
      'struct Segment {\n  a: vec3f,\n  length: f32,\n}\n',
    );
  });

  it('lets a scalar fill the gap after a vec3f', () => {
    const { offsets, size, align } = record('R', { a: 'vec3f', b: 'f32', c: 'f32', d: 'vec2f' });
    expect(offsets).toEqual({ a: 0, b: 12, c: 16, d: 24 });
    expect([size, align]).toEqual([32, 16]);
  });

  it('does not let one fill the gap at the end of a matrix', () => {
    const { offsets, size } = record('R', { m: 'mat3x3f', b: 'f32' });
    expect(offsets).toEqual({ m: 0, b: 48 });
    expect(size).toBe(64);
  });

  it('follows the table of the standard for 300 random structs (seed 11)', () => {
    const uniform = random(11);
    const types = Object.keys(STANDARD) as MemberType[];
    for (let round = 0; round < 300; round++) {
      const members: Record<string, MemberType> = {};
      const count = 1 + Math.floor(uniform() * 6);
      for (let i = 0; i < count; i++) members[`m${i}`] = types[Math.floor(uniform() * types.length)]!;
      const { offsets, size, align } = record('R', members as Members);
      let at = 0;
      let strictest = 0;
      for (const [name, type] of Object.entries(members)) {
        const [memberAlign, memberSize] = STANDARD[type];
        while (at % memberAlign) at++;
        expect(offsets[name]).toBe(at);
        at += memberSize;
        strictest = Math.max(strictest, memberAlign);
      }
      while (at % strictest) at++;
      expect([size, align]).toEqual([at, strictest]);
    }
  });

  it('reads back what it wrote, each record in its place', () => {
    const layout = record('R', { count: 'u32', p: 'vec3f', delta: 'i32', m: 'mat3x3f', range: 'vec2u' });
    const values = [1, 2, 3].map((k) => ({
      count: 4e9 + k,
      p: [k, -k, k / 2],
      delta: -k,
      m: [1, 2, 3, 4, 5, 6, 7, 8, 9 * k],
      range: [k, 2 * k],
    }));
    const bytes = layout.pack(values);
    expect(bytes.byteLength).toBe(3 * layout.size);
    const view = new DataView(bytes);
    values.forEach((value, i) => {
      expect(layout.read(view, i)).toEqual(value);
    });
  });

  it('has room for one record when there is none', () => {
    expect(record('R', { a: 'f32' }).pack([]).byteLength).toBe(4);
  });

  it('refuses a wrong number of components by name', () => {
    const layout = record('R', { p: 'vec3f' });
    expect(() => layout.pack([{ p: [1, 2] }])).toThrow('p has 3 components, not 2');
  });
});
