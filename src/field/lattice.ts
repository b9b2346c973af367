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

const wholeBricks = (cells: number): number => BRICK * Math.ceil(cells / BRICK);

function cellsOf(resolution: number): number {
  return Math.min(Math.max(Math.round(resolution), RESOLUTION.min), RESOLUTION.max) || RESOLUTION.min;
}

export function nodeCount({ counts }: Lattice): number {
  return counts[0] * counts[1] * counts[2];
}
