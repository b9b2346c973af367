/**
 * How much of what a surface may be off by each leaf of a tree may miss: what parts miss is stretched by the operations that it passes
 * through. Twin of what field/nearSet.ts hands down to its parts.
 */
import { blendUnion } from '../../field/blendUnion.ts';
import { hardUnion } from '../../field/hardUnion.ts';
import { morph } from '../../field/morph.ts';
import type { FieldNode } from '../../field/node.ts';
import type { Operation } from '../../field/operation.ts';
import { smoothUnion } from '../../field/smoothUnion.ts';

/** In the order of the leaves. */
export function sharesOf(node: FieldNode, share = 1): readonly number[] {
  switch (node.type) {
    case 'skels':
    case 'shape':
      return [share];
    case 'affine':
      return sharesOf(node.node, share);
    case 'blend':
      return among([node.a, node.b], blendUnion(node), share);
    case 'morph':
      return among([node.from, node.to], morph(node.t), share);
    default:
      return among(node.parts, node.form === 'hard' ? hardUnion : smoothUnion, share);
  }
}

function among(parts: readonly FieldNode[], operation: Operation, share: number): readonly number[] {
  if (operation === hardUnion) return parts.flatMap((part) => sharesOf(part, share));
  return parts.flatMap((part, i) => {
    const passed = i === 0 ? parts.length - 1 : parts.length - i;
    return sharesOf(part, share / (parts.length * operation.stretch ** passed));
  });
}
