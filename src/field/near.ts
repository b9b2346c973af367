/**
 * A field as it is within a cube: what its values may be there, and evaluators that ask only what matters there. An octree hands
 * it down from cubes to the cubes within them, so that a small one never looks at all skels.
 */

import type { Vec3 } from '../math/vec.ts';
import type { FieldValue } from '../skeleton/skeleton.ts';
import type { Taylor } from '../skeleton/taylor.ts';
import type { BrickNodes } from './brickNodes.ts';
import type { Colour } from './node.ts';

/** Counts what is asked, in values of one skel (skeleton/work.ts), and numbers the leaves. One for a whole tree. */
export class Tally {
  work = 0;
  leaves = 0;
}

export interface Near {
  /** all values in the cube lie between them */
  readonly low: number;
  readonly high: number;
  /** by how much values may be off in the cube */
  readonly error: number;
  /** skels that a value asks */
  readonly asked: number;
  /** how many smooth fields its values come from; they change at creases */
  readonly branches: number;
  /** the colour that it has everywhere; null where that is not known */
  readonly plain: Colour | null;
  value(x: number, y: number, z: number): number;
  evaluate(x: number, y: number, z: number, out: FieldValue): void;
  /** Writes red, green, blue and returns the value. */
  colour(x: number, y: number, z: number, out: Float64Array): number;
  /** Which of the smooth fields the value is from, or would be if it were 0. */
  branch(x: number, y: number, z: number): number;
  /** Value and gradient of that field, also beyond the crease. */
  onBranch(branch: number, x: number, y: number, z: number, out: FieldValue): void;
  /** In a cube within this one, about (x, y, z) with edges of 2 `half`; surfaces may be off by `missed` mm, nearly. */
  within(x: number, y: number, z: number, half: number, missed: number): Near;
  /**
   * Writes the values at the 125 corners of a brick's cells, interpolated between its nodes where that is possible, and says by
   * how much they may be off for that, as far as the nodes tell.
   */
  corners(nodes: BrickNodes, out: Float64Array): number;
  /** Every leaf of the tree once, also those that were left out. */
  eachLeaf(visit: (leaf: NearLeaf) => void): void;
  /** All leaves so that the whole is far above or below 0. */
  eachDropped(way: Way, visit: (leaf: NearLeaf) => void): void;
}

export type Way = 'low' | 'high';

/** A sum or a shape as it is within a cube. */
export interface NearLeaf {
  /** its number, in the order of the tree */
  readonly leaf: number;
  /** far from 0, so that others decide; null where it counts */
  readonly dropped: Way | null;
  /** numbers of the terms that are asked, ascending; null for shapes */
  readonly terms: readonly number[] | null;
  readonly far: Far | null;
}

/** All other terms of a sum together, less T, in the frame of the leaf. */
export interface Far {
  readonly centre: Vec3;
  readonly taylor: Taylor;
  /** what they weigh in the mean of colours at the centre, and red, green, blue times that */
  readonly colour: Float64Array;
}
