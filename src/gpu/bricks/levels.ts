/**
 * The levels of cubes on the device, from 8 bricks along to one, and how much room each has: a header a cube, then entries. The last
 * has its headers twice: as they come, and first of all in the order of the grid.
 */
import { MISSED } from '../../field/bricks.ts';
import type { Lattice } from '../../field/lattice.ts';
import { record } from '../../math/record.ts';
import { ASKED_A_VERTEX } from '../polygonize/work.ts';

export const LEVEL = record('Level', {
  number: 'u32',
  /** bricks along a cube */
  size: 'u32',
  /** of the first header of its own, and how many there is room for */
  slots: 'u32',
  room: 'u32',
  /** row of the first entry, and beyond the last */
  entries: 'u32',
  end: 'u32',
  /** of the records: where leaves begin */
  leaves: 'u32',
  /** mm: what is missed of far skels may move the surface by */
  allowed: 'f32',
});

export const SIZES = [8, 4, 2, 1] as const;

/** What a level needs or has room for. */
export interface LevelRoom {
  readonly cubes: number;
  /** of entries, 16 bytes each */
  readonly rows: number;
}

/** bytes */
export const ROW = 16;

/** Two a level, then the work of culling in parts of a value, and what a value asks in all active bricks together. */
export const COUNTERS = 2 * SIZES.length + 2;
/** parts of the work, as in shaders/bricks/cull.wgsl */
const PARTS = 20;
/** that a brick owns, of its 125: 70 to 79 in all scenes of the bench */
const NODES = 75;

export interface Level {
  readonly room: LevelRoom;
  readonly bytes: ArrayBuffer;
  /** of its lists */
  readonly rows: number;
}

export function levelsOf({ step }: Lattice, rooms: readonly LevelRoom[], leaves: number): readonly Level[] {
  const slotsOf = (depth: number) => (SIZES[depth] === 1 ? rooms[depth]!.cubes : 0);
  return rooms.map((room, depth) => {
    const slots = slotsOf(depth);
    const entries = slots + room.cubes;
    const end = entries + room.rows;
    const size = SIZES[depth]!;
    const level = { number: depth, size, slots, room: room.cubes, entries, end, leaves };
    return { room, rows: end, bytes: LEVEL.pack([{ ...level, allowed: (MISSED * step) / size }]) };
  });
}

/** cubes along x, y, z */
export function alongOf({ counts }: Lattice, size: number): readonly [number, number, number] {
  const along = (nodes: number) => Math.ceil((nodes - 1) / 4 / size);
  return [along(counts[0]), along(counts[1]), along(counts[2])];
}

/** Of the counters: what every level needed. */
export const neededRooms = (counters: Uint32Array): readonly LevelRoom[] =>
  SIZES.map((_, depth) => ({ cubes: counters[2 * depth]!, rows: counters[2 * depth + 1]! }));

/** Of culling, values and vertices: what the device asked of skels, in values of one skel at one point, nearly. */
export function workOf(counters: Uint32Array, vertices: number): number {
  const [bricks, , parts, asked] = counters.subarray(COUNTERS - 4);
  const aVertex = (ASKED_A_VERTEX * asked!) / Math.max(1, bricks!);
  return Math.round(parts! / PARTS + NODES * asked! + aVertex * vertices);
}

export const overflows = (rooms: readonly LevelRoom[], needed: readonly LevelRoom[]): boolean =>
  rooms.some(({ cubes, rows }, i) => needed[i]!.cubes > cubes || needed[i]!.rows > rows);
