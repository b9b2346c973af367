/** Meshes on a lattice of whole millimetres told by where their vertices are, so that two of them can be compared whatever their numbers. */
import type { Mesh } from '../../../src/mesh/mesh.ts';

/** The edge of the lattice that a vertex is on, or the cell that it is within. */
function placeOf({ positions }: Mesh, vertex: number): string {
  const at = [0, 1, 2].map((axis) => positions[3 * vertex + axis]!);
  return at
    .map((x) => (Math.abs(x - Math.round(x)) < 1e-5 ? `${Math.round(x)}` : `${Math.floor(x)}+`))
    .join(' ');
}

/** Each triangle by its places, from the least on; sorted. */
export function trianglesOf(mesh: Mesh): readonly string[] {
  const places = Array.from({ length: mesh.positions.length / 3 }, (_, vertex) => placeOf(mesh, vertex));
  const triangles: string[] = [];
  for (let i = 0; i < mesh.indices.length; i += 3) {
    const corners = [0, 1, 2].map((k) => places[mesh.indices[i + k]!]!);
    const first = corners.indexOf([...corners].sort()[0]!);
    triangles.push([0, 1, 2].map((k) => corners[(first + k) % 3]).join(' | '));
  }
  return triangles.sort();
}
