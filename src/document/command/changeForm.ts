import { type Document, type Draft, formOfDraft, isSurface, type SurfacePart } from '../document.ts';
import { areInReach } from '../inReach.ts';
import { LIMITS } from '../limits.ts';
import { isPlainDetail, kindOfStrokes, PLAIN, type SurfaceForm, strokesOfForm } from '../surfacePart.ts';
import { changeParts } from './changeParts.ts';

/** Whose strokes are meant: those of a kept part, or, without an id, of the unfinished form. */
export interface Whose {
  readonly part?: string;
}

/** The strokes of a part or of the unfinished form; null where there is none, or it is no surface. */
export function formIn({ parts, draft }: Document, { part: id }: Whose): SurfaceForm | null {
  if (id === undefined) return draft && formOfDraft(draft);
  const part = parts.find((other) => other.id === id);
  return part && isSurface(part) ? part : null;
}

/** With other strokes: what it is follows from their number. Null, or the same form, changes nothing; neither does what no file could hold. */
export function changeForm(
  document: Document,
  { part }: Whose,
  change: (form: SurfaceForm) => SurfaceForm | null,
): Document {
  if (part !== undefined)
    return changeParts(document, [part], (found) => (isSurface(found) ? changedPart(found, change) : found));
  const { draft } = document;
  if (!draft) return document;
  const form = formOfDraft(draft);
  const next = change(form);
  return !next || next === form || !fits(next) ? document : { ...document, draft: draftWith(draft, next) };
}

function changedPart(part: SurfacePart, change: (form: SurfaceForm) => SurfaceForm | null): SurfacePart {
  const next = change(part);
  if (!next || next === part || !fits(next)) return part;
  const { strokes, sections, back, between, bends, detail } = next;
  const isCounted = strokes.length !== part.strokes.length || sections.length !== part.sections.length;
  const kind = isCounted ? kindOfStrokes(next) : part.kind;
  return { ...part, kind, strokes, sections, back, between, bends, detail };
}

const fits = (form: SurfaceForm): boolean =>
  form.sections.length <= LIMITS.sections &&
  form.bends.length <= LIMITS.bends &&
  form.sections.every(({ redraws }) => redraws.length <= LIMITS.redraws) &&
  areInReach(strokesOfForm(form));

/** What says nothing is left out; more sections than before end that a person stepped back. */
export function draftWith(draft: Draft, { strokes, sections, back, between, detail }: SurfaceForm): Draft {
  const { form, sections: _s, back: _b, between: _w, detail: _d, ...rest } = draft;
  const isMore = sections.length > (draft.sections?.length ?? 0);
  return {
    ...rest,
    strokes,
    ...(form && !isMore && { form }),
    ...(sections.length > 0 && { sections }),
    ...(back !== PLAIN.back && { back }),
    ...(between !== PLAIN.between && { between }),
    ...(!isPlainDetail(detail) && { detail }),
  };
}
