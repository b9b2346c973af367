import { type Document, isSolid, type Part } from '../document.ts';
import { type Component, type Group, withGroups } from '../solid.ts';

/**
 * Changes the parts with these ids; the same document when none of them changes. Ids of groups and components stand for what is in them:
 * `changeGroup` says what becomes of each, and of the groups of a chosen solid where `change` has no answer of its own.
 */
export function changeParts(
  document: Document,
  ids: readonly string[],
  change: (part: Part) => Part,
  changeGroup: (group: Group, of: Part) => Group | null = (group) => group,
): Document {
  const chosen = new Set(ids);
  const parts = document.parts.flatMap((part): readonly Part[] => {
    if (chosen.has(part.id)) return [change(part)];
    if (!isSolid(part)) return [part];
    const isChosen = (group: Group, of: Component) => chosen.has(group.id) || chosen.has(of.id);
    const changed = withGroups(part, (group, of) => {
      const next = isChosen(group, of) ? changeGroup(group, part) : group;
      return next ? [next] : [];
    });
    return changed.components.length > 0 ? [changed] : [];
  });
  return isSame(parts, document.parts) ? document : { ...document, parts };
}

const isSame = (a: readonly Part[], b: readonly Part[]): boolean =>
  a.length === b.length && a.every((part, i) => part === b[i]);

/** What has a name: parts, components, groups, from the top down. */
export function itemsOf({ parts }: Document): readonly { readonly id: string; readonly name: string }[] {
  return parts.flatMap((part) => [
    part,
    ...(isSolid(part) ? part.components.flatMap((component) => [component, ...component.groups]) : []),
  ]);
}

/** "Stem", or "3 parts". */
export function nameOf(document: Document, ids: readonly string[]): string {
  const chosen = new Set(ids);
  const named = itemsOf(document).filter(({ id }) => chosen.has(id));
  return named.length === 1 ? named[0]!.name : `${named.length} parts`;
}
