/**
 * What is in a body, in ConvMo's words (Tai et al. 2004): a component is a convolution sum, whose groups blend; a group has the
 * skels of one form. A sum of a tree is one group. Curves count as one skel each; shapes are none.
 */

import type { FieldNode } from '../field/node.ts';
import { type BodyPart, isSolid, type SolidPart } from './document.ts';
import { groupsOf } from './solid.ts';
import { nodeOf } from './solidNode.ts';

export interface BodyCounts {
  readonly components: number;
  readonly groups: number;
  readonly skels: number;
}

export const NO_BODY: BodyCounts = { components: 0, groups: 0, skels: 0 };

export function bodyCounts(node: FieldNode): BodyCounts {
  switch (node.type) {
    case 'skels':
      return { components: 1, groups: 1, skels: node.skels.length };
    case 'shape':
      return NO_BODY;
    case 'blend':
      return sumOf([node.a, node.b].map(bodyCounts));
    case 'morph':
      return sumOf([node.from, node.to].map(bodyCounts));
    case 'affine':
      return bodyCounts(node.node);
    default:
      return sumOf(node.parts.map(bodyCounts));
  }
}

/** Of a solid, what strokes say: its components and groups, and what skels are made of them. */
export function countsOfPart(part: BodyPart | SolidPart): BodyCounts {
  const counts = bodyCounts(nodeOf(part));
  if (!isSolid(part)) return counts;
  return { components: part.components.length, groups: groupsOf(part).length, skels: counts.skels };
}

export const sumOf = (counts: readonly BodyCounts[]): BodyCounts =>
  counts.reduce(
    (sum, { components, groups, skels }) => ({
      components: sum.components + components,
      groups: sum.groups + groups,
      skels: sum.skels + skels,
    }),
    NO_BODY,
  );
