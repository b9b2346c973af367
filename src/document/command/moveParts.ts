import { compose, type Placement } from '../../math/placement.ts';
import { changeParts, nameOf } from './changeParts.ts';
import type { CommandKind } from './index.ts';

interface Data {
  readonly ids: readonly string[];
  /** a rigid motion of the model's space, on top of where the parts are */
  readonly by: Placement;
}

/** Moves and turns parts; the strokes stay as they were drawn. */
export const moveParts: CommandKind<'moveParts', Data> = {
  type: 'moveParts',
  apply(document, { ids, by }) {
    if (isUnmoved(by)) return document;
    return changeParts(document, ids, (part) => ({ ...part, placement: compose(by, part.placement) }));
  },
  describe: (document, { ids }) => `${nameOf(document, ids)} moved`,
};

function isUnmoved({ rotation, translation }: Placement): boolean {
  return Math.abs(rotation[3]) === 1 && translation.every((value) => value === 0);
}
