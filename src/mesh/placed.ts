/** A mesh somewhere else: positions moved and turned, normals turned; what does not change is shared. */
import { isUnmoved, type Placement, place3 } from '../math/placement.ts';
import { rotate3 } from '../math/tuple.ts';
import type { Vec3 } from '../math/vec.ts';
import type { Mesh } from './mesh.ts';

export function placed(mesh: Mesh, placement: Placement): Mesh {
  // by its numbers: a document that comes from a file gives the very same mesh
  if (isUnmoved(placement)) return mesh;
  return {
    ...mesh,
    positions: mapped(mesh.positions, (p) => place3(placement, p)),
    normals: mapped(mesh.normals, (n) => rotate3(placement.rotation, n)),
  };
}

function mapped(from: Float32Array, map: (v: Vec3) => Vec3): Float32Array {
  const out = new Float32Array(from.length);
  for (let i = 0; i < from.length; i += 3) out.set(map([from[i]!, from[i + 1]!, from[i + 2]!]), i);
  return out;
}
