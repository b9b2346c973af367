/** A skel in a sum, ready to be asked. */
import type { SkelField } from '../skeleton/skeleton.ts';
import type { Colour } from './node.ts';

export interface BoundTerm {
  readonly field: SkelField;
  readonly factor: number;
  readonly colour: Colour;
}

/** of T: what adds less has no colour */
export const UNSEEN = 1e-3;

/** How fine a sum is. */
export interface Grain {
  /** mm: nodes that are farther apart than most of it say nothing of what is between them */
  readonly width: number;
  /** of the field about its surface, nearly, a millimetre */
  readonly slope: number;
}
