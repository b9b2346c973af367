import type { Stroke } from '../../stroke/stroke.ts';
import type { CommandKind } from './index.ts';

/** A further stroke of the unfinished form. */
export const addStroke: CommandKind<'addStroke', { readonly stroke: Stroke }> = {
  type: 'addStroke',
  apply(document, { stroke }) {
    return { ...document, draft: { strokes: [...(document.draft?.strokes ?? []), stroke] } };
  },
  describe: (document) => `stroke ${(document.draft?.strokes.length ?? 0) + 1}`,
};
