/**
 * The scenes that polygonizing is measured on, as data a document can hold: branching trees of 16, 64 and 178 Cauchy segments of linear
 * weight, sixteen turned copies of the second in one box (1,024), and 200 short ones in a ball that overlap everywhere. Sizes: some 2
 * mm, the 1,024 some 5.
 */

import type { FieldNode, SkelsNode } from '../../../src/field/node.ts';
import type { SegmentSkel } from '../../../src/skeleton/skels.ts';
import blob200 from './blob200.json' with { type: 'json' };
import tree16 from './tree16.json' with { type: 'json' };
import tree64 from './tree64.json' with { type: 'json' };
import tree178 from './tree178.json' with { type: 'json' };
import tree1024 from './tree1024.json' with { type: 'json' };

const STORED = { tree16, tree64, tree178, tree1024, blob200 } as const;

export type SceneName = keyof typeof STORED;

/** A sum of segments. */
export interface SegmentsNode extends SkelsNode {
  readonly skels: readonly { readonly skel: SegmentSkel }[];
}

// files hold arrays, whose lengths the compiler does not know; bindField checks them
export const sceneNode = (name: SceneName): SegmentsNode => STORED[name] as unknown as SegmentsNode;

/** The same limbs by the quartic kernel, whose field ends at R: tubes about as thick. */
export function quarticScene(name: 'tree16' | 'tree64' | 'tree178' | 'tree1024'): SegmentsNode {
  return { ...sceneNode(name), kernel: 'quartic', params: { R: 0.12 }, threshold: 0.098 };
}

/** k: terms of sums, and shapes; none of these scenes has curves, which become several. */
export function skelsOf(node: FieldNode): number {
  switch (node.type) {
    case 'skels':
      return node.skels.length;
    case 'shape':
      return 1;
    case 'affine':
      return skelsOf(node.node);
    case 'blend':
      return skelsOf(node.a) + skelsOf(node.b);
    case 'morph':
      return skelsOf(node.from) + skelsOf(node.to);
    default:
      return node.parts.reduce((sum, part) => sum + skelsOf(part), 0);
  }
}
