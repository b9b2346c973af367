/** The point of a mesh nearest to a point of space, with the smooth normal there. Every triangle is looked at. */
import { add3, cross3, dot3, length3, scale3, sub3 } from '../math/tuple.ts';
import type { Vec3 } from '../math/vec.ts';
import type { Box, Mesh } from './mesh.ts';

export interface Nearest {
  /** mm */
  readonly point: Vec3;
  /** unit, interpolated from the vertices */
  readonly normal: Vec3;
  /** mm */
  readonly distance: number;
}

/** Null when the mesh has no triangle nearer than `within`, mm. */
export function nearestOn(mesh: Mesh, to: Vec3, within = Infinity): Nearest | null {
  const { positions, normals, indices } = mesh;
  let distance = within;
  let found: { readonly corner: number; readonly shares: Vec3; readonly point: Vec3 } | null = null;
  for (let corner = 0; corner + 2 < indices.length; corner += 3) {
    const [a, b, c] = corners(positions, indices, corner);
    const shares = nearestShares(to, a, b, c);
    const point = mixed(shares, a, b, c);
    const away = length3(sub3(point, to));
    if (!(away < distance)) continue;
    distance = away;
    found = { corner, shares, point };
  }
  if (!found) return null;
  const smooth = mixed(found.shares, ...corners(normals, indices, found.corner));
  const length = length3(smooth);
  const normal = length > 1e-6 ? scale3(smooth, 1 / length) : flat(positions, indices, found.corner);
  return { point: found.point, normal, distance };
}

/** mm; 0 inside */
export function distanceToBox({ min, max }: Box, p: Vec3): number {
  const off = (axis: 0 | 1 | 2) => Math.max(min[axis] - p[axis], 0, p[axis] - max[axis]);
  return length3([off(0), off(1), off(2)]);
}

function corners(values: Float32Array, indices: Uint32Array, corner: number): [Vec3, Vec3, Vec3] {
  const at = (i: number): Vec3 => {
    const k = 3 * indices[corner + i]!;
    return [values[k]!, values[k + 1]!, values[k + 2]!];
  };
  return [at(0), at(1), at(2)];
}

const mixed = ([u, v, w]: Vec3, a: Vec3, b: Vec3, c: Vec3): Vec3 =>
  add3(add3(scale3(a, u), scale3(b, v)), scale3(c, w));

function flat(positions: Float32Array, indices: Uint32Array, corner: number): Vec3 {
  const [a, b, c] = corners(positions, indices, corner);
  const across = cross3(sub3(b, a), sub3(c, a));
  const length = length3(across);
  return length > 0 ? scale3(across, 1 / length) : [0, 0, 1];
}

/** Barycentric coordinates of the triangle's point nearest to p (Ericson, Real-Time Collision Detection, 5.1.5). */
function nearestShares(p: Vec3, a: Vec3, b: Vec3, c: Vec3): Vec3 {
  const ab = sub3(b, a);
  const ac = sub3(c, a);
  const ap = sub3(p, a);
  const d1 = dot3(ab, ap);
  const d2 = dot3(ac, ap);
  if (d1 <= 0 && d2 <= 0) return [1, 0, 0];
  const bp = sub3(p, b);
  const d3 = dot3(ab, bp);
  const d4 = dot3(ac, bp);
  if (d3 >= 0 && d4 <= d3) return [0, 1, 0];
  const vc = d1 * d4 - d3 * d2;
  if (vc <= 0 && d1 >= 0 && d3 <= 0) return along(d1 / (d1 - d3), 0);
  const cp = sub3(p, c);
  const d5 = dot3(ab, cp);
  const d6 = dot3(ac, cp);
  if (d6 >= 0 && d5 <= d6) return [0, 0, 1];
  const vb = d5 * d2 - d1 * d6;
  if (vb <= 0 && d2 >= 0 && d6 <= 0) return along(d2 / (d2 - d6), 2);
  const va = d3 * d6 - d5 * d4;
  if (va <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0) return along((d4 - d3) / (d4 - d3 + (d5 - d6)), 1);
  const sum = va + vb + vc;
  return sum > 0 ? [1 - vb / sum - vc / sum, vb / sum, vc / sum] : [1, 0, 0];
}

/** On an edge: 0 from a to b, 1 from b to c, 2 from a to c. */
function along(t: number, edge: 0 | 1 | 2): Vec3 {
  if (edge === 0) return [1 - t, t, 0];
  return edge === 1 ? [0, 1 - t, t] : [1 - t, 0, t];
}
