/** What the picture does not show of bodies, in words that say what helps: nothing inside, too thin for their cells, gaps that may have closed, no end. */
import { bodyMade } from '../document/bodies.ts';
import { type Document, isImplicit, type Part } from '../document/document.ts';
import { nodeOf } from '../document/solidNode.ts';
import { bindField } from '../field/bind.ts';
import { DRAFT } from '../field/fieldWork.ts';
import type { FieldNode } from '../field/node.ts';
import { FLAWS } from './words.ts';

/** Of a part that is shown. */
export interface Flaw {
  /** id of the part */
  readonly part: string;
  readonly name: string;
  /** `none`: there is nothing to see of it */
  readonly what: 'none' | 'thin' | 'gaps' | 'cut';
  /** a sentence or two, without the name */
  readonly words: string;
}

export type Problem = (node: FieldNode) => string | null;

/** `problem`: why there is no body of a tree, in words. Of drafts nothing is told: they are coarse in any case. */
export function flawsOf(part: Part, problem: Problem): Flaw[] {
  if (!isImplicit(part)) return [];
  const { id, name } = part;
  const node = nodeOf(part);
  const flaw = (what: Flaw['what'], words: string): Flaw => ({ part: id, name, what, words });
  const none = problem(node);
  if (none !== null) return [flaw('none', none)];
  const cut = isEndless(node) ? [flaw('cut', FLAWS.cut)] : [];
  const body = bodyMade(node);
  const thin = body && body.cells > DRAFT ? body.mesh.thin : null;
  if (!thin) return cut;
  const { places, gaps } = thin;
  return [
    ...(places > gaps ? [flaw('thin', FLAWS.thin(places - gaps))] : []),
    ...(gaps > 0 ? [flaw('gaps', FLAWS.gaps(gaps))] : []),
    ...cut,
  ];
}

export const flawsIn = ({ parts }: Document, problem: Problem): Flaw[] =>
  parts.filter(({ hidden }) => !hidden).flatMap((part) => flawsOf(part, problem));

const endless = new WeakMap<FieldNode, boolean>();

function isEndless(node: FieldNode): boolean {
  const known = endless.get(node) ?? bindField(node).box === null;
  endless.set(node, known);
  return known;
}
