/**
 * Where a mesh is thinner than the cells that it was made in: two crossings that follow each other on a line of the lattice, into the
 * body and out of it again. With points p, q and normals m, n the thickness there is 2 (q − p)·(n − m) / |n − m|², exact for plates,
 * cylinders and balls, however the line passes through them. Nothing is asked of the field.
 *
 * Tried: the distance along the line times the normal's part along it, which takes caps of balls for thin places.
 */
import type { Vec3 } from '../math/vec.ts';
import type { Lattice } from './lattice.ts';

/** A place, and how thick the body is there, mm. */
export interface ThinSpot {
  readonly at: Vec3;
  readonly thickness: number;
}

/** x, y, z a vertex. */
export interface Surface {
  readonly positions: ArrayLike<number>;
  readonly normals: ArrayLike<number>;
}

/** Cells: needles of less than √2 fall into pieces, plates of less than 1. */
export const THIN = 1.5;
/** cosine between the normals of both sides: of edges of more than 37° lines cut off next to nothing */
const OPPOSITE = -0.8;
/** A vertex is farther from the ends of its edge than from the edge (edgePoint.ts), so that its place tells which that is. */
const BESIDE = 0.5;

/** `surface`: vertices of a mesh that was made on `lattice`. */
export function thinWalls(surface: Surface, lattice: Lattice): ThinSpot[] {
  const [nx, ny] = lattice.counts;
  const strides = [3, 3 * nx, 3 * nx * ny] as const;
  const count = surface.positions.length / 3;
  const edges = new Int32Array(count);
  const leaving = new Map<number, number>();
  for (let vertex = 0; vertex < count; vertex++) {
    const edge = isCopied(surface.positions, vertex) ? -1 : edgeOf(surface.positions, vertex, lattice);
    const isLeaving = edge >= 0 && surface.normals[3 * vertex + (edge % 3)]! > 0;
    if (isLeaving) leaving.set(edge, vertex);
    edges[vertex] = isLeaving ? -1 : edge;
  }
  const spots: ThinSpot[] = [];
  for (let vertex = 0; vertex < count; vertex++) {
    const edge = edges[vertex]!;
    if (edge < 0) continue;
    const stride = strides[edge % 3]!;
    const other = leaving.get(edge + stride) ?? leaving.get(edge + 2 * stride);
    if (other === undefined) continue;
    const spot = between(surface, vertex, other);
    if (spot && spot.thickness > 0 && spot.thickness < THIN * lattice.step) spots.push(spot);
  }
  return spots;
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

/** Of vertices p and q; null where their sides do not lie against each other. */
export function between({ positions, normals }: Surface, p: number, q: number): ThinSpot | null {
  let [along, apart2, cosine] = [0, 0, 0];
  for (let axis = 0; axis < 3; axis++) {
    const [m, n] = [normals[3 * p + axis]!, normals[3 * q + axis]!];
    along += (positions[3 * q + axis]! - positions[3 * p + axis]!) * (n - m);
    apart2 += (n - m) * (n - m);
    cosine += m * n;
  }
  if (!(cosine < OPPOSITE)) return null;
  const middle = (axis: 0 | 1 | 2) => (positions[3 * p + axis]! + positions[3 * q + axis]!) / 2;
  return { at: [middle(0), middle(1), middle(2)], thickness: (2 * along) / apart2 };
}
