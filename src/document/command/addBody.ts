import type { FieldNode } from '../../field/node.ts';
import { UNMOVED } from '../../math/placement.ts';
import { WORD } from '../words.ts';
import type { CommandKind } from './index.ts';
import { cut } from './renamePart.ts';

export interface Data {
  readonly node: FieldNode;
  /** "Body 3" when left out or empty */
  readonly name?: string;
  /** #rrggbb of all of it; without it: as the tree is painted */
  readonly colour?: string;
}

/** A body becomes a part, behind all others in the list; the unfinished form stays as it is. */
export const addBody: CommandKind<'addBody', Data> = {
  type: 'addBody',
  apply(document, { node, name = '', colour }) {
    const { nextId } = document;
    const part = {
      id: `part-${nextId}`,
      name: cut(name.trim()) || `${WORD.body} ${nextId}`,
      kind: 'body',
      node,
      colour: colour ?? null,
      placement: UNMOVED,
      hidden: false,
    } as const;
    return { ...document, parts: [...document.parts, part], nextId: nextId + 1 };
  },
  describe: (_document, { name }) => `${name?.trim() || WORD.body.toLowerCase()} added`,
};
