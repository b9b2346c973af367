/**
 * A regular lattice of points around a body, and a field's values there. Kept apart from what is made of the values, so that
 * they may come from elsewhere, such as the GPU. Node (i, j, k) is number i + nx (j + ny k).
 */
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

/** What values are taken of. */
interface Valued {
  value(x: number, y: number, z: number): number;
}

/** of each node; float64 from the CPU, float32 from the GPU */
export type LatticeValues = Float64Array | Float32Array;

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
 * a lattice, which is where the cube ends.
 */
export function latticeOver(half: number, resolution: number): Lattice {
  const cells = wholeBricks(cellsOf(resolution) + 1);
  const step = (2 * half) / (cells - 1);
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

/** x, y, z of every node, for evaluators that take lists. */
export function latticePoints(lattice: Lattice): Float32Array {
  const { origin, step, counts } = lattice;
  const points = new Float32Array(3 * nodeCount(lattice));
  eachRow(lattice, 0, counts[2], (first, y, z) => {
    for (let i = 0, at = 3 * first; i < counts[0]; i++) {
      points[at++] = origin[0] + i * step;
      points[at++] = y;
      points[at++] = z;
    }
  });
  return points;
}

/** nodes at which values are compared */
const SAMPLES = 256;

/** How far values from elsewhere are from the field's at most, among some nodes; in parts of the value where that is above 1. */
export function largestDifference(field: Valued, lattice: Lattice, values: LatticeValues): number {
  const { origin, step, counts } = lattice;
  const apart = Math.max(1, Math.floor(values.length / SAMPLES));
  let most = 0;
  for (let node = 0; node < values.length; node += apart) {
    const row = Math.floor(node / counts[0]);
    const [i, j, k] = [node % counts[0], row % counts[1], Math.floor(row / counts[1])];
    const exact = field.value(origin[0] + i * step, origin[1] + j * step, origin[2] + k * step);
    most = Math.max(most, Math.abs(values[node]! - exact) / Math.max(1, Math.abs(exact)));
  }
  return most;
}

/** Evaluates layer by layer and yields what share of them is done. */
export function* sampling(field: Valued, lattice: Lattice): Generator<number, Float64Array> {
  const { origin, step, counts } = lattice;
  const values = new Float64Array(nodeCount(lattice));
  for (let k = 0; k < counts[2]; k++) {
    eachRow(lattice, k, k + 1, (first, y, z) => {
      for (let i = 0; i < counts[0]; i++) values[first + i] = field.value(origin[0] + i * step, y, z);
    });
    yield (k + 1) / counts[2];
  }
  return values;
}

function eachRow(
  { origin, step, counts }: Lattice,
  from: number,
  to: number,
  visit: (first: number, y: number, z: number) => void,
): void {
  for (let k = from; k < to; k++) {
    for (let j = 0; j < counts[1]; j++) {
      visit(counts[0] * (j + counts[1] * k), origin[1] + j * step, origin[2] + k * step);
    }
  }
}
