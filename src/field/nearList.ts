/** What a sum of skels is within a cube: terms that are asked, and a polynomial for all others. */
import type { BoundTerm } from './boundTerm.ts';
import type { LeafFrame } from './leafFrame.ts';
import type { Far, Tally } from './near.ts';
import type { Colour } from './node.ts';

/** A term with its number in the sum. */
export interface NearTerm extends BoundTerm {
  readonly number: number;
}

export interface NearList {
  readonly terms: readonly NearTerm[];
  readonly far: Far;
  /** by how much values may be off */
  readonly error: number;
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
  readonly branch: number;
  readonly frame: LeafFrame | null;
  readonly tally: Tally;
  /** of all terms, where they have one */
  readonly plain: Colour | null;
  readonly first: Colour;
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
