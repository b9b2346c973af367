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

/** What became of bricks by an edit, on the same lattice: those that are not among `renewed` have the lists that they had. */
export interface PackedEdit {
  /** as in Bricks, of all that there are now */
  readonly grid: Int32Array<ArrayBuffer>;
  /** whether smooth fields meet in any of them now */
  readonly hasCreases: boolean;
  /** places of those that were made anew, ascending */
  readonly renewed: Uint32Array<ArrayBuffer>;
  /** rows of four words: of those alone */
  readonly lists: Uint32Array<ArrayBuffer>;
}
