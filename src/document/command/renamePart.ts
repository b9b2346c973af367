import { changeParts, nameOf } from './changeParts.ts';
import type { CommandKind } from './index.ts';

/** Characters of a part's name. */
export const LONGEST_NAME = 80;

/** A part's name; outer space goes, and an empty name changes nothing. */
export const renamePart: CommandKind<'renamePart', { readonly id: string; readonly name: string }> = {
  type: 'renamePart',
  apply(document, { id, name }) {
    const trimmed = cut(name.trim());
    if (!trimmed) return document;
    return changeParts(document, [id], (part) => (part.name === trimmed ? part : { ...part, name: trimmed }));
  },
  describe: (document, { id }) => `name of ${nameOf(document, [id])}`,
};

/** No half of a character stays at the end. */
export function cut(name: string, length = LONGEST_NAME): string {
  return name
    .slice(0, length)
    .replace(/[\ud800-\udbff]$/, '')
    .trimEnd();
}
