import { compose, type Placement } from '../../math/placement.ts';
import type { Vec3 } from '../../math/vec.ts';
import { isInReach } from '../../stroke/stroke.ts';
import { type Document, isSolid, type Part, type SolidPart } from '../document.ts';
import { type Group, withGroups } from '../solid.ts';
import { itemsOf, nameOf } from './changeParts.ts';
import type { CommandKind } from './index.ts';
import { moved } from './moveParts.ts';
import { cut, LONGEST_NAME } from './renamePart.ts';

export interface Data {
  readonly ids: readonly string[];
  /** mm: where the copies lie, seen from the originals */
  readonly offset: Vec3;
}

/** Copies parts, behind all others in the list; a copy shares the strokes of its original. */
export const duplicateParts: CommandKind<'duplicateParts', Data> = {
  type: 'duplicateParts',
  apply(document, { ids, offset }) {
    const originals = partsOf(document, ids);
    const freeName = namer(itemsOf(document));
    const by: Placement = { rotation: [0, 0, 0, 1], translation: offset };
    let { nextId } = document;
    const next = (what: string) => `${what}-${nextId++}`;
    const copies = originals.map((original): Part => {
      const id = next('part');
      const moved = compose(by, original.placement);
      const placement = isInReach(moved.translation) ? moved : original.placement;
      const copy = { ...original, id, name: freeName(original.name), placement };
      return isSolid(copy) ? renumbered(copy, next) : copy;
    });
    const within = document.parts.map((part) =>
      isSolid(part) ? withCopies(part, ids, by, next, freeName) : part,
    );
    const parts = [...within, ...copies];
    return nextId === document.nextId ? document : { ...document, parts, nextId };
  },
  describe: (document, { ids }) => `${nameOf(document, ids)} duplicated`,
};

/** What is in a copied solid has ids of its own, too. */
export function renumbered(solid: SolidPart, next: (what: string) => string): SolidPart {
  const components = solid.components.map((component) => ({
    ...component,
    id: next('component'),
    groups: component.groups.map((group) => ({ ...group, id: next('group') })),
  }));
  return { ...solid, components };
}

/** Copies of groups stay in their component, and blend with it. */
function withCopies(
  solid: SolidPart,
  ids: readonly string[],
  by: Placement,
  next: (what: string) => string,
  freeName: (name: string) => string,
): SolidPart {
  if (ids.includes(solid.id)) return solid;
  return withGroups(solid, (group) => {
    if (!ids.includes(group.id)) return [group];
    const copy: Group = { ...moved(group, solid, by), id: next('group'), name: freeName(group.name) };
    return [group, copy];
  });
}

/** Ids of the copies, in the document's order. */
export function copiesOf(document: Document, ids: readonly string[]): string[] {
  const before = new Set(itemsOf(document).map(({ id }) => id));
  const after = duplicateParts.apply(document, { ids, offset: [0, 0, 0] });
  const wanted = (id: string) => id.startsWith('part-') || !partsOf(document, ids).length;
  return itemsOf(after)
    .map(({ id }) => id)
    .filter((id) => !before.has(id) && wanted(id));
}

function partsOf({ parts }: Document, ids: readonly string[]): readonly Part[] {
  const wanted = new Set(ids);
  return parts.filter(({ id }) => wanted.has(id));
}

/** "Stem" → "Stem 2", "Stem 2" → "Stem 3": the first number that is free. */
export function namer(
  parts: readonly { readonly name: string }[],
): (name: string, mayStay?: boolean) => string {
  const taken = new Set(parts.map(({ name }) => name));
  // Numbers below are taken: nobody counts from the start again.
  const next = new Map<string, number>();
  return (name, mayStay = false) => {
    if (mayStay && !taken.has(name)) {
      taken.add(name);
      return name;
    }
    const stem = name.replace(/ \d{1,6}$/, '');
    for (let number = next.get(stem) ?? 2; ; number++) {
      const end = ` ${number}`;
      const found = cut(stem, LONGEST_NAME - end.length) + end;
      if (taken.has(found)) continue;
      taken.add(found);
      next.set(stem, number + 1);
      return found;
    }
  };
}
