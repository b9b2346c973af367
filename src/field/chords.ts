/**
 * Where lines of a lattice pass through something thin: two vertices of a mesh that follow each other on a line, with one or two of its nodes in
 * between. Those are inside, or outside where what is thin is a gap.
 */
import { EdgeTable } from './edgeTable.ts';
import type { Lattice } from './lattice.ts';

/** x, y, z a vertex. */
export interface Surface {
  readonly positions: ArrayLike<number>;
  readonly normals: ArrayLike<number>;
}

/** Vertices p and q, in this order on the line; `node`, the first between them, and as the case may be the next, `stride` farther. */
export interface Chord {
  readonly p: number;
  readonly q: number;
  readonly node: number;
  readonly nodes: 1 | 2;
  readonly stride: number;
  readonly isGap: boolean;
}

/** A vertex is farther from the ends of its edge than from the edge (edgePoint.ts), so that its place tells which that is. */
const BESIDE = 0.5;

/** `surface`: vertices of a mesh that was made on `lattice`. */
export function eachChord(surface: Surface, lattice: Lattice, found: (chord: Chord) => void): void {
  const [nx, ny] = lattice.counts;
  const strides = [1, nx, nx * ny] as const;
  const count = surface.positions.length / 3;
  const entering = new Int32Array(count);
  const leaving = new EdgeTable();
  for (let vertex = 0; vertex < count; vertex++) {
    const edge = isCopied(surface.positions, vertex) ? -1 : edgeOf(surface.positions, vertex, lattice);
    const isLeaving = edge >= 0 && surface.normals[3 * vertex + (edge % 3)]! > 0;
    if (isLeaving) leaving.set(edge, vertex);
    entering[vertex] = isLeaving ? -1 : edge;
  }
  for (let vertex = 0; vertex < count; vertex++) {
    const edge = entering[vertex]!;
    if (edge < 0) continue;
    const stride = strides[edge % 3]!;
    const start = (edge - (edge % 3)) / 3;
    for (const nodes of [1, 2] as const) {
      const other = leaving.get(edge + 3 * nodes * stride);
      if (other < 0) continue;
      found({ p: vertex, q: other, node: start + stride, nodes, stride, isGap: false });
      break;
    }
    for (const nodes of [1, 2] as const) {
      const other = edge < 3 * nodes * stride ? -1 : leaving.get(edge - 3 * nodes * stride);
      if (other < 0) continue;
      found({ p: other, q: vertex, node: start - (nodes - 1) * stride, nodes, stride, isGap: true });
      break;
    }
  }
}

/** Points on creases are there once a side, one after the other, and lie on no edge. */
const isCopied = (positions: ArrayLike<number>, vertex: number): boolean =>
  isSame(positions, vertex, vertex - 1) || isSame(positions, vertex, vertex + 1);

const isSame = (positions: ArrayLike<number>, a: number, b: number): boolean =>
  positions[3 * a] === positions[3 * b] &&
  positions[3 * a + 1] === positions[3 * b + 1] &&
  positions[3 * a + 2] === positions[3 * b + 2];

/** axis + 3 times the number of its first node; −1 for what is on none. */
function edgeOf(positions: ArrayLike<number>, vertex: number, { origin, step, counts }: Lattice): number {
  const x = (positions[3 * vertex]! - origin[0]) / step;
  const y = (positions[3 * vertex + 1]! - origin[1]) / step;
  const z = (positions[3 * vertex + 2]! - origin[2]) / step;
  const [i, j, k] = [Math.round(x), Math.round(y), Math.round(z)];
  const [dx, dy, dz] = [Math.abs(x - i), Math.abs(y - j), Math.abs(z - k)];
  const axis = dx > dy && dx > dz ? 0 : dy > dz ? 1 : 2;
  const off = axis === 0 ? Math.max(dy, dz) : axis === 1 ? Math.max(dx, dz) : Math.max(dx, dy);
  if (!(off <= BESIDE * (axis === 0 ? dx : axis === 1 ? dy : dz))) return -1;
  const node =
    (axis === 0 ? Math.floor(x) : i) +
    counts[0] * ((axis === 1 ? Math.floor(y) : j) + counts[1] * (axis === 2 ? Math.floor(z) : k));
  return axis + 3 * node;
}
