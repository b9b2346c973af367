import type { FieldNode } from '../../field/node.ts';
import { isBody } from '../document.ts';
import { changeParts, nameOf } from './changeParts.ts';
import type { CommandKind } from './index.ts';

export interface Data {
  readonly id: string;
  readonly node: FieldNode;
}

/** A body with another tree, in its place, its colour and name as they are. Parts of strokes stay what they are. */
export const setBody: CommandKind<'setBody', Data> = {
  type: 'setBody',
  apply: (document, { id, node }) =>
    changeParts(document, [id], (part) => (isBody(part) && part.node !== node ? { ...part, node } : part)),
  describe: (document, { id }) => `shape of ${nameOf(document, [id])}`,
};
