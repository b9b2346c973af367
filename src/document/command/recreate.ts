import { type Document, isSurface } from '../document.ts';
import { isFormInReach } from '../inReach.ts';
import { placedStroke } from '../placedStroke.ts';
import { kindOfStrokes, withStrokes } from '../surfacePart.ts';
import { draftWith } from './changeForm.ts';
import { nameOf } from './changeParts.ts';
import type { CommandKind } from './index.ts';
import { keep } from './keep.ts';

export interface Data {
  readonly id: string;
}

/** The strokes of a part are in hand again (thesis A.3): as the unfinished form, where the part is. Keep gives them back to it, drop leaves it as it was. */
export const recreate: CommandKind<'recreate', Data> = {
  type: 'recreate',
  apply(document, { id }) {
    const on = document.draft ? keep.apply(document, {}) : document;
    const part = on.parts.find((other) => other.id === id);
    if (!part || !isSurface(part) || on.draft) return document;
    const form = withStrokes(part, (stroke) => placedStroke(stroke, part.placement));
    if (!isFormInReach(form)) return document;
    const isStepped = part.kind !== kindOfStrokes(part);
    const recreates = { part: id, brush: on.brush };
    const draft = draftWith({ strokes: form.strokes, recreates }, form);
    return { ...on, brush: part.brush, draft: isStepped ? { ...draft, form: part.kind } : draft };
  },
  describe: (document: Document, { id }) => `strokes of ${nameOf(document, [id])} in hand`,
};

/** Strokes of one of these parts are in hand. */
export const isInHand = ({ draft }: Document, ids: readonly string[]): boolean =>
  draft?.recreates !== undefined && ids.includes(draft.recreates.part);
