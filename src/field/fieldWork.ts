/** What a page and the worker that makes its bodies say to each other. Plain data; the large arrays are handed over. */
import type { Box } from '../skeleton/skeleton.ts';
import type { FieldMesh } from './brickMesh.ts';
import type { Lattice } from './lattice.ts';
import type { FieldNode } from './node.ts';
import type { PackedBricks, PackedEdit } from './packedBricks.ts';

/** Cells of what is to be seen at once: 20,000 values, some 20 ms for a dozen skels. */
export const DRAFT = 28;

/** A body that is wanted; one that was wanted before is given up. */
export interface Make {
  readonly type: 'make';
  /** rises from one to the next */
  readonly id: number;
  readonly node: FieldNode;
  /** cells along the longest side */
  readonly resolution: number;
  /** who makes the mesh: the worker, or the page on its graphics device, which gets bricks for it or finds them */
  readonly mesh: 'worker' | 'page';
  /**
   * Under which name the body is kept, so that a next one of that name is an edit of it: quicker, but not to the bit what is made at once;
   * null: neither, as files have to be.
   */
  readonly name: string | null;
  /** of a page that makes the mesh: it still has what was handed to it last, so that edits of that will do */
  readonly isHeld?: boolean;
}

/** Nothing is wanted any more, until the next `Make`. */
export interface Stop {
  readonly type: 'stop';
  /** above that of what is given up */
  readonly id: number;
}

export type ToWorker = Make | Stop;

/** 0–1 of the step under way: fitting, culling, meshing */
interface Progress {
  readonly type: 'progress';
  readonly id: number;
  readonly share: number;
}

interface Step {
  readonly id: number;
  /** coarse, to be looked at until the fine one is there */
  readonly draft: boolean;
  /** work so far, in values of one skel at one point (skeleton/work.ts) */
  readonly evaluations: number;
  readonly milliseconds: number;
}

/** The page is to make the mesh of these bricks, or to have its device find them where there are none. */
export interface Located extends Step {
  readonly type: 'bricks';
  readonly node: FieldNode;
  readonly lattice: Lattice;
  /** all of them; of a body that is kept what became of those that were handed over before; null: the device finds them itself */
  readonly bricks: PackedBricks | PackedEdit | null;
  /** edits of them may follow */
  readonly isKept: boolean;
  /** around all that is inside, mm */
  readonly box: Box;
  /** what each vertex adds to the work; what the device finds it counts itself */
  readonly workAVertex: number;
}

export interface Made extends Step {
  readonly type: 'made';
  readonly mesh: FieldMesh;
  readonly lattice: Lattice;
  /** something was kept of the body before */
  readonly isEdit: boolean;
}

/** The tree has no field or no surface, in words with the place. */
interface Refused {
  readonly type: 'refused';
  readonly id: number;
  readonly message: string;
}

export type FromWorker = Progress | Located | Made | Refused;
