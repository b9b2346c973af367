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
