/**
 * A cube as six tetrahedra around its main diagonal (Kuhn's), one a permutation of the axes: neighbouring cubes cut the face
 * between them along the same diagonal, so that no case is ambiguous and the surface has no gap.
 *
 * Corners are masks of bits: 1 is a step along x, 2 along y, 4 along z. Of the two corners of an edge one holds the other,
 * a = edge & 7 lies nearer to the first node and b = edge >> 3 farther.
 */

/** Of the corners of a cube that are inside, one bit a corner: the triangles, three edges each, counter-clockwise from outside. */
export function cubeTriangles(inside: number): readonly number[] {
  return TABLE[inside]!;
}

const PERMUTATIONS = [
  { axes: [1, 2, 4], odd: false },
  { axes: [2, 4, 1], odd: false },
  { axes: [4, 1, 2], odd: false },
  { axes: [2, 1, 4], odd: true },
  { axes: [1, 4, 2], odd: true },
  { axes: [4, 2, 1], odd: true },
] as const;

/**
 * Even orders of the corners of a tetrahedron, those inside first. Of a positive one (i, j, k, l) a lone inside corner i is
 * cut off by (ij, ik, il), and two, i and j, by the quad (ik, il, jl, jk).
 */
const ONE = [
  [0, 1, 2, 3],
  [1, 0, 3, 2],
  [2, 3, 0, 1],
  [3, 2, 1, 0],
] as const;
const TWO = [
  [0, 1, 2, 3],
  [0, 2, 3, 1],
  [0, 3, 1, 2],
  [1, 2, 0, 3],
  [1, 3, 2, 0],
  [2, 3, 0, 1],
] as const;

const TABLE = Array.from({ length: 256 }, (_, inside) =>
  PERMUTATIONS.flatMap(({ axes: [a, b], odd }) => {
    const corners = [0, a, a | b, 7] as const;
    const triangles = cut(corners, inside);
    return odd ? triangles.toReversed() : triangles;
  }),
);

function cut(corners: readonly [number, number, number, number], inside: number): readonly number[] {
  const isIn = (i: number) => ((inside >> corners[i]!) & 1) === 1;
  const count = [0, 1, 2, 3].filter(isIn).length;
  const edge = (i: number, j: number) => {
    const [p, q] = [corners[i]!, corners[j]!];
    return Math.min(p, q) | (Math.max(p, q) << 3);
  };
  if (count === 1 || count === 3) {
    const [i, j, k, l] = ONE.find((order) => isIn(order[0]) === (count === 1))!;
    const triangle = [edge(i, j), edge(i, k), edge(i, l)];
    return count === 1 ? triangle : triangle.toReversed();
  }
  if (count !== 2) return [];
  const [i, j, k, l] = TWO.find((order) => isIn(order[0]) && isIn(order[1]))!;
  const [ik, il, jl, jk] = [edge(i, k), edge(i, l), edge(j, l), edge(j, k)];
  return [ik, il, jl, ik, jl, jk];
}
