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

/** of each node; float64 from the CPU, float32 from the GPU */
export type LatticeValues = Float64Array | Float32Array;

/** 32 MiB of values in float64; finer ones are made coarser until they fit */
export const MOST_NODES = 1 << 22;
export const RESOLUTION = { min: 4, max: 512 } as const;

/** Air around the box in steps. No whole number: bodies are symmetric about their boxes, and would pass exactly through nodes. */
const AIR = 1.27;

/** `resolution` cells along the longest side of the box. FieldError for a box that is not finite. */
export function latticeAround({ min, max }: Box, resolution: number): Lattice {
  const sizes = [max[0] - min[0], max[1] - min[1], max[2] - min[2]] as const;
  if (!sizes.every((size) => size >= 0 && size < Infinity) || !min.every(Number.isFinite))
    throw new FieldError('the body is not bounded by finite numbers');
  const cells = Math.min(Math.max(Math.round(resolution), RESOLUTION.min), RESOLUTION.max) || RESOLUTION.min;
  // a box of one point holds no surface, but has a lattice all the same
  let step = Math.max(...sizes) / cells || 1;
  const count = (size: number) => Math.ceil(size / step + 2 * AIR) + 1;
  while (count(sizes[0]) * count(sizes[1]) * count(sizes[2]) > MOST_NODES) step *= 1.05;
  return {
    origin: [min[0] - AIR * step, min[1] - AIR * step, min[2] - AIR * step],
    step,
    counts: [count(sizes[0]), count(sizes[1]), count(sizes[2])],
  };
}

export function nodeCount({ counts }: Lattice): number {
  return counts[0] * counts[1] * counts[2];
}

/** x, y, z of every node, for evaluators that take lists. */
export function latticePoints(lattice: Lattice): Float32Array {
  const points = new Float32Array(3 * nodeCount(lattice));
  eachRow(lattice, 0, lattice.counts[2], (first, y, z) => {
    for (let i = 0; i < lattice.counts[0]; i++) {
      points.set([lattice.origin[0] + i * lattice.step, y, z], 3 * (first + i));
    }
  });
  return points;
}

/** Evaluates layer by layer and yields what share of them is done. */
export function* sampling(
  field: { value(x: number, y: number, z: number): number },
  lattice: Lattice,
): Generator<number, Float64Array> {
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
