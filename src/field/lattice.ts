/** A regular lattice of points around a body. Node (i, j, k) is number i + nx (j + ny k). */
import type { Vec3 } from '../math/vec.ts';
import { type Box, FieldError } from '../skeleton/skeleton.ts';

export interface Lattice {
  /** the first node, mm */
  readonly origin: Vec3;
  /** mm between neighbours, the same in all directions */
  readonly step: number;
  /** nodes along x, y, z */
  readonly counts: readonly [x: number, y: number, z: number];
}

/** cells of a brick along each side: lattices have whole ones */
export const BRICK = 4;
export const RESOLUTION = { min: 4, max: 512 } as const;

/** Air around the box in steps. No whole number: bodies are symmetric about their boxes, and would pass exactly through nodes. */
const AIR = 1.27;

/** `resolution` cells along the longest side of the box. FieldError for a box that is not finite. */
export function latticeAround({ min, max }: Box, resolution: number): Lattice {
  const sizes = [max[0] - min[0], max[1] - min[1], max[2] - min[2]] as const;
  if (!sizes.every((size) => size >= 0 && size < Infinity) || !min.every(Number.isFinite))
    throw new FieldError('the body is not bounded by finite numbers');
  // a box of one point holds no surface, but has a lattice all the same
  const step = Math.max(...sizes) / cellsOf(resolution) || 1;
  const count = (size: number) => wholeBricks(size / step + 2 * AIR) + 1;
  return {
    origin: [min[0] - AIR * step, min[1] - AIR * step, min[2] - AIR * step],
    step,
    counts: [count(sizes[0]), count(sizes[1]), count(sizes[2])],
  };
}

/** A lattice with more bricks around it. */
export interface Grown {
  readonly lattice: Lattice;
  /** how many of them come before its first one, along x, y, z */
  readonly before: Vec3;
}

/** The same nodes and as many bricks more as it takes to hold the box; null where it does. */
export function latticeGrown({ origin, step, counts }: Lattice, { min, max }: Box): Grown | null {
  const edge = BRICK * step;
  const bricks = (length: number) => Math.max(0, Math.ceil(length / edge));
  const end = (axis: 0 | 1 | 2) => origin[axis] + (counts[axis] - 1) * step;
  const low = (axis: 0 | 1 | 2) => bricks(origin[axis] - (min[axis] - AIR * step));
  const high = (axis: 0 | 1 | 2) => bricks(max[axis] + AIR * step - end(axis));
  const before: Vec3 = [low(0), low(1), low(2)];
  const after: Vec3 = [high(0), high(1), high(2)];
  if (![...before, ...after].some((more) => more > 0)) return null;
  const first = (axis: 0 | 1 | 2) => origin[axis] - before[axis] * edge;
  const count = (axis: 0 | 1 | 2) => counts[axis] + BRICK * (before[axis] + after[axis]);
  return {
    lattice: { origin: [first(0), first(1), first(2)], step, counts: [count(0), count(1), count(2)] },
    before,
  };
}

/** How many nodes of `after` come before the first of `before`, along x, y, z: both have the same nodes, as far as they go. */
export function nodesBefore(before: Lattice, after: Lattice): Vec3 {
  const more = (axis: 0 | 1 | 2) => Math.round((before.origin[axis] - after.origin[axis]) / after.step);
  return [more(0), more(1), more(2)];
}

/**
 * Over the cube of `half` mm to all sides of the origin, for bodies that go on beyond it: they are cut off half a cell within
 * a lattice, which is where the cube ends, or a quarter of a cell farther, so that no node is in the middle.
 */
export function latticeOver(half: number, resolution: number): Lattice {
  const cells = wholeBricks(cellsOf(resolution) + AIR);
  const step = (2 * half) / (cells - AIR);
  const first = -half - step / 2;
  return { origin: [first, first, first], step, counts: [cells + 1, cells + 1, cells + 1] };
}

/** 2⁻²³: of their size, how far neighbours of float32 are apart; 2⁻¹²⁶: the smallest; 2¹²⁷: nearly the largest */
const APART = 1.1920929e-7;
const SMALLEST = 1.1754944e-38;
const LARGEST = 1.7e38;
/** of those in a cell: with fewer vertices fall into one place */
const FEWEST = 16;

/** FieldError where the numbers of a mesh, float32, cannot tell the cells of a lattice apart: bodies far off for their size, or below all sizes. */
export function checkTold({ origin, step, counts }: Lattice): void {
  const ends = origin.map((first, axis) => Math.max(Math.abs(first), Math.abs(first + step * counts[axis]!)));
  const far = Math.max(...ends);
  const grain = Math.max(APART * far, SMALLEST);
  if (far < LARGEST && step > FEWEST * grain) return;
  const [cell, off, apart] = [step, far, grain].map((mm) => `${Number(mm.toPrecision(2))} mm`);
  throw new FieldError(
    `no mesh can hold it: its cells are ${cell}, but up to ${off} from the origin numbers of a mesh are ${apart} apart`,
  );
}

const wholeBricks = (cells: number): number => BRICK * Math.ceil(cells / BRICK);

function cellsOf(resolution: number): number {
  return Math.min(Math.max(Math.round(resolution), RESOLUTION.min), RESOLUTION.max) || RESOLUTION.min;
}
