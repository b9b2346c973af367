/**
 * Where the surface of a field may be: an octree over the cells of a lattice. Where the field's interval over a cube does not hold 0
 * nothing below it is looked at; the others are halved, down to bricks of four cells, each with what of the field matters there
 * (near.ts). What is culled is proven, and what near lists miss is bounded.
 *
 * Departure from the papers, which sample the whole volume: cost follows the surface. Tried: bricks of two cells (more intervals than
 * they save values) and of eight (more values).
 */
import type { Vec3 } from '../math/vec.ts';
import { BRICK, type Lattice } from './lattice.ts';
import { type Near, Tally } from './near.ts';
import type { TreeField } from './treeField.ts';

/** in the grid of bricks: proven to have one sign everywhere */
export const OUTSIDE = -1;
export const INSIDE = -2;

/** cells: by how much what a brick misses of far skels may move the surface; a proven bound, four to ten times what it does */
export const MISSED = 1.6e-2;

/** places in the octree between two looks at the clock */
const BATCH = 64;

export interface Brick {
  /** in bricks */
  readonly i: number;
  readonly j: number;
  readonly k: number;
  readonly near: Near;
}

export interface Bricks {
  readonly lattice: Lattice;
  /** bricks along x, y, z */
  readonly counts: Vec3;
  /** that may hold surface, by ascending number i + counts[0] (j + counts[1] k) */
  readonly active: readonly Brick[];
  /** of every brick its place in `active`, or OUTSIDE or INSIDE */
  readonly grid: Int32Array;
}

interface Cube {
  /** the first brick, in bricks */
  readonly i: number;
  readonly j: number;
  readonly k: number;
  readonly outer: Near;
}

/** `whole`: the field everywhere. The lattice has whole bricks. Yields what share of the levels is done. */
export function* culling(whole: Near, lattice: Lattice): Generator<number, Bricks> {
  const counts = lattice.counts.map((nodes) => (nodes - 1) / BRICK) as unknown as Vec3;
  const grid = new Int32Array(counts[0] * counts[1] * counts[2]).fill(OUTSIDE);
  let size = 1;
  while (size < Math.max(...counts)) size *= 2;
  let cubes: Cube[] = [{ i: 0, j: 0, k: 0, outer: whole }];
  const active: Brick[] = [];
  for (; ; size /= 2) {
    const next: Cube[] = [];
    for (const [n, { i, j, k, outer }] of cubes.entries()) {
      const near = cubeWithin(outer, lattice, i, j, k, size);
      if (near.high <= 0) continue;
      const isInside = near.low > 0 && !isAtBorder(counts, i, j, k, size);
      if (isInside) fillInside(grid, counts, i, j, k, size);
      else if (size === 1) active.push({ i, j, k, near });
      else next.push(...eighths(i, j, k, size / 2, near, counts));
      if (n % BATCH === BATCH - 1) yield (n / cubes.length + 1) / (2 * size);
    }
    if (size === 1) break;
    cubes = next;
  }
  active.sort((a, b) => numberOf(counts, a) - numberOf(counts, b));
  active.forEach((brick, place) => {
    grid[numberOf(counts, brick)] = place;
  });
  return { lattice, counts, active, grid };
}

/** Whether smooth fields meet in it, in edges. */
export const hasCreases = ({ active }: Pick<Bricks, 'active'>): boolean =>
  active.some(({ near }) => near.branches > 1);

/** Whether smooth fields never meet in it, wherever it is. */
export const isSmooth = (field: TreeField): boolean => field.near(new Tally()).branches === 1;

type At = Pick<Brick, 'i' | 'j' | 'k'>;

const numberOf = ([nx, ny]: Vec3, { i, j, k }: At): number => i + nx * (j + ny * k);

/** What of `outer` matters in the cube of `size` bricks from brick (i, j, k) on. */
export function cubeWithin(
  outer: Near,
  { origin, step }: Lattice,
  i: number,
  j: number,
  k: number,
  size: number,
) {
  const edge = BRICK * step;
  const half = 0.5 * size * edge;
  // what is missed above is missed in all cubes below: half as much a level
  const missed = (MISSED * step) / size;
  return outer.within(
    origin[0] + i * edge + half,
    origin[1] + j * edge + half,
    origin[2] + k * edge + half,
    half * (1 + 1e-12),
    missed,
  );
}

function eighths(i: number, j: number, k: number, half: number, outer: Near, [nx, ny, nz]: Vec3): Cube[] {
  return Array.from({ length: 8 }, (_, corner) => ({
    i: i + (corner & 1) * half,
    j: j + ((corner >> 1) & 1) * half,
    k: k + (corner >> 2) * half,
    outer,
  })).filter((cube) => cube.i < nx && cube.j < ny && cube.k < nz);
}

/** Nothing is known beyond: what is inside there is cut off. */
export function isAtBorder(counts: Vec3, i: number, j: number, k: number, size: number): boolean {
  return [i, j, k].some((at, axis) => at === 0 || at + size >= counts[axis]!);
}

function fillInside(
  grid: Int32Array,
  [nx, ny, nz]: Vec3,
  i: number,
  j: number,
  k: number,
  size: number,
): void {
  for (let z = k; z < Math.min(k + size, nz); z++) {
    for (let y = j; y < Math.min(j + size, ny); y++) {
      const row = nx * (y + ny * z);
      grid.fill(INSIDE, row + i, row + Math.min(i + size, nx));
    }
  }
}

/** Of the 27 bricks around one, itself in the middle, the place in `active`, OUTSIDE, INSIDE, or BEYOND the lattice. */
export function around({ grid, counts: [nx, ny, nz] }: Bricks, { i, j, k }: At, out: Int32Array): void {
  for (let n = 0; n < 27; n++) {
    const x = i + (n % 3) - 1;
    const y = j + (Math.floor(n / 3) % 3) - 1;
    const z = k + Math.floor(n / 9) - 1;
    const isWithin = x >= 0 && y >= 0 && z >= 0 && x < nx && y < ny && z < nz;
    out[n] = isWithin ? grid[x + nx * (y + ny * z)]! : BEYOND;
  }
}

/** beyond the lattice */
export const BEYOND = -3;
