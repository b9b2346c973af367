import { compose, isUnmoved, type Placement, unplaced } from '../../math/placement.ts';
import { isInReach } from '../../stroke/stroke.ts';
import type { Part } from '../document.ts';
import { placedStroke } from '../placedStroke.ts';
import type { Group } from '../solid.ts';
import { changeParts, nameOf } from './changeParts.ts';
import { withHand } from './hand.ts';
import type { CommandKind } from './index.ts';

export interface Data {
  readonly ids: readonly string[];
  /** a rigid motion of the model's space, on top of where the parts are */
  readonly by: Placement;
}

/** Moves and turns parts, the strokes stay as they were drawn; groups of a solid with the plane of their strokes. Nothing leaves the space there is. */
export const moveParts: CommandKind<'moveParts', Data> = {
  type: 'moveParts',
  apply(document, { ids, by }) {
    if (isUnmoved(by)) return document;
    const placed = (part: Part): Part => {
      const placement = compose(by, part.placement);
      return isInReach(placement.translation) ? { ...part, placement } : part;
    };
    return withHand(document, ids, (on, chosen) =>
      changeParts(on, chosen, placed, (group, of) => moved(group, of, by)),
    );
  },
  describe: (document, { ids }) => `${nameOf(document, ids)} moved`,
};

/** `by` is of the model's space, and the group is placed within its solid. */
export function moved(group: Group, { placement }: Part, by: Placement): Group {
  const within = compose(unplaced(placement), compose(by, placement));
  const strokes = group.strokes.map((stroke) => placedStroke(stroke, within));
  return strokes.every(({ plane }) => isInReach(plane.origin)) ? { ...group, strokes } : group;
}
