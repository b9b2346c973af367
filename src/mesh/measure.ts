/**
 * Volume, area and bounds of a mesh. The volume is the divergence theorem, a sum of signed tetrahedra; their
 * common apex is the middle of the box rather than the origin, so that a small form far away keeps its digits.
 */
import { cross3, dot3, length3, sub3 } from '../math/tuple.ts';
import type { Vec3 } from '../math/vec.ts';
import type { Box, Mesh } from './mesh.ts';

/** mm³, positive when triangles face outward; independent of the place only when the mesh is closed. */
export function volume(mesh: Mesh): number {
  const middle = centre(bounds(mesh));
  let six = 0;
  eachTriangle(mesh, (a, b, c) => {
    six += dot3(sub3(a, middle), cross3(sub3(b, middle), sub3(c, middle)));
  });
  return six / 6;
}

/** mm² */
export function area(mesh: Mesh): number {
  let twice = 0;
  eachTriangle(mesh, (a, b, c) => {
    twice += length3(cross3(sub3(b, a), sub3(c, a)));
  });
  return twice / 2;
}

/** The box of all vertices; a mesh without vertices has the box of the origin alone. */
export function bounds(mesh: Mesh): Box {
  const { positions } = mesh;
  if (positions.length === 0) return { min: [0, 0, 0], max: [0, 0, 0] };
  const min: [number, number, number] = [Infinity, Infinity, Infinity];
  const max: [number, number, number] = [-Infinity, -Infinity, -Infinity];
  for (let i = 0; i < positions.length; i++) {
    const axis = i % 3;
    min[axis] = Math.min(min[axis]!, positions[i]!);
    max[axis] = Math.max(max[axis]!, positions[i]!);
  }
  return { min, max };
}

/** Calls with the corners of every triangle, in order. */
export function eachTriangle(mesh: Mesh, visit: (a: Vec3, b: Vec3, c: Vec3, triangle: number) => void): void {
  const { positions, indices } = mesh;
  const vertex = (i: number): Vec3 => {
    const at = 3 * indices[i]!;
    return [positions[at]!, positions[at + 1]!, positions[at + 2]!];
  };
  for (let i = 0; i < indices.length; i += 3) visit(vertex(i), vertex(i + 1), vertex(i + 2), i / 3);
}

function centre({ min, max }: Box): Vec3 {
  return [(min[0] + max[0]) / 2, (min[1] + max[1]) / 2, (min[2] + max[2]) / 2];
}
