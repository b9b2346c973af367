/**
 * Readers of the files we write, from the formats' own descriptions and without a line of the program, so that a
 * mistake of a writer is not read back as if it were right.
 */
export interface ReadPart {
  readonly name: string;
  /** 0–1, as in the file */
  readonly colour: readonly number[];
  /** triples in the file's unit */
  readonly positions: readonly (readonly number[])[];
  readonly normals: readonly (readonly number[])[];
  readonly uvs: readonly (readonly number[])[];
  /** three places in `positions` each */
  readonly triangles: readonly (readonly number[])[];
  /** by vertex, 0–1, as in the file; none where there is one for all */
  readonly paint: readonly (readonly number[])[];
}

type Draft = {
  -readonly [K in keyof ReadPart]: ReadPart[K] extends readonly (infer T)[] ? T[] : ReadPart[K];
};

const part = (name: string): Draft => ({
  name,
  colour: [],
  positions: [],
  normals: [],
  uvs: [],
  triangles: [],
  paint: [],
});

export const asText = (bytes: Uint8Array): string => new TextDecoder('utf-8', { fatal: true }).decode(bytes);

/** Groups of an OBJ whose corners use the same number for position, texture and normal. */
export function readObj(bytes: Uint8Array, library: Uint8Array): ReadPart[] {
  const colours = readMtl(library);
  const parts: Draft[] = [];
  const starts: number[] = [];
  let seen = 0;
  for (const line of asText(bytes).split('\n')) {
    const [keyword, ...words] = line.split(' ');
    const now = parts.at(-1)!;
    const numbers = words.map(Number);
    if (keyword === 'g') {
      if (words.length !== 1) throw new Error(`OBJ: several groups in '${line}'`);
      parts.push(part(words[0]!));
      starts.push(seen + 1);
    } else if (keyword === 'v') {
      now.positions.push(numbers.slice(0, 3));
      if (numbers.length > 3) now.paint.push(numbers.slice(3));
      seen++;
    } else if (keyword === 'vt') now.uvs.push(numbers);
    else if (keyword === 'vn') now.normals.push(numbers);
    else if (keyword === 'usemtl') now.colour = [...colours.get(words[0]!)!];
    else if (keyword === 'f') now.triangles.push(words.map((word) => cornerOf(word, starts.at(-1)!)));
    else if (!['', '#', 'o', 'mtllib'].includes(keyword!)) throw new Error(`OBJ: unknown line '${line}'`);
  }
  return parts;
}

function cornerOf(word: string, start: number): number {
  const [v, vt, vn] = word.split('/').map(Number);
  if (v !== vt || v !== vn || !Number.isInteger(v)) throw new Error(`OBJ: corner '${word}'`);
  return v! - start;
}

export function readMtl(bytes: Uint8Array): Map<string, readonly number[]> {
  const colours = new Map<string, readonly number[]>();
  let name = '';
  for (const line of asText(bytes).split('\n')) {
    const [keyword, ...words] = line.split(' ');
    if (keyword === 'newmtl') name = words.join(' ');
    if (keyword === 'Kd') colours.set(name, words.map(Number));
  }
  return colours;
}

export interface ReadStl {
  readonly header: string;
  /** nine numbers each */
  readonly facets: readonly { readonly normal: readonly number[]; readonly corners: readonly number[][] }[];
}

export function readStl(bytes: Uint8Array): ReadStl {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  const count = view.getUint32(80, true);
  if (bytes.length !== 84 + 50 * count) throw new Error(`STL: ${bytes.length} bytes for ${count} facets`);
  const triple = (at: number) => [0, 4, 8].map((k) => view.getFloat32(at + k, true));
  const facets = Array.from({ length: count }, (_, i) => {
    const at = 84 + 50 * i;
    return { normal: triple(at), corners: [triple(at + 12), triple(at + 24), triple(at + 36)] };
  });
  return { header: asText(bytes.slice(0, 80)), facets };
}

export interface ReadPly {
  readonly header: readonly string[];
  readonly positions: readonly (readonly number[])[];
  readonly normals: readonly (readonly number[])[];
  /** 0–255 */
  readonly colours: readonly (readonly number[])[];
  readonly triangles: readonly (readonly number[])[];
}

const SIZES: Readonly<Record<string, number>> = { float: 4, uchar: 1, int: 4 };

/** Reads what the header announces, whatever the order of properties. */
export function readPly(bytes: Uint8Array): ReadPly {
  const text = new TextDecoder('latin1').decode(bytes);
  const end = text.indexOf('end_header\n') + 'end_header\n'.length;
  const header = text.slice(0, end).trimEnd().split('\n');
  const count = (element: string) =>
    Number(header.find((line) => line.startsWith(`element ${element} `))!.split(' ')[2]);
  const faceAt = header.findIndex((line) => line.startsWith('element face'));
  const properties = header.slice(0, faceAt).filter((line) => line.startsWith('property'));
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  let at = end;
  const scalar = (type: string): number => {
    at += SIZES[type]!;
    if (type === 'float') return view.getFloat32(at - 4, true);
    return type === 'int' ? view.getInt32(at - 4, true) : view.getUint8(at - 1);
  };
  const vertices = Array.from({ length: count('vertex') }, () =>
    Object.fromEntries(
      properties.map((line) => line.split(' ')).map(([, type, name]) => [name!, scalar(type!)]),
    ),
  );
  const triangles = Array.from({ length: count('face') }, () =>
    Array.from({ length: scalar('uchar') }, () => scalar('int')),
  );
  if (at !== bytes.length) throw new Error(`PLY: ${bytes.length - at} bytes left over`);
  const pick = (...names: string[]) => vertices.map((vertex) => names.map((name) => vertex[name]!));
  return {
    header,
    positions: pick('x', 'y', 'z'),
    normals: pick('nx', 'ny', 'nz'),
    colours: pick('red', 'green', 'blue'),
    triangles,
  };
}

/** The little of glTF that we write. */
export interface Gltf {
  readonly asset: { readonly generator: string; readonly version: string };
  readonly scenes?: readonly { readonly nodes?: readonly number[] }[];
  readonly nodes?: readonly { readonly name: string; readonly mesh: number }[];
  readonly meshes?: readonly {
    readonly name: string;
    readonly primitives: readonly {
      readonly attributes: Readonly<Record<string, number>>;
      readonly indices: number;
      readonly material: number;
    }[];
  }[];
  readonly materials?: readonly {
    readonly pbrMetallicRoughness: {
      readonly baseColorFactor?: readonly number[];
      readonly metallicFactor: number;
      readonly roughnessFactor: number;
    };
  }[];
  readonly accessors?: readonly {
    readonly bufferView: number;
    readonly byteOffset?: number;
    readonly componentType: number;
    readonly count: number;
    readonly type: 'SCALAR' | 'VEC2' | 'VEC3';
  }[];
  readonly bufferViews?: readonly { readonly byteOffset?: number; readonly byteStride?: number }[];
}

export function readGltf(bytes: Uint8Array): { readonly json: Gltf; readonly binary: DataView | null } {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  if (view.getUint32(0, true) !== 0x46546c67 || view.getUint32(8, true) !== bytes.length) {
    throw new Error('GLB: wrong head');
  }
  const length = view.getUint32(12, true);
  const json = JSON.parse(asText(bytes.slice(20, 20 + length))) as Gltf;
  const at = 28 + length;
  const binary = at < bytes.length ? new DataView(bytes.buffer, bytes.byteOffset + at) : null;
  return { json, binary };
}

/** glTF's default */
const WHITE: readonly number[] = [1, 1, 1, 1];

export function readGlb(bytes: Uint8Array): ReadPart[] {
  const { json, binary } = readGltf(bytes);
  const values = (index: number): number[][] => {
    const accessor = json.accessors![index]!;
    const view = json.bufferViews![accessor.bufferView]!;
    const width = { SCALAR: 1, VEC2: 2, VEC3: 3 }[accessor.type];
    const size = { 5123: 2, 5125: 4, 5126: 4 }[accessor.componentType]!;
    const start = (view.byteOffset ?? 0) + (accessor.byteOffset ?? 0);
    return Array.from({ length: accessor.count }, (_, i) =>
      Array.from({ length: width }, (_, k) => {
        const at = start + i * (view.byteStride ?? width * size) + k * size;
        if (accessor.componentType === 5126) return binary!.getFloat32(at, true);
        return size === 2 ? binary!.getUint16(at, true) : binary!.getUint32(at, true);
      }),
    );
  };
  return (json.scenes?.[0]?.nodes ?? []).map((index) => {
    const node = json.nodes![index]!;
    const { attributes, indices, material } = json.meshes![node.mesh]!.primitives[0]!;
    const flat = values(indices).flat();
    return {
      name: node.name,
      colour: json.materials![material]!.pbrMetallicRoughness.baseColorFactor ?? WHITE,
      positions: values(attributes.POSITION!),
      normals: values(attributes.NORMAL!),
      uvs: values(attributes.TEXCOORD_0!),
      paint: attributes.COLOR_0 === undefined ? [] : values(attributes.COLOR_0),
      triangles: Array.from({ length: flat.length / 3 }, (_, i) => flat.slice(3 * i, 3 * i + 3)),
    };
  });
}

// ── measures ──────────────────────────────────────────────────────────────────────────────────────────

type Point = readonly number[];
const minus = (a: Point, b: Point) => a.map((x, k) => x - b[k]!);
const cross = (a: Point, b: Point) => [
  a[1]! * b[2]! - a[2]! * b[1]!,
  a[2]! * b[0]! - a[0]! * b[2]!,
  a[0]! * b[1]! - a[1]! * b[0]!,
];
export const dot = (a: Point, b: Point): number => a.reduce((sum, x, k) => sum + x * b[k]!, 0);

export interface Measures {
  readonly triangles: number;
  readonly volume: number;
  readonly area: number;
  readonly min: Point;
  readonly max: Point;
}

/** Of triangles given by their corners. */
export function measured(corners: readonly (readonly Point[])[]): Measures {
  const points = corners.flat();
  const edge = (pick: (...values: number[]) => number) =>
    [0, 1, 2].map((k) => points.reduce((so, p) => pick(so, p[k]!), points[0]![k]!));
  return {
    triangles: corners.length,
    volume: corners.reduce((sum, [a, b, c]) => sum + dot(a!, cross(b!, c!)) / 6, 0),
    area: corners.reduce((sum, [a, b, c]) => {
      const across = cross(minus(b!, a!), minus(c!, a!));
      return sum + Math.sqrt(dot(across, across)) / 2;
    }, 0),
    min: edge(Math.min),
    max: edge(Math.max),
  };
}

/** Floats as the bits that a file holds: without negative zero. */
export const bitsOf = (values: Iterable<number>): Buffer =>
  Buffer.from(Float32Array.from(values, (x) => x + 0).buffer);

export const cornersOf = (read: Pick<ReadPart, 'positions' | 'triangles'>): Point[][] =>
  read.triangles.map((triangle) => triangle.map((i) => read.positions[i]!));

/** Half-edges without exactly one partner that runs the other way, places compared bit for bit. */
export function openEdges(corners: readonly (readonly Point[])[]): number {
  const count = new Map<string, number>();
  for (const [a, b, c] of corners) {
    for (const [from, to] of [
      [a, b],
      [b, c],
      [c, a],
    ]) {
      count.set(`${from}|${to}`, (count.get(`${from}|${to}`) ?? 0) + 1);
    }
  }
  return [...count].filter(
    ([key, times]) => times !== 1 || count.get(key.split('|').reverse().join('|')) !== 1,
  ).length;
}
