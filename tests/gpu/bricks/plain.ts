/** A tree without what the device leaves to the CPU to cull (src/gpu/bricks/cullsOnDevice.ts). */
import type { FieldNode, Term } from '../../../src/field/node.ts';

export function plain(node: FieldNode): FieldNode {
  switch (node.type) {
    case 'skels':
      return { ...node, skels: node.skels.map(plainTerm) };
    case 'shape':
      return node.shape.type === 'ellipsoid' || node.shape.type === 'quadric'
        ? { ...node, shape: { type: 'sphere', radius: 6 } }
        : node;
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

/** Without its section; a plate becomes its middle. */
function plainTerm({ warp: _, ...term }: Term): Term {
  const { skel } = term;
  return skel.type === 'polygon'
    ? { ...term, skel: { type: 'point', at: skel.origin, weight: skel.weight } }
    : term;
}
