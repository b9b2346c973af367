import { type Document, isSolid } from '../document.ts';
import { nameOf } from './changeParts.ts';
import type { CommandKind } from './index.ts';

/** Characters of a part's name. */
export const LONGEST_NAME = 80;

/** A part's name; outer space goes, and an empty name changes nothing. */
export const renamePart: CommandKind<'renamePart', { readonly id: string; readonly name: string }> = {
  type: 'renamePart',
  apply(document, { id, name }) {
    const trimmed = cut(name.trim());
    if (!trimmed) return document;
    return renamed(document, id, trimmed);
  },
  describe: (document, { id }) => `name of ${nameOf(document, [id])}`,
};

/** A part, a component or a group. */
function renamed(document: Document, id: string, name: string): Document {
  const named = <T extends { readonly id: string; readonly name: string }>(item: T): T =>
    item.id === id && item.name !== name ? { ...item, name } : item;
  const parts = document.parts.map((part) => {
    if (!isSolid(part)) return named(part);
    const components = each(part.components, (component) => {
      const groups = each(component.groups, named);
      return named(groups === component.groups ? component : { ...component, groups });
    });
    return named(components === part.components ? part : { ...part, components });
  });
  return parts.every((part, i) => part === document.parts[i]) ? document : { ...document, parts };
}

function each<T>(items: readonly T[], change: (item: T) => T): readonly T[] {
  const changed = items.map(change);
  return changed.every((item, i) => item === items[i]) ? items : changed;
}

/** No half of a character stays at the end. */
export function cut(name: string, length = LONGEST_NAME): string {
  return name
    .slice(0, length)
    .replace(/[\ud800-\udbff]$/, '')
    .trimEnd();
}
