/** Small meshes whose topology is known. */
import type { Mesh } from '../../src/mesh/mesh.ts';

/** A mesh from points and triangles; every corner gets its own vertex, so that all welding is by position. */
export function soup(
  points: readonly (readonly number[])[],
  triangles: readonly (readonly number[])[],
): Mesh {
  const corners = triangles.flat().map((i) => points[i]!);
  return {
    positions: Float32Array.from(corners.flat()),
    normals: Float32Array.from(corners.flatMap(() => [0, 0, 1])),
    uvs: new Float32Array(2 * corners.length),
    indices: Uint32Array.from(corners, (_, i) => i),
  };
}

/** A box from the origin to (x, y, z), moved by `at`. */
export function box(x: number, y: number, z: number, at: readonly number[] = [0, 0, 0]): Mesh {
  const points = Array.from({ length: 8 }, (_, i) => [
    at[0]! + (i & 1 ? x : 0),
    at[1]! + (i & 2 ? y : 0),
    at[2]! + (i & 4 ? z : 0),
  ]);
  const quads = [
    [0, 2, 3, 1],
    [4, 5, 7, 6],
    [0, 1, 5, 4],
    [2, 6, 7, 3],
    [0, 4, 6, 2],
    [1, 3, 7, 5],
  ];
  return soup(
    points,
    quads.flatMap(([a, b, c, d]) => [
      [a!, b!, c!],
      [a!, c!, d!],
    ]),
  );
}

export function union(...meshes: readonly Mesh[]): Mesh {
  let before = 0;
  const indices = meshes.flatMap((mesh) => {
    const moved = Array.from(mesh.indices, (i) => i + before);
    before += mesh.positions.length / 3;
    return moved;
  });
  const join = (of: (mesh: Mesh) => Float32Array) =>
    Float32Array.from(meshes.flatMap((mesh) => [...of(mesh)]));
  return {
    positions: join((mesh) => mesh.positions),
    normals: join((mesh) => mesh.normals),
    uvs: join((mesh) => mesh.uvs),
    indices: Uint32Array.from(indices),
  };
}
