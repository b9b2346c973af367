/** A tree without what the device leaves to the CPU to cull (src/gpu/bricks/cullsOnDevice.ts). */
import type { FieldNode, Term } from '../../../src/field/node.ts';
import { kernelNamed } from '../../../src/kernel/index.ts';
import type { Kernel } from '../../../src/kernel/kernel.ts';

export function plain(node: FieldNode): FieldNode {
  switch (node.type) {
    case 'skels':
      return { ...node, skels: node.skels.map((term) => plainTerm(term, kernelNamed(node.kernel)!)) };
    case 'shape':
      return node;
    case 'affine':
      return { ...node, node: plain(node.node) };
    case 'blend':
      return { ...node, a: plain(node.a), b: plain(node.b) };
    case 'morph':
      return { ...node, from: plain(node.from), to: plain(node.to) };
    default:
      return { ...node, parts: node.parts.map(plain) };
  }
}

/** A plate of a singular kernel becomes its middle. */
function plainTerm(term: Term, { homogeneity }: Kernel): Term {
  const { skel } = term;
  if (skel.type !== 'polygon' || homogeneity === 0) return term;
  return { ...term, skel: { type: 'point', at: skel.origin, weight: skel.weight } };
}
