/** What the skels of a body become: points, segments and polygons, in the order of its terms. */
import { kernelNamed } from '../kernel/index.ts';
import type { Skel } from '../skeleton/skels.ts';
import { expanded } from './expand.ts';
import type { SkelsNode, Term } from './node.ts';

export interface Piece {
  readonly skel: Skel;
  /** whose it is, and its number among the pieces of that term */
  readonly term: Term;
  readonly number: number;
}

/** By the width of the kernel that each term has. FieldError for what cannot be followed. */
export const piecesOf = ({ skels, kernel, params, threshold }: SkelsNode): readonly Piece[] =>
  skels.flatMap((term) =>
    expanded(term.skel, kernelNamed(kernel)!, term.params ?? params, threshold).map((skel, number) => ({
      skel,
      term,
      number,
    })),
  );
