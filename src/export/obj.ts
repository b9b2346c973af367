/**
 * Wavefront OBJ with its material library: a group (and object) a part, positions, texture coordinates and normals with
 * the digits that float32 needs, one material a colour and finish. OBJ has no unit and no colour space; both are in comments. Painted parts
 * have a colour behind each position, as display values, which MeshLab, Blender and others read, and a white material.
 */

import { isPlainFinish } from '../document/finish.ts';
import { ByteWriter } from './bytes.ts';
import { display, displayBytes } from './colour.ts';
import type { Exporter } from './index.ts';
import { type Material, materialsOf } from './material.ts';
import { fileName, wordNames, wordOf } from './names.ts';
import { type FilePart, fileParts } from './parts.ts';

export const obj: Exporter = {
  id: 'obj',
  label: 'Wavefront OBJ',
  carries: 'groups, normals, texture coordinates, materials; millimetres',
  mime: 'model/obj',
  async write(model) {
    const parts = fileParts(model);
    const name = fileName(model.name);
    // Readers split the line that names the library at spaces.
    const library = `${wordOf(name) || 'rotund'}.mtl`;
    return [
      { name: `${name}.obj`, bytes: geometry(parts, library) },
      { name: library, bytes: materials(parts) },
    ];
  },
};

function geometry(parts: readonly FilePart[], library: string): Uint8Array<ArrayBuffer> {
  const out = new ByteWriter();
  out.text('# Rotund\n# unit: millimetre; axes: right-handed, y up\n');
  out.text(`mtllib ${library}\n`);
  const worn = materialsOf(parts);
  const names = wordNames(parts.map(({ name }) => name));
  // Vertices are numbered from 1 through the whole file.
  let first = 1;
  parts.forEach((part, i) => {
    const { mesh } = part;
    out.text(`o ${names[i]}\ng ${names[i]}\n`);
    if (mesh.colours) paintedVertices(out, mesh.positions, mesh.colours);
    else vectors(out, 'v', mesh.positions, 3);
    vectors(out, 'vt', mesh.uvs, 2);
    vectors(out, 'vn', mesh.normals, 3);
    out.text(`usemtl ${worn[i]!.name}\n`);
    faces(out, mesh.indices, first);
    first += mesh.positions.length / 3;
  });
  return out.bytes();
}

function paintedVertices(out: ByteWriter, positions: Float32Array, colours: Float32Array): void {
  for (let i = 0; i < positions.length; i += 3) {
    out.ascii('v');
    for (let k = 0; k < 3; k++) {
      out.ascii(' ');
      out.float(positions[i + k]!);
    }
    for (let k = 0; k < 3; k++) out.ascii(` ${hundredThousandths(display(colours[i + k]!))}`);
    out.ascii('\n');
  }
}

/** more than a screen shows, and the same in every engine */
const hundredThousandths = (value: number): number => Math.round(1e5 * value) / 1e5;

function vectors(out: ByteWriter, keyword: string, values: Float32Array, width: number): void {
  for (let i = 0; i < values.length; i += width) {
    out.ascii(keyword);
    for (let k = 0; k < width; k++) {
      out.ascii(' ');
      out.float(values[i + k]!);
    }
    out.ascii('\n');
  }
}

function faces(out: ByteWriter, indices: Uint32Array, first: number): void {
  for (let i = 0; i < indices.length; i += 3) {
    out.ascii('f');
    for (let k = 0; k < 3; k++) corner(out, indices[i + k]! + first);
    out.ascii('\n');
  }
}

/** Position, texture coordinate and normal have the same number. */
function corner(out: ByteWriter, vertex: number): void {
  out.ascii(' ');
  out.whole(vertex);
  out.ascii('/');
  out.whole(vertex);
  out.ascii('/');
  out.whole(vertex);
}

function materials(parts: readonly FilePart[]): Uint8Array<ArrayBuffer> {
  const out = new ByteWriter();
  out.text('# Rotund\n# Kd: display values (sRGB), not linear\n');
  for (const material of new Set(materialsOf(parts)))
    out.text(`\nnewmtl ${material.name}\n${lines(material)}`);
  return out.bytes();
}

/** Clay has no highlight, and its ambient light is for readers to say. */
function lines({ colour, finish }: Material): string {
  const { ambient, diffuse, specular, shininess } = finish;
  const times = (factor: number) =>
    displayBytes(colour)
      .map((value) => Number(Math.min(1, (factor * value) / 255).toFixed(6)))
      .join(' ');
  if (isPlainFinish(finish)) return `Kd ${times(1)}\nKs 0 0 0\nd 1\nillum 1\n`;
  const highlight = `Ks ${specular} ${specular} ${specular}\nNs ${shininess}`;
  return `Ka ${times(ambient)}\nKd ${times(diffuse)}\n${highlight}\nd 1\nillum 2\n`;
}
