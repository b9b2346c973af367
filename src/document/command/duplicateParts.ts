import { compose, type Placement } from '../../math/placement.ts';
import type { Vec3 } from '../../math/vec.ts';
import { isInReach } from '../../stroke/stroke.ts';
import type { Document, Part } from '../document.ts';
import { nameOf } from './changeParts.ts';
import type { CommandKind } from './index.ts';
import { LONGEST_NAME } from './renamePart.ts';

export interface Data {
  readonly ids: readonly string[];
  /** mm: where the copies lie, seen from the originals */
  readonly offset: Vec3;
}

/** Copies parts, behind all others in the list; a copy shares the strokes of its original. */
export const duplicateParts: CommandKind<'duplicateParts', Data> = {
  type: 'duplicateParts',
  apply(document, { ids, offset }) {
    const originals = document.parts.filter(({ id }) => ids.includes(id));
    if (originals.length === 0) return document;
    const by: Placement = { rotation: [0, 0, 0, 1], translation: offset };
    const parts = [...document.parts];
    for (const [i, original] of originals.entries()) {
      const id = `part-${document.nextId + i}`;
      const moved = compose(by, original.placement);
      const placement = isInReach(moved.translation) ? moved : original.placement;
      parts.push({ ...original, id, name: freeName(original.name, parts), placement });
    }
    return { ...document, parts, nextId: document.nextId + originals.length };
  },
  describe: (document, { ids }) => `${nameOf(document, ids)} duplicated`,
};

/** Ids of the copies, in the document's order. */
export function copiesOf(document: Document, ids: readonly string[]): string[] {
  const originals = document.parts.filter(({ id }) => ids.includes(id));
  return originals.map((_, i) => `part-${document.nextId + i}`);
}

/** "Stem" → "Stem 2", "Stem 2" → "Stem 3": the first number that is free. */
function freeName(name: string, parts: readonly Part[]): string {
  const taken = new Set(parts.map((part) => part.name));
  const stem = name.replace(/ \d{1,6}$/, '');
  for (let number = 2; ; number++) {
    const end = ` ${number}`;
    const found = stem.slice(0, LONGEST_NAME - end.length) + end;
    if (!taken.has(found)) return found;
  }
}
