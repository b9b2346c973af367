import { compose, type Placement } from '../../math/placement.ts';
import type { Vec3 } from '../../math/vec.ts';
import { isInReach } from '../../stroke/stroke.ts';
import { isSolid, type Part } from '../document.ts';
import { itemsOf } from './changeParts.ts';
import { namer, renumbered } from './duplicateParts.ts';
import type { CommandKind } from './index.ts';

export interface Data {
  readonly parts: readonly Part[];
  /** mm: where they lie, seen from where they were */
  readonly offset: Vec3;
}

/** Parts from a clipboard, of this drawing or another, behind all others in the list. Their ids are new. */
export const paste: CommandKind<'paste', Data> = {
  type: 'paste',
  apply(document, { parts: pasted, offset }) {
    if (pasted.length === 0) return document;
    const freeName = namer(itemsOf(document));
    const by: Placement = { rotation: [0, 0, 0, 1], translation: offset };
    let { nextId } = document;
    const next = (what: string) => `${what}-${nextId++}`;
    const parts = pasted.map((part): Part => {
      const moved = compose(by, part.placement);
      const placement = isInReach(moved.translation) ? moved : part.placement;
      const own = { ...part, id: next('part'), name: freeName(part.name, true), placement };
      return isSolid(own) ? renumbered(own, next) : own;
    });
    return { ...document, parts: [...document.parts, ...parts], nextId };
  },
  describe: (_document, { parts }) =>
    parts.length === 1 ? `${parts[0]!.name} pasted` : `${parts.length} parts pasted`,
};
