/**
 * A struct declared once: its WGSL text, its bytes, and what writes and reads them.
 *
 * Theory: WGSL's rules for host-shareable memory (WebGPU Shading Language, "Alignment and Size"): a scalar is aligned to
 * 4, a vec2 to 8, vec3 and vec4 to 16; matrices are columns; a struct is aligned as its strictest member and its size is
 * rounded up to that. Bytes are little-endian on every platform that has WebGPU.
 */

/** What one member is made of. */
const TYPES = {
  f32: { scalar: 'f32', rows: 1, columns: 1 },
  u32: { scalar: 'u32', rows: 1, columns: 1 },
  i32: { scalar: 'i32', rows: 1, columns: 1 },
  vec2f: { scalar: 'f32', rows: 2, columns: 1 },
  vec3f: { scalar: 'f32', rows: 3, columns: 1 },
  vec4f: { scalar: 'f32', rows: 4, columns: 1 },
  vec2u: { scalar: 'u32', rows: 2, columns: 1 },
  vec4u: { scalar: 'u32', rows: 4, columns: 1 },
  mat3x3f: { scalar: 'f32', rows: 3, columns: 3 },
  mat4x4f: { scalar: 'f32', rows: 4, columns: 4 },
} as const;

export type MemberType = keyof typeof TYPES;
export type Members = Readonly<Record<string, MemberType>>;

type Scalars = 'f32' | 'u32' | 'i32';

/** A number for a scalar; else all components, matrices column by column. */
export type RecordValue<M extends Members> = {
  readonly [K in keyof M]: M[K] extends Scalars ? number : readonly number[];
};

export interface RecordLayout<M extends Members> {
  readonly name: string;
  readonly members: M;
  /** bytes from one record to the next in an array */
  readonly size: number;
  /** bytes */
  readonly align: number;
  /** bytes from the record's start */
  readonly offsets: Readonly<Record<keyof M, number>>;
  /** bytes in a heap, where each record begins at a multiple of 16 */
  readonly stride: number;
  /** The struct, ready to be a module. */
  readonly wgsl: string;
  /**
   * `fn load_segment(at: u32) -> Segment`: from `records`, an array<vec4u> whose element `at` the record begins with, so that
   * records of many kinds share one binding (WebGPU promises eight a stage); and how many elements lie between two.
   */
  readonly loader: string;
  /** All records in a row; none gives room for one, because WebGPU binds no empty buffer. */
  pack(values: readonly RecordValue<M>[]): ArrayBuffer;
  write(into: DataView, index: number, value: RecordValue<M>): void;
  read(from: DataView, index: number): RecordValue<M>;
}

interface Member {
  readonly name: string;
  readonly type: MemberType;
  readonly scalar: Scalars;
  /** bytes from the record's start, one a component */
  readonly places: readonly number[];
  /** bytes from the record's start to the first byte after it */
  readonly end: number;
  readonly align: number;
}

/** Declares a struct; members keep their order. */
export function record<const M extends Members>(name: string, members: M): RecordLayout<M> {
  const laid = layOut(members);
  const align = Math.max(...laid.map((member) => member.align));
  const size = roundUp(align, laid.at(-1)!.end);
  const offsets = Object.fromEntries(laid.map((member) => [member.name, member.places[0]!]));
  const write = (into: DataView, index: number, value: RecordValue<M>) => {
    for (const member of laid) writeMember(into, index * size, member, value[member.name]!);
  };
  return {
    name,
    members,
    size,
    align,
    offsets: offsets as Record<keyof M, number>,
    stride: roundUp(16, size),
    wgsl: structText(name, members),
    loader: loaderText(name, laid, roundUp(16, size)),
    write,
    pack(values) {
      const bytes = new ArrayBuffer(size * Math.max(1, values.length));
      const view = new DataView(bytes);
      values.forEach((value, index) => {
        write(view, index, value);
      });
      return bytes;
    },
    read(from, index) {
      const entries = laid.map((member) => [member.name, readMember(from, index * size, member)]);
      return Object.fromEntries(entries) as RecordValue<M>;
    },
  };
}

function layOut(members: Members): Member[] {
  let end = 0;
  return Object.entries(members).map(([name, type]) => {
    const { scalar, rows, columns } = TYPES[type];
    const align = 4 * (rows === 3 ? 4 : rows);
    const start = roundUp(align, end);
    // columns of a matrix keep their alignment even at its end; a lone vec3 leaves its last 4 bytes to the next member
    end = start + (columns > 1 ? columns * align : 4 * rows);
    const places = Array.from(
      { length: rows * columns },
      (_, i) => start + Math.floor(i / rows) * align + 4 * (i % rows),
    );
    return { name, type, scalar, places, end, align };
  });
}

const roundUp = (step: number, value: number): number => Math.ceil(value / step) * step;

function structText(name: string, members: Members): string {
  const lines = Object.entries(members).map(([member, type]) => `  ${member}: ${type},\n`);
  return `struct ${name} {\n${lines.join('')}}\n`;
}

/** 16 bytes at a time: every access to a buffer is checked against its end, on software adapters at a price. */
function loaderText(name: string, laid: readonly Member[], stride: number): string {
  const snake = name.replace(/(?<!^)[A-Z]/g, (letter) => `_${letter}`);
  const words = Array.from({ length: stride / 16 }, (_, i) => `  let w${i} = records[at + ${i}u];\n`);
  const members = laid.map((member) => `    ${memberText(member)},\n`);
  return [
    `const ${snake.toUpperCase()}_STRIDE = ${stride / 16}u;\n`,
    `fn load_${snake.toLowerCase()}(at: u32) -> ${name} {\n`,
    ...words,
    `  return ${name}(\n${members.join('')}  );\n}\n`,
  ].join('');
}

/** No member straddles 16 bytes: a vec2 is aligned to 8, all else to its size or to 16. */
function memberText({ type, scalar, places }: Member): string {
  const { rows, columns } = TYPES[type];
  const parts = Array.from({ length: columns }, (_, column) => {
    const first = places[column * rows]! / 4;
    const lanes = `w${Math.floor(first / 4)}.${'xyzw'.slice(first % 4, (first % 4) + rows)}`;
    return scalar === 'u32' ? lanes : `bitcast<${rows === 1 ? scalar : `vec${rows}<${scalar}>`}>(${lanes})`;
  });
  return columns === 1 ? parts[0]! : `${type}(${parts.join(', ')})`;
}

function writeMember(into: DataView, base: number, member: Member, value: number | readonly number[]): void {
  const components = typeof value === 'number' ? [value] : value;
  if (components.length !== member.places.length) {
    throw new RangeError(`${member.name} has ${member.places.length} components, not ${components.length}`);
  }
  member.places.forEach((place, i) => {
    const component = components[i]!;
    if (member.scalar === 'f32') into.setFloat32(base + place, component, true);
    else if (member.scalar === 'u32') into.setUint32(base + place, component, true);
    else into.setInt32(base + place, component, true);
  });
}

function readMember(from: DataView, base: number, member: Member): number | readonly number[] {
  const components = member.places.map((place) => {
    if (member.scalar === 'f32') return from.getFloat32(base + place, true);
    if (member.scalar === 'u32') return from.getUint32(base + place, true);
    return from.getInt32(base + place, true);
  });
  return member.places.length === 1 ? components[0]! : components;
}
