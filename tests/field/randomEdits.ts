/** Edits of trees drawn by lot: somewhere in the tree a term or a part comes, goes or becomes another. */
import type { FieldNode, SetNode, SkelsNode } from '../../src/field/node.ts';
import type { Lot } from './lot.ts';
import { randomTree } from './randomTrees.ts';

export function randomEdit(lot: Lot, node: FieldNode): FieldNode {
  switch (node.type) {
    case 'skels':
      return { ...node, skels: edited(lot, node.skels, () => likeTerm(lot, node)) };
    case 'shape':
      return lot.is(0.5) ? node : { ...node, colour: lot.colour() };
    case 'affine':
      return lot.is(0.3)
        ? { ...node, matrix: node.matrix.with(3, node.matrix[3] + lot.between(-0.2, 0.2)) as never }
        : { ...node, node: randomEdit(lot, node.node) };
    case 'blend':
      return lot.is(0.5) ? { ...node, a: randomEdit(lot, node.a) } : { ...node, b: randomEdit(lot, node.b) };
    case 'morph':
      return { ...node, to: randomEdit(lot, node.to) };
    default:
      return editedSet(lot, node);
  }
}

function editedSet(lot: Lot, node: SetNode): SetNode {
  if (lot.is(0.4) && node.parts.length > 1) {
    return { ...node, parts: edited(lot, node.parts, () => randomTree(lot, 1)) };
  }
  const at = Math.floor(lot.between(0, node.parts.length));
  return { ...node, parts: node.parts.with(at, randomEdit(lot, node.parts[at]!)) };
}

/** One more, one less or another one; never none. */
function edited<T>(lot: Lot, list: readonly T[], make: () => T): T[] {
  const at = Math.floor(lot.between(0, list.length));
  const what = lot.one(['more', 'less', 'other'] as const);
  if (what === 'more') return list.toSpliced(at + 1, 0, make());
  return what === 'less' && list.length > 1 ? list.toSpliced(at, 1) : list.with(at, make());
}

/** A point a bit off a term of the body, where it is likely to matter. */
function likeTerm(lot: Lot, { skels }: SkelsNode): SkelsNode['skels'][number] {
  const term = lot.one(skels);
  if (term.skel.type !== 'segment') return term;
  const { a, b } = term.skel;
  const [dx, dy, dz] = lot.direction();
  return { ...term, skel: { ...term.skel, a, b: [b[0] + dx, b[1] + dy, b[2] + dz] } };
}
