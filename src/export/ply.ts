/**
 * PLY, binary little endian: one mesh of all parts, in millimetres, with a normal and a colour (display values) a
 * vertex.
 */
import { reserve } from './bytes.ts';
import { display, displayBytes } from './colour.ts';
import type { Exporter } from './index.ts';
import { fileName } from './names.ts';
import { countsOf, type FilePart, fileParts } from './parts.ts';

export const ply: Exporter = {
  id: 'ply',
  label: 'PLY',
  carries: 'normals and colours by vertex; millimetres',
  mime: 'model/ply',
  async write(model) {
    return [{ name: `${fileName(model.name)}.ply`, bytes: mesh(fileParts(model)) }];
  },
};

const VERTEX = 6 * 4 + 3;
const FACE = 1 + 3 * 4;

function header(vertices: number, triangles: number): string {
  return `ply
format binary_little_endian 1.0
comment Rotund
comment unit: millimetre; axes: right-handed, y up; colours: display values (sRGB)
element vertex ${vertices}
property float x
property float y
property float z
property float nx
property float ny
property float nz
property uchar red
property uchar green
property uchar blue
element face ${triangles}
property list uchar int vertex_indices
end_header
`;
}

function mesh(parts: readonly FilePart[]): Uint8Array<ArrayBuffer> {
  const { vertices, triangles } = countsOf(parts);
  const head = new TextEncoder().encode(header(vertices, triangles));
  const bytes = reserve(head.length + VERTEX * vertices + FACE * triangles);
  bytes.set(head);
  const view = new DataView(bytes.buffer);
  let at = head.length;
  for (const part of parts) at = putVertices(view, at, part);
  let first = 0;
  for (const part of parts) {
    at = putFaces(view, at, part.mesh.indices, first);
    first += part.mesh.positions.length / 3;
  }
  return bytes;
}

function putVertices(view: DataView, from: number, { mesh, colour }: FilePart): number {
  const { positions, normals, colours } = mesh;
  const rgb = displayBytes(colour);
  const channel = (i: number) => (colours ? Math.round(255 * display(colours[i]!)) : rgb[i % 3]!);
  let at = from;
  for (let i = 0; i < positions.length; i += 3, at += VERTEX) {
    for (let k = 0; k < 3; k++) {
      // + 0 turns −0 into 0
      view.setFloat32(at + 4 * k, positions[i + k]! + 0, true);
      view.setFloat32(at + 12 + 4 * k, normals[i + k]! + 0, true);
      view.setUint8(at + 24 + k, channel(i + k));
    }
  }
  return at;
}

function putFaces(view: DataView, from: number, indices: Uint32Array, first: number): number {
  let at = from;
  for (let i = 0; i < indices.length; i += 3, at += FACE) {
    view.setUint8(at, 3);
    for (let k = 0; k < 3; k++) view.setInt32(at + 1 + 4 * k, indices[i + k]! + first, true);
  }
  return at;
}
