/**
 * The nodes of a tree with numbers that stay when it is edited, parts come and go: leaves from 0 on, sets of several parts from −1 down, in the
 * order of the tree. What holds a single node has the number of that.
 */
import type { FieldNode } from './node.ts';

export interface Numbered {
  readonly node: FieldNode;
  readonly number: number;
  readonly parts: readonly Numbered[];
}

/** In the order of the tree, for `Tally.numbers`. */
export interface Numbers {
  readonly leaves: readonly number[];
  readonly sets: readonly number[];
}

/** The numbers that come next. */
export class Supply {
  leaf = 0;
  set = -1;
}

/** All of it new. */
export function numbered(node: FieldNode, next: Supply): Numbered {
  const inner = partsOf(node);
  const own = inner.length === 0 ? next.leaf++ : inner.length > 1 ? next.set-- : null;
  const parts = inner.map((part) => numbered(part, next));
  return { node, number: own ?? parts[0]!.number, parts };
}

export function numbersIn(root: Numbered): Numbers {
  const [leaves, sets]: [number[], number[]] = [[], []];
  const visit = ({ number, parts }: Numbered) => {
    if (parts.length === 0) leaves.push(number);
    if (parts.length > 1) sets.push(number);
    parts.forEach(visit);
  };
  visit(root);
  return { leaves, sets };
}

/** The nodes within a node; none in leaves. */
export function partsOf(node: FieldNode): readonly FieldNode[] {
  switch (node.type) {
    case 'skels':
    case 'shape':
      return [];
    case 'affine':
      return [node.node];
    case 'blend':
      return [node.a, node.b];
    case 'morph':
      return [node.from, node.to];
    default:
      return node.parts;
  }
}
