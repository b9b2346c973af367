/** Meshes told by where their vertices are on the lattice, so that two of them can be compared whatever their numbers. */
import type { Lattice } from '../../../src/field/lattice.ts';
import type { Mesh } from '../../../src/mesh/mesh.ts';

/** parts of a step: vertices are kept 1e-4 from nodes */
const CLOSE = 5e-5;

/** The edge of the lattice that a vertex is on, or the cell that it is within. */
export function placesOf({ positions }: Mesh, { origin, step }: Lattice): readonly string[] {
  const part = (vertex: number, axis: number) => {
    const x = (positions[3 * vertex + axis]! - origin[axis]!) / step;
    return Math.abs(x - Math.round(x)) < CLOSE ? `${Math.round(x)}` : `${Math.floor(x)}+`;
  };
  return Array.from({ length: positions.length / 3 }, (_, v) => `${part(v, 0)} ${part(v, 1)} ${part(v, 2)}`);
}

/** Each triangle by its places, from the least on; sorted. */
export function trianglesOf(mesh: Mesh, lattice: Lattice): readonly string[] {
  const places = placesOf(mesh, lattice);
  const triangles: string[] = [];
  for (let i = 0; i < mesh.indices.length; i += 3) {
    const corners = [0, 1, 2].map((k) => places[mesh.indices[i + k]!]!);
    const first = corners.indexOf([...corners].sort()[0]!);
    triangles.push([0, 1, 2].map((k) => corners[(first + k) % 3]).join(' | '));
  }
  return triangles.sort();
}
