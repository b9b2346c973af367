/**
 * Where the surface of a field may be: an octree over the cells of a lattice. Where the field's interval over a cube does not hold 0
 * nothing below it is looked at; the others are halved, down to bricks of four cells, each with what of the field matters there
 * (near.ts). What is culled is proven, and what near lists miss is bounded.
 *
 * Departure from the papers, which sample the whole volume: cost follows the surface. Tried: bricks of two cells (more intervals than
 * they save values) and of eight (more values).
 */
import type { Vec3 } from '../math/vec.ts';
import type { Box } from '../skeleton/skeleton.ts';
import { BRICK, type Lattice } from './lattice.ts';
import { type Near, Tally } from './near.ts';
import type { TreeField } from './treeField.ts';

/** in the grid of bricks: proven to have one sign everywhere */
export const OUTSIDE = -1;
export const INSIDE = -2;

/**
 * Cells: by how much what a brick misses of far skels may move the surface; a proven bound, four to ten times what it does. 1.6e-2 took 4 %
 * more work, 3e-2 more again for vertices that are not sure (edgePoint.ts).
 */
export const MISSED = 2e-2;

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
  readonly grid: Int32Array<ArrayBuffer>;
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
  const counts = countsOf(lattice);
  const grid = new Int32Array(counts[0] * counts[1] * counts[2]).fill(OUTSIDE);
  let size = 1;
  while (size < Math.max(...counts)) size *= 2;
  let cubes: Cube[] = [{ i: 0, j: 0, k: 0, outer: whole }];
  const active: Brick[] = [];
  for (; ; size /= 2) {
    const next: Cube[] = [];
    for (const [n, { i, j, k, outer }] of cubes.entries()) {
      const near = cubeWithin(outer, lattice, i, j, k, size);
      const state = stateOf(near, counts, i, j, k, size);
      if (state === INSIDE) fillInside(grid, counts, i, j, k, size);
      else if (state !== OUTSIDE && size === 1) active.push({ i, j, k, near });
      else if (state !== OUTSIDE) addEighths(next, i, j, k, size / 2, near, counts);
      if (n % BATCH === BATCH - 1) yield (n / cubes.length + 1) / (2 * size);
    }
    if (size === 1) break;
    cubes = next;
  }
  return inOrder(lattice, active, grid);
}

/** With their places in the grid, where all else is told already. */
export function inOrder(lattice: Lattice, active: Brick[], grid: Int32Array<ArrayBuffer>): Bricks {
  const counts = countsOf(lattice);
  active.sort((a, b) => numberOf(counts, a) - numberOf(counts, b));
  active.forEach((brick, place) => {
    grid[numberOf(counts, brick)] = place;
  });
  return { lattice, counts, active, grid };
}

/** Bricks along x, y, z. */
export const countsOf = ({ counts }: Lattice): Vec3 => [
  (counts[0] - 1) / BRICK,
  (counts[1] - 1) / BRICK,
  (counts[2] - 1) / BRICK,
];

/** Whether smooth fields meet in it, in edges. */
export const hasCreases = (active: readonly { readonly near: Pick<Near, 'branches'> }[]): boolean =>
  active.some(({ near }) => near.branches > 1);

/** Around all that may hold surface; of nothing the origin of the lattice. */
export function brickBox({ lattice: { origin, step }, active }: Pick<Bricks, 'lattice' | 'active'>): Box {
  const [min, max] = [[...origin], [...origin]] as [[number, number, number], [number, number, number]];
  active.forEach(({ i, j, k }, place) => {
    [i, j, k].forEach((at, axis) => {
      const low = origin[axis]! + at * BRICK * step;
      min[axis] = place === 0 ? low : Math.min(min[axis]!, low);
      max[axis] = place === 0 ? low + BRICK * step : Math.max(max[axis]!, low + BRICK * step);
    });
  });
  return { min, max };
}

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
  const missed = Math.min(MISSED * step, outer.mostMissed) / size;
  return outer.within(
    origin[0] + i * edge + half,
    origin[1] + j * edge + half,
    origin[2] + k * edge + half,
    half * (1 + 1e-12),
    missed,
  );
}

/** The first bricks of those parts of a cube, of `half` bricks each, that are not beyond the lattice. */
export function eighths(i: number, j: number, k: number, half: number, counts: Vec3): readonly Vec3[] {
  const parts = Array.from(
    { length: 8 },
    (_, corner): Vec3 => [i + (corner & 1) * half, j + ((corner >> 1) & 1) * half, k + (corner >> 2) * half],
  );
  return parts.filter((part) => part.every((at, axis) => at < counts[axis]! && at + half > 0));
}

/** The same, without arrays. */
function addEighths(
  cubes: Cube[],
  i: number,
  j: number,
  k: number,
  half: number,
  outer: Near,
  [nx, ny, nz]: Vec3,
): void {
  for (let z = k; z <= k + half && z < nz; z += half) {
    for (let y = j; y <= j + half && y < ny; y += half) {
      for (let x = i; x <= i + half && x < nx; x += half) cubes.push({ i: x, j: y, k: z, outer });
    }
  }
}

/** OUTSIDE, INSIDE, or 0 where a cube may hold surface. Nothing is known beyond the lattice: what is inside at its border is cut off. */
export function stateOf(near: Near, counts: Vec3, i: number, j: number, k: number, size: number): number {
  if (near.high <= 0) return OUTSIDE;
  const isAtBorder = [i, j, k].some((at, axis) => at <= 0 || at + size >= counts[axis]!);
  return near.low > 0 && !isAtBorder ? INSIDE : 0;
}

/** A cube of the lattice. */
export function fillInside(
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
