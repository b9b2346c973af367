import { compose, isUnmoved, type Placement } from '../../math/placement.ts';
import { isInReach } from '../../stroke/stroke.ts';
import { changeParts, nameOf } from './changeParts.ts';
import type { CommandKind } from './index.ts';

export interface Data {
  readonly ids: readonly string[];
  /** a rigid motion of the model's space, on top of where the parts are */
  readonly by: Placement;
}

/** Moves and turns parts; the strokes stay as they were drawn. A part does not leave the space there is. */
export const moveParts: CommandKind<'moveParts', Data> = {
  type: 'moveParts',
  apply(document, { ids, by }) {
    if (isUnmoved(by)) return document;
    return changeParts(document, ids, (part) => {
      const placement = compose(by, part.placement);
      return isInReach(placement.translation) ? { ...part, placement } : part;
    });
  },
  describe: (document, { ids }) => `${nameOf(document, ids)} moved`,
};
