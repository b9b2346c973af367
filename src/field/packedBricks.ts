/** Bricks and what is near in each as plain data, which workers hand over and graphics devices read (gpu/polygonize/lists.ts writes them). */
import type { Lattice } from './lattice.ts';

export interface PackedBricks {
  readonly lattice: Lattice;
  /** active ones */
  readonly count: number;
  /** whether smooth fields meet in them, in edges */
  readonly hasCreases: boolean;
  /** as in Bricks */
  readonly grid: Int32Array<ArrayBuffer>;
  /** rows of four words */
  readonly lists: Uint32Array<ArrayBuffer>;
}
