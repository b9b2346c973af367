/**
 * STL, binary: triangles and nothing else, in millimetres, all parts in one. A triangle whose corners are in line
 * has the normal 0 0 0, as the format's readers expect, and is kept: left out it would open the surface.
 */
import { cross3, length3, sub3 } from '../math/tuple.ts';
import type { Vec3 } from '../math/vec.ts';
import { eachTriangle } from '../mesh/measure.ts';
import { reserve } from './bytes.ts';
import type { Exporter } from './index.ts';
import { fileName } from './names.ts';
import { countsOf, type FilePart, fileParts } from './parts.ts';

export const stl: Exporter = {
  id: 'stl',
  label: 'STL',
  carries: 'triangles only; millimetres',
  mime: 'model/stl',
  async write(model) {
    return [{ name: `${fileName(model.name)}.stl`, bytes: triangles(fileParts(model)) }];
  },
};

const HEADER = 80;
const RECORD = 50;
/** must not begin with "solid": that is how readers know the format's form in text */
const TITLE = 'Rotund; binary STL; unit: millimetre; axes: right-handed, y up';

function triangles(parts: readonly FilePart[]): Uint8Array<ArrayBuffer> {
  const { triangles: count } = countsOf(parts);
  const bytes = reserve(HEADER + 4 + RECORD * count);
  bytes.set(new TextEncoder().encode(TITLE));
  const view = new DataView(bytes.buffer);
  view.setUint32(HEADER, count, true);
  let at = HEADER + 4;
  for (const { mesh } of parts) {
    eachTriangle(mesh, (a, b, c) => {
      put(view, at, facing(a, b, c));
      put(view, at + 12, a);
      put(view, at + 24, b);
      put(view, at + 36, c);
      at += RECORD;
    });
  }
  return bytes;
}

/** The unit normal, or 0 0 0 where there is none. */
function facing(a: Vec3, b: Vec3, c: Vec3): Vec3 {
  const across = cross3(sub3(b, a), sub3(c, a));
  const length = length3(across);
  return length > 0 ? [across[0] / length, across[1] / length, across[2] / length] : [0, 0, 0];
}

function put(view: DataView, at: number, [x, y, z]: Vec3): void {
  // + 0 turns −0 into 0
  view.setFloat32(at, x + 0, true);
  view.setFloat32(at + 4, y + 0, true);
  view.setFloat32(at + 8, z + 0, true);
}
