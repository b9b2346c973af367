import { compose, type Placement } from '../../math/placement.ts';
import type { Vec3 } from '../../math/vec.ts';
import { isInReach } from '../../stroke/stroke.ts';
import { type Document, isSolid, type Part, type SolidPart } from '../document.ts';
import { type Group, withGroups } from '../solid.ts';
import { itemsOf, nameOf } from './changeParts.ts';
import type { CommandKind } from './index.ts';
import { type Mirror, mirrorParts } from './mirrorParts.ts';
import { moved } from './moveParts.ts';
import { cut, LONGEST_NAME } from './renamePart.ts';

export interface Data {
  readonly ids: readonly string[];
  /** mm: where the copies lie, seen from the originals */
  readonly offset: Vec3;
  /** what the copies are mirrored in, where they lie */
  readonly mirror?: Mirror;
}

/** Copies parts, behind all others in the list; a copy shares the strokes of its original. */
export const duplicateParts: CommandKind<'duplicateParts', Data> = {
  type: 'duplicateParts',
  apply(document, { ids, offset, mirror }) {
    const copied = withCopiesOf(document, ids, offset);
    if (!mirror || copied === document) return copied;
    return mirrorParts.apply(copied, { ids: copiesOf(document, ids), ...mirror });
  },
  describe: (document, { ids, mirror }) =>
    `${nameOf(document, ids)} ${mirror ? 'mirrored as a copy' : 'duplicated'}`,
};

function withCopiesOf(document: Document, ids: readonly string[], offset: Vec3): Document {
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
}

/** What is in a copied solid has ids of its own, too. */
export function renumbered(solid: SolidPart, next: (what: string) => string): SolidPart {
  const components = solid.components.map((component) => ({
    ...component,
    id: next('component'),
    groups: component.groups.map((group) => ({ ...group, id: next('group') })),
  }));
  return { ...solid, components };
}

/** Copies of groups stay in their component, and blend with it; those of components stand beside the others. */
function withCopies(
  solid: SolidPart,
  ids: readonly string[],
  by: Placement,
  next: (what: string) => string,
  freeName: (name: string) => string,
): SolidPart {
  if (ids.includes(solid.id)) return solid;
  const copy = (group: Group): Group => ({
    ...moved(group, solid, by),
    id: next('group'),
    name: freeName(group.name),
  });
  const within = withGroups(solid, (group, of) =>
    ids.includes(group.id) && !ids.includes(of.id) ? [group, copy(group)] : [group],
  );
  const copies = solid.components
    .filter(({ id }) => ids.includes(id))
    .map((of) => ({ ...of, id: next('component'), name: freeName(of.name), groups: of.groups.map(copy) }));
  return copies.length > 0 ? { ...within, components: [...within.components, ...copies] } : within;
}

/** Ids of the copies, in the document's order. */
export function copiesOf(document: Document, ids: readonly string[]): string[] {
  const before = new Set(itemsOf(document).map(({ id }) => id));
  const fresh = ({ id }: { readonly id: string }) => !before.has(id);
  return withCopiesOf(document, ids, [0, 0, 0]).parts.flatMap((part) => {
    if (fresh(part)) return [part.id];
    if (!isSolid(part)) return [];
    return part.components.flatMap((of) => (fresh(of) ? [of] : of.groups.filter(fresh)).map(({ id }) => id));
  });
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
