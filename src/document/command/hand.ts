/** Strokes in hand go where their part goes: what is done to a part is done alike to what it would be if they were kept now. */
import { type Document, formOfDraft, isSurface, type SurfacePart } from '../document.ts';
import { isFormInReach } from '../inReach.ts';
import { placedStroke } from '../placedStroke.ts';
import { withStrokes } from '../surfacePart.ts';
import { draftWith } from './changeForm.ts';
import { homeOf, recreatedOf } from './keep.ts';
import { isInHand } from './recreate.ts';

/** `change` moves, scales or mirrors parts; one whose strokes in hand cannot follow stays where it is. */
export function withHand(
  document: Document,
  ids: readonly string[],
  change: (document: Document, ids: readonly string[]) => Document,
): Document {
  const part = isInHand(document, ids) ? recreatedOf(document) : null;
  const { draft } = document;
  const next = change(document, ids);
  if (!part || !draft) return next;
  const inHand: SurfacePart = {
    ...part,
    ...withStrokes({ ...formOfDraft(draft), bends: part.bends }, homeOf(part)),
    bends: part.bends,
    brush: document.brush,
  };
  const given = { ...document, parts: document.parts.map((other) => (other === part ? inHand : other)) };
  const found = (of: Document) => of.parts.filter(isSurface).find(({ id }) => id === part.id)!;
  const after = found(change(given, [part.id]));
  const form = withStrokes(after, (stroke) => placedStroke(stroke, after.placement));
  if (found(next) === part || after === inHand || !isFormInReach(form))
    return change(
      document,
      ids.filter((id) => id !== part.id),
    );
  return { ...next, brush: after.brush, draft: draftWith(draft, form) };
}
