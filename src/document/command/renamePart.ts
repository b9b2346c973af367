import { changeParts, nameOf } from './changeParts.ts';
import type { CommandKind } from './index.ts';

/** Characters of a part's name. */
export const LONGEST_NAME = 80;

/** A part's name; outer space goes, and an empty name changes nothing. */
export const renamePart: CommandKind<'renamePart', { readonly id: string; readonly name: string }> = {
  type: 'renamePart',
  apply(document, { id, name }) {
    const trimmed = name.trim().slice(0, LONGEST_NAME);
    if (!trimmed) return document;
    return changeParts(document, [id], (part) => (part.name === trimmed ? part : { ...part, name: trimmed }));
  },
  describe: (document, { id }) => `name of ${nameOf(document, [id])}`,
};
