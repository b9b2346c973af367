/** What a page and the worker that makes its bodies say to each other. Plain data; the large arrays are handed over. */

import type { FieldMesh } from './brickMesh.ts';
import type { Lattice } from './lattice.ts';
import type { FieldNode } from './node.ts';

/** A body that is wanted; one that was wanted before is given up. */
export interface Make {
  readonly type: 'make';
  /** rises from one to the next */
  readonly id: number;
  readonly node: FieldNode;
  /** cells along the longest side */
  readonly resolution: number;
  /** who takes the values on the lattice: the worker, or the page, which is asked for them */
  readonly values: 'worker' | 'page';
}

/** The answer to `Wanted`; null where there are none: the worker takes its own. */
export interface Values {
  readonly type: 'values';
  readonly id: number;
  readonly values: Float32Array | null;
}

/** Nothing is wanted any more, until the next `Make`. */
export interface Stop {
  readonly type: 'stop';
  /** above that of what is given up */
  readonly id: number;
}

export type ToWorker = Make | Values | Stop;

/** 0–1 of the step under way: fitting, sampling, meshing */
interface Progress {
  readonly type: 'progress';
  readonly id: number;
  readonly share: number;
}

/** The page is to send the values on this lattice. */
export interface Wanted {
  readonly type: 'wanted';
  readonly id: number;
  readonly lattice: Lattice;
}

export interface Made {
  readonly type: 'made';
  readonly id: number;
  /** coarse, to be looked at until the fine one is there */
  readonly draft: boolean;
  readonly mesh: FieldMesh;
  readonly lattice: Lattice;
  readonly evaluations: number;
  /** largest difference of the page's values from the worker's own, among some nodes; null where it took them all itself */
  readonly difference: number | null;
  readonly milliseconds: number;
}

/** The tree has no field or no surface, in words with the place. */
interface Refused {
  readonly type: 'refused';
  readonly id: number;
  readonly message: string;
}

export type FromWorker = Progress | Wanted | Made | Refused;
