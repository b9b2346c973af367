/** What a page and the worker that casts rays for it say to each other. Plain data; the large arrays are handed over. */
import type { Placement } from '../math/placement.ts';
import type { FieldNode } from './node.ts';
import type { Recast } from './rayEdges.ts';
import type { RayCamera } from './rayImage.ts';

/** A body in the picture. */
export interface ExactBody {
  /** the same for the same tree: what was located of it is kept */
  readonly key: number;
  readonly node: FieldNode;
  readonly placement: Placement;
  /** of its lattice, along the longest side */
  readonly cells: number;
}

/** A picture that is wanted; one that was wanted before is given up. */
export interface Cast {
  readonly type: 'cast';
  /** rises from one to the next */
  readonly id: number;
  readonly bodies: readonly ExactBody[];
  /** through the middle of the pixels */
  readonly camera: RayCamera;
}

/** Nothing is wanted any more. */
export interface StopCasting {
  readonly type: 'stop';
  readonly id: number;
}

export type ToExact = Cast | StopCasting;

interface OfCast {
  readonly id: number;
}

/** Bodies are looked for, or rows cast: 0–1 of the first. */
interface Locating extends OfCast {
  readonly type: 'locating';
  readonly share: number;
}

/** Rows of the image, from … to below …; those between what came before and these hold nothing. */
export interface Rows extends OfCast {
  readonly type: 'rows';
  readonly from: number;
  readonly to: number;
  /** of all rows */
  readonly share: number;
  readonly surface: Float32Array<ArrayBuffer>;
  readonly colours: Float32Array<ArrayBuffer>;
}

/** The first image is whole; these pixels are cast again. */
interface Edges extends OfCast {
  readonly type: 'edges';
  readonly places: Uint32Array<ArrayBuffer>;
  /** for the first image, in values of one skel at one point, of each pixel */
  readonly evaluationsAPixel: number;
  readonly milliseconds: number;
}

interface Again extends OfCast {
  readonly type: 'again';
  readonly recast: Recast;
}

interface Refused extends OfCast {
  readonly type: 'refused';
  readonly message: string;
}

export type FromExact = Locating | Rows | Edges | Again | Refused;
