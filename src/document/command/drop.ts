import type { Document } from '../document.ts';
import type { CommandKind } from './index.ts';

/** The whole unfinished form goes, in one undo step; a part whose strokes were in hand is as it was. */
export const drop: CommandKind<'drop', object> = {
  type: 'drop',
  apply(document) {
    const { draft, brush } = document;
    return draft ? { ...document, draft: null, brush: draft.recreates?.brush ?? brush } : document;
  },
  describe: () => 'drop',
};

/** Strokes in hand go with their part. */
export function withoutHand(document: Document): Document {
  const { draft, parts } = document;
  const isGone = draft?.recreates && !parts.some(({ id }) => id === draft.recreates!.part);
  return isGone ? drop.apply(document, {}) : document;
}
