/**
 * A mesh with creases as it was read from the device: without the vertices and triangles that were counted for loops around creases and are
 * none, and with a place for each point on a crease. Loops around one corner find the same, where two vertices would be one.
 */
import type { Mesh } from '../../mesh/mesh.ts';

/** What there is of each vertex and triangle; `fans`: of vertices on creases a number below −1, alike for those of one point. */
export interface Written extends Omit<Mesh, 'uvs'> {
  readonly colours: Float32Array;
  readonly fans: Float32Array;
}

export function creasedMesh(written: Written): Omit<Written, 'fans'> {
  const { positions, normals, colours, indices } = written;
  const triangles = usedTriangles(indices);
  const vertices = new Int32Array(positions.length / 3).fill(-1);
  let count = 0;
  for (const vertex of triangles) vertices[vertex] = 0;
  vertices.forEach((used, vertex) => {
    if (used === 0) vertices[vertex] = count++;
  });
  moveApart(written, vertices);
  const kept = (of: Float32Array) => {
    const three = new Float32Array(3 * count);
    vertices.forEach((to, from) => {
      if (to >= 0) three.set(of.subarray(3 * from, 3 * from + 3), 3 * to);
    });
    return three;
  };
  return {
    positions: kept(positions),
    normals: kept(normals),
    colours: kept(colours),
    indices: triangles.map((vertex) => vertices[vertex]!),
  };
}

function usedTriangles(indices: Uint32Array): Uint32Array {
  const used = new Uint32Array(indices.length);
  let end = 0;
  for (let i = 0; i < indices.length; i += 3) {
    const [a, b, c] = [indices[i]!, indices[i + 1]!, indices[i + 2]!];
    if (a === b || b === c || c === a) continue;
    used.set([a, b, c], end);
    end += 3;
  }
  return used.slice(0, end);
}

/** In place. The vertices of a point follow one another. */
function moveApart({ positions, fans }: Written, vertices: Int32Array): void {
  const places = new Set<string>();
  for (let first = 0; first < fans.length; ) {
    let end = first + 1;
    while (fans[first]! < -1 && fans[end] === fans[first]) end++;
    if (fans[first]! < -1 && vertices[first]! >= 0) {
      const at = positions.subarray(3 * first, 3 * first + 3);
      while (places.has(at.join(' '))) moveLeast(at);
      places.add(at.join(' '));
      for (let vertex = first + 1; vertex < end; vertex++) positions.set(at, 3 * vertex);
    }
    first = end;
  }
}

const float = new Float32Array(1);
const bits = new Int32Array(float.buffer);

/** To the next number along the axis where that is farthest. */
function moveLeast(at: Float32Array): void {
  const axis = [0, 1, 2].reduce((most, k) => (Math.abs(at[k]!) > Math.abs(at[most]!) ? k : most));
  float[0] = at[axis]!;
  bits[0]! += 1;
  at[axis] = float[0]!;
}
