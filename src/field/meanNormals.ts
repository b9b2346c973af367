/** Normals of vertices where the field has no slope: the mean of the triangles around, by area. */
import { cross3, length3, scale3, sub3 } from '../math/tuple.ts';
import type { Vec3 } from '../math/vec.ts';
import type { Mesh } from '../mesh/mesh.ts';

/** Writes those of `wanted`, which are 0. */
export function meanNormals({ positions, normals, indices }: Mesh, wanted: ReadonlySet<number>): void {
  const at = (i: number): Vec3 => [positions[3 * i]!, positions[3 * i + 1]!, positions[3 * i + 2]!];
  for (let i = 0; i < indices.length; i += 3) {
    const corners = [indices[i]!, indices[i + 1]!, indices[i + 2]!] as const;
    if (!corners.some((corner) => wanted.has(corner))) continue;
    const [a, b, c] = [at(corners[0]), at(corners[1]), at(corners[2])];
    const across = cross3(sub3(b, a), sub3(c, a));
    for (const corner of corners) {
      if (wanted.has(corner))
        for (let axis = 0; axis < 3; axis++) normals[3 * corner + axis]! += across[axis]!;
    }
  }
  for (const i of wanted) {
    const sum: Vec3 = [normals[3 * i]!, normals[3 * i + 1]!, normals[3 * i + 2]!];
    const length = length3(sum);
    normals.set(length > 0 ? scale3(sum, 1 / length) : [0, 1, 0], 3 * i);
  }
}
