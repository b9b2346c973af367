/** How much room levels of cubes are given: a guess at first, then what bodies on lattices of that size have needed. */
import type { Lattice } from '../../field/lattice.ts';
import { alongOf, type LevelRoom, SIZES } from './levels.ts';

/** of the bricks on three sides of the lattice: trees of 64 segments take three quarters, spheres that fill it three halves */
const SURFACE = 0.75;
/** bodies grow under the pen */
const MORE = 1.25;

export class Rooms {
  /** by the size of lattices, in octaves of bricks */
  readonly #known = new Map<number, readonly LevelRoom[]>();

  /** `rows`: entries of a cube that knows nothing yet. */
  of(lattice: Lattice, rows: number): readonly LevelRoom[] {
    const first = firstRooms(lattice, rows);
    const known = this.#known.get(sizeOf(lattice));
    const rooms = known ? eachOf(first, known, Math.max) : first;
    this.#known.set(sizeOf(lattice), rooms);
    return rooms;
  }

  /** More, where more was needed; what came after a level that was too small is not known yet. */
  grow(lattice: Lattice, needed: readonly LevelRoom[]): void {
    const rooms = this.#known.get(sizeOf(lattice));
    if (rooms) this.#known.set(sizeOf(lattice), grownRooms(rooms, needed));
  }
}

export function firstRooms(lattice: Lattice, rows: number): readonly LevelRoom[] {
  return SIZES.map((size, depth) => {
    const [x, y, z] = alongOf(lattice, size);
    const surface = Math.ceil(SURFACE * (x * y + y * z + z * x));
    const cubes = depth === 0 ? x * y * z : Math.min(x * y * z, surface);
    return { cubes, rows: cubes * Math.min(rows, Math.ceil(rows / 2 ** depth) + 8) };
  });
}

export const grownRooms = (rooms: readonly LevelRoom[], needed: readonly LevelRoom[]): readonly LevelRoom[] =>
  eachOf(rooms, needed, (room, most) => (most > room ? Math.ceil(MORE * most) : room));

function eachOf(
  a: readonly LevelRoom[],
  b: readonly LevelRoom[],
  of: (a: number, b: number) => number,
): readonly LevelRoom[] {
  return a.map(({ cubes, rows }, i) => ({ cubes: of(cubes, b[i]!.cubes), rows: of(rows, b[i]!.rows) }));
}

const sizeOf = (lattice: Lattice): number => {
  const [x, y, z] = alongOf(lattice, 1);
  return Math.round(Math.log2(x * y * z));
};
