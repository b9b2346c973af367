/**
 * Whose surface a place lies on: the skel that adds most to the field there, followed down the tree. Operations hand on shares in the ratio of
 * ∂a and ∂b, as they mix colours (fold.ts); what carves has none in a sum, and the cutter's surface is the cutter's.
 */
import { bindShape } from '../shape/index.ts';
import { type Affine, composed, IDENTITY, inverted, stretches } from './affine.ts';
import { boundTerms, join } from './bind.ts';
import { blendUnion } from './blendUnion.ts';
import { type Kind, signsOf } from './fold.ts';
import { hardUnion } from './hardUnion.ts';
import { LeafFrame } from './leafFrame.ts';
import { morph } from './morph.ts';
import type { FieldNode, SkelsNode } from './node.ts';
import type { Operation } from './operation.ts';
import { smoothUnion } from './smoothUnion.ts';

export interface SkelAt {
  /** in the tree, as messages name places: `parts[1].node.skels[3]`; of a shape its node, '' where that is all of the tree */
  readonly path: string;
  /** of the field there, above 0 to 1 */
  readonly share: number;
}

/** With the value of the tree. */
interface Found extends SkelAt {
  readonly value: number;
}

/** Null where nothing adds to the field, as beyond every support. The tree must be one that `bindField` takes. */
export function skelAt(node: FieldNode, x: number, y: number, z: number): SkelAt | null {
  const { path, share } = follow(node, IDENTITY, '', [x, y, z]);
  return share > 0 ? { path, share } : null;
}

type Place = readonly [x: number, y: number, z: number];

function follow(node: FieldNode, matrix: Affine, path: string, place: Place): Found {
  const child = (inner: FieldNode, name: string) => follow(inner, matrix, join(path, name), place);
  switch (node.type) {
    case 'skels':
      return strongest(node, path, enter(matrix, 1, place));
    case 'shape': {
      const { least } = stretches(matrix);
      const { x, y, z } = enter(matrix, least, place);
      return { value: least * bindShape(node.shape).value(x, y, z), path, share: 1 };
    }
    case 'affine':
      return follow(node.node, composed(matrix, node.matrix), join(path, 'node'), place);
    case 'blend':
      return folded([child(node.a, 'a'), child(node.b, 'b')], blendUnion(node), 'union');
    case 'morph':
      return folded([child(node.from, 'from'), child(node.to, 'to')], morph(node.t), 'union');
    default: {
      const parts = node.parts.map((part, i) => child(part, `parts[${i}]`));
      return folded(parts, node.form === 'hard' ? hardUnion : smoothUnion, node.type);
    }
  }
}

function enter(matrix: Affine, scale: number, place: Place): LeafFrame {
  const frame = new LeafFrame(inverted(matrix), scale);
  frame.enter(...place);
  return frame;
}

function strongest(node: SkelsNode, path: string, { x, y, z }: LeafFrame): Found {
  let [value, sum, most, best] = [-node.threshold, 0, 0, 0];
  for (const [i, term] of node.skels.entries()) {
    // a curve is one skel, of however many pieces
    const own = boundTerms(term, node).reduce(
      (all, { field, factor }) => all + factor * field.value(x, y, z),
      0,
    );
    value += own;
    sum += Math.max(own, 0);
    if (own > most) [most, best] = [own, i];
  }
  return { value, path: join(path, `skels[${best}]`), share: sum > 0 ? most / sum : 0 };
}

/** From the first to the last; of two the one that is left with more. */
function folded(parts: readonly Found[], operation: Operation, kind: Kind): Found {
  const [outer, sign] = signsOf(kind);
  const partials = new Float64Array(3);
  return parts.reduce((first, other) => {
    operation.evaluate(outer * first.value, sign * other.value, partials);
    const [toFirst, toOther] = [Math.max(partials[1]!, 0), Math.max(partials[2]!, 0)];
    const part = toFirst + toOther > 0 ? toOther / (toFirst + toOther) : 0.5;
    const [a, b] = [(1 - part) * first.share, part * other.share];
    const { path } = a >= b ? first : other;
    return { value: outer * partials[0]!, path, share: Math.max(a, b) };
  });
}
