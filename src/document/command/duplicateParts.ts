import { compose, type Placement } from '../../math/placement.ts';
import type { Vec3 } from '../../math/vec.ts';
import { isInReach } from '../../stroke/stroke.ts';
import type { Document, Part } from '../document.ts';
import { nameOf } from './changeParts.ts';
import type { CommandKind } from './index.ts';
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
    if (originals.length === 0) return document;
    const freeName = namer(document.parts);
    const by: Placement = { rotation: [0, 0, 0, 1], translation: offset };
    const parts = [...document.parts];
    for (const [i, original] of originals.entries()) {
      const id = `part-${document.nextId + i}`;
      const moved = compose(by, original.placement);
      const placement = isInReach(moved.translation) ? moved : original.placement;
      parts.push({ ...original, id, name: freeName(original.name), placement });
    }
    return { ...document, parts, nextId: document.nextId + originals.length };
  },
  describe: (document, { ids }) => `${nameOf(document, ids)} duplicated`,
};

/** Ids of the copies, in the document's order. */
export function copiesOf(document: Document, ids: readonly string[]): string[] {
  return partsOf(document, ids).map((_, i) => `part-${document.nextId + i}`);
}

function partsOf({ parts }: Document, ids: readonly string[]): readonly Part[] {
  const wanted = new Set(ids);
  return parts.filter(({ id }) => wanted.has(id));
}

/** "Stem" → "Stem 2", "Stem 2" → "Stem 3": the first number that is free. */
function namer(parts: readonly Part[]): (name: string) => string {
  const taken = new Set(parts.map(({ name }) => name));
  // Numbers below are taken: nobody counts from the start again.
  const next = new Map<string, number>();
  return (name) => {
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
