/** A mesh somewhere else: positions moved and turned, normals turned; what does not change is shared. */
import { isUnmoved, type Placement, UNMOVED } from '../math/placement.ts';
import type { Vec3 } from '../math/vec.ts';
import type { Mesh } from './mesh.ts';

export function placed(mesh: Mesh, placement: Placement): Mesh {
  if (isUnmoved(placement)) return mesh;
  return {
    ...mesh,
    positions: mapped(mesh.positions, placement, placement.translation),
    normals: mapped(mesh.normals, placement, UNMOVED.translation),
  };
}

/** `place3` without a tuple a step, operation by operation, so that the bits are the same: a drag does this in every frame. */
function mapped(from: Float32Array, { rotation }: Placement, [mx, my, mz]: Vec3): Float32Array {
  const [qx, qy, qz, qw] = rotation;
  const out = new Float32Array(from.length);
  for (let i = 0; i + 2 < from.length; i += 3) {
    const x = from[i]!;
    const y = from[i + 1]!;
    const z = from[i + 2]!;
    const tx = (qy * z - qz * y) * 2;
    const ty = (qz * x - qx * z) * 2;
    const tz = (qx * y - qy * x) * 2;
    out[i] = x + tx * qw + (qy * tz - qz * ty) + mx;
    out[i + 1] = y + ty * qw + (qz * tx - qx * tz) + my;
    out[i + 2] = z + tz * qw + (qx * ty - qy * tx) + mz;
  }
  return out;
}
