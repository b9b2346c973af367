/** What a page and the worker that makes its bodies say to each other. Plain data; the large arrays are handed over. */
import type { Box } from '../skeleton/skeleton.ts';
import type { FieldMesh } from './brickMesh.ts';
import type { Lattice } from './lattice.ts';
import type { FieldNode } from './node.ts';
import type { PackedBricks } from './packedBricks.ts';

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
  /** Of the body before what stays may be kept, on its lattice: quicker, but not to the bit what is made anew, as files have to be. */
  readonly isEdited: boolean;
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
  readonly bricks: PackedBricks | null;
  /** around all that is inside, mm */
  readonly box: Box;
  /** what each vertex adds to the work; what the device finds it counts itself */
  readonly workAVertex: number;
}

export interface Made extends Step {
  readonly type: 'made';
  readonly mesh: FieldMesh;
  readonly lattice: Lattice;
  /** whether smooth pieces of it meet in edges: such bodies the worker makes, whoever was to */
  readonly hasCreases: boolean;
}

/** The tree has no field or no surface, in words with the place. */
interface Refused {
  readonly type: 'refused';
  readonly id: number;
  readonly message: string;
}

export type FromWorker = Progress | Located | Made | Refused;
