/** What an octree over a lattice leaves for those who take values: the bricks that may hold surface, each with what is near there. */
import type { Vec3 } from '../math/vec.ts';
import type { Lattice } from './lattice.ts';

/** cells of a brick along each side */
export const BRICK = 4;
/** Of bricks that are not active: all nodes of one sign, proven. */
export const OUTSIDE = -1;
export const INSIDE = -2;

export interface Bricks {
  /** Cells: a multiple of 4 along each axis. The nodes of its border count as outside, so that INSIDE bricks are none of its own. */
  readonly lattice: Lattice;
  /** those that may hold surface, ascending by number i + bx (j + by k), bx = (counts[0] − 1)/4 */
  readonly active: readonly Brick[];
  /** of all bricks: the place in `active`, or OUTSIDE, or INSIDE */
  readonly grid: Int32Array;
}

export interface Brick {
  readonly i: number;
  readonly j: number;
  readonly k: number;
  readonly near: BrickNear;
}

export interface BrickNear {
  /** by how much the lists may be off: smaller values are doubtful */
  readonly error: number;
  /** Every leaf of the tree once, in the tree's order. */
  eachLeaf(visit: (leaf: NearLeaf | DroppedLeaf) => void): void;
}

export interface NearLeaf {
  /** in the order in which bindField meets leaves, from 0 */
  readonly leaf: number;
  /** of a sum: those that are asked, ascending; null: a shape, asked as a whole */
  readonly terms: readonly number[] | null;
  readonly far: Far | null;
}

/** A leaf that cannot be the surface there: −1e30 or 1e30 stands for it. */
export interface DroppedLeaf {
  readonly leaf: number;
  readonly dropped: 'low' | 'high';
}

/** All other terms of a sum together, less T, in the leaf's own frame. */
export interface Far {
  readonly centre: Vec3;
  /** of 1, x, y, z, x², y², z², xy, yz, zx about the centre */
  readonly coefficients: Float64Array;
  /** what they weigh in the mean colour, and red, green, blue times that */
  readonly colour: Float64Array;
}
