/**
 * What a page and the workers that cast rays for it say to each other: every worker hears of the picture, then of jobs, which are parts of it.
 * Plain data; the large arrays are handed over.
 */
import type { Placement } from '../math/placement.ts';
import type { FieldNode } from './node.ts';
import type { RayCamera } from './rayImage.ts';

/** A body in the picture. */
export interface ExactBody {
  /** of the part, which stays when it is edited: then little of the body is located anew */
  readonly name: string;
  /** the same for the same tree: what was located of it is kept */
  readonly key: number;
  readonly node: FieldNode;
  readonly placement: Placement;
  /** of its lattice, along the longest side */
  readonly cells: number;
}

/** A picture of which parts will be wanted; one that was wanted before is given up. */
export interface Cast {
  readonly type: 'cast';
  /** rises from one to the next */
  readonly id: number;
  readonly bodies: readonly ExactBody[];
  /** through the middle of the pixels */
  readonly camera: RayCamera;
}

/** Rays through the middle of the pixels of some rows, from … to below …. */
export interface BandJob {
  readonly type: 'band';
  readonly id: number;
  readonly from: number;
  readonly to: number;
}

/** Rays through another place of some pixels. */
export interface AgainJob {
  readonly type: 'again';
  readonly id: number;
  /** place among OFFSETS */
  readonly offset: number;
  /** of the first of these among all of the picture */
  readonly first: number;
  /** pixels: column + width × row */
  readonly places: Uint32Array<ArrayBuffer>;
}

/** Nothing is wanted any more. */
export interface StopCasting {
  readonly type: 'stop';
  readonly id: number;
}

export type ToExact = Cast | BandJob | AgainJob | StopCasting;

interface OfCast {
  readonly id: number;
}

/** It runs; the first that it says, of no picture. */
interface Begun extends OfCast {
  readonly type: 'begun';
  readonly id: 0;
}

/** Bodies are looked for: 0–1 of the first. */
interface Locating extends OfCast {
  readonly type: 'locating';
  readonly share: number;
}

/** What a job found, four floats a pixel as in RayImage; without arrays where there is nothing. */
export interface Pixels extends OfCast {
  readonly surface: Float32Array<ArrayBuffer> | null;
  readonly colours: Float32Array<ArrayBuffer> | null;
}

export interface Band extends Pixels {
  readonly type: 'band';
  readonly from: number;
  readonly to: number;
  /** pixels of these rows that are to be cast again, as far as these rows tell */
  readonly places: Uint32Array<ArrayBuffer>;
  /** in values of one skel at one point */
  readonly work: number;
}

export interface Again extends Pixels {
  readonly type: 'again';
  readonly offset: number;
  readonly first: number;
  readonly count: number;
}

interface Refused extends OfCast {
  readonly type: 'refused';
  readonly message: string;
}

export type FromExact = Begun | Locating | Band | Again | Refused;
