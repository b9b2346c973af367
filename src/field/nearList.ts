/** What a sum of skels is within a cube: terms that are asked, and a polynomial for all others. */
import type { Vec3 } from '../math/vec.ts';
import type { BoundTerm } from './boundTerm.ts';
import type { LeafFrame } from './leafFrame.ts';
import type { Far, Tally } from './near.ts';
import type { Colour } from './node.ts';
import type { SumSight } from './sumSight.ts';

/** A term with its number in the sum. */
export interface NearTerm extends BoundTerm {
  readonly number: number;
}

/** What the polynomial of one cube's far terms misses, and what those of the cubes around it do. */
export interface Missed {
  readonly at: Vec3;
  /** of the ball in which that holds */
  readonly radius: number;
  readonly error: number;
  readonly outer: Missed | null;
}

export interface NearList {
  readonly terms: readonly NearTerm[];
  readonly far: Far;
  /** by how much values may be off */
  readonly error: number;
  /** of that, what came in each cube */
  readonly missed: Missed | null;
  /** all values lie between them */
  readonly low: number;
  readonly high: number;
}

/** What is the same for all cubes. */
export interface WholeSum {
  readonly threshold: number;
  /** of the kernel in the world, mm */
  readonly width: number;
  /** of the field on the surface, nearly: T a millimetre */
  readonly steep: number;
  readonly leaf: number;
  readonly frame: LeafFrame | null;
  readonly tally: Tally;
  /** of all terms, where they have one */
  readonly plain: Colour | null;
  /** whether it is known how what is missed falls within a ball */
  readonly isCubic: boolean;
  readonly first: Colour;
  readonly sight: SumSight;
}

/** parts of what is missed that do not fall with the distance: of sources (skeleton/spread.ts) */
const SOURCES = 0.1;

/** At a place; a Taylor remainder of power kernels is a sum of third and higher powers of the distance from the centre. */
export function missedAt(missed: Missed | null, x: number, y: number, z: number): number {
  let sum = 0;
  for (let one = missed; one; one = one.outer) {
    const { at, radius, error } = one;
    const dx = x - at[0];
    const dy = y - at[1];
    const dz = z - at[2];
    const t = Math.min(1, Math.sqrt(dx * dx + dy * dy + dz * dz) / radius);
    sum += error * (SOURCES + (1 - SOURCES) * t * t * t);
  }
  return sum;
}

/** A running sum that does not overflow where singular fields are large: what counts are ratios. */
export function addColour(mean: Float64Array, seen: number, colour: Colour): void {
  if (!(seen > 0)) return;
  const weight = Math.min(seen, 1e100);
  mean[0] = mean[0]! + weight;
  mean[1] = mean[1]! + weight * colour[0];
  mean[2] = mean[2]! + weight * colour[1];
  mean[3] = mean[3]! + weight * colour[2];
}
