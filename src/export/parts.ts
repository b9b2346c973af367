/** The parts of a model as files take them: what has no triangles is left out, what is no number is refused. */
import type { Finish } from '../document/finish.ts';
import { length3 } from '../math/tuple.ts';
import type { Mesh } from '../mesh/mesh.ts';
import { ExportError } from './error.ts';
import type { Model } from './index.ts';
import { plainName } from './names.ts';

export interface FilePart {
  /** never empty; two parts may share one */
  readonly name: string;
  /** #rrggbb, display values */
  readonly colour: string;
  readonly finish: Finish;
  readonly mesh: Mesh;
}

export function fileParts(model: Model): FilePart[] {
  const parts = model.solids.map(({ name, colour, finish, mesh }, i) => ({
    name: plainName(name, i),
    colour,
    finish,
    mesh,
  }));
  return parts.filter(({ mesh }) => mesh.indices.length > 0).map(sound);
}

/** How many vertices and triangles all of them have. */
export function countsOf(parts: readonly FilePart[]): {
  readonly vertices: number;
  readonly triangles: number;
} {
  let vertices = 0;
  let triangles = 0;
  for (const { mesh } of parts) {
    vertices += mesh.positions.length / 3;
    triangles += mesh.indices.length / 3;
  }
  return { vertices, triangles };
}

function sound(part: FilePart): FilePart {
  const { mesh } = part;
  if (!mesh.positions.every(Number.isFinite) || !mesh.uvs.every(Number.isFinite)) {
    throw new ExportError(`the part “${part.name}” has a coordinate that is no finite number`);
  }
  return areUnit(mesh.normals) ? part : { ...part, mesh: { ...mesh, normals: madeUnit(mesh.normals) } };
}

/** of a normal's length; glTF allows seven times as much */
const TOLERANCE = 1e-3;

function areUnit(normals: Float32Array): boolean {
  for (let i = 0; i < normals.length; i += 3) {
    const length = length3([normals[i]!, normals[i + 1]!, normals[i + 2]!]);
    if (!(Math.abs(length - 1) <= TOLERANCE)) return false;
  }
  return true;
}

/** A normal without a direction points up: any unit vector is as right, and readers refuse none. */
function madeUnit(normals: Float32Array): Float32Array {
  const out = normals.slice();
  for (let i = 0; i < out.length; i += 3) {
    const length = length3([out[i]!, out[i + 1]!, out[i + 2]!]);
    const known = length > 0 && length < Infinity;
    for (let k = 0; k < 3; k++) out[i + k] = known ? out[i + k]! / length : k === 1 ? 1 : 0;
  }
  return out;
}
