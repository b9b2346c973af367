import {
  type Document,
  type Draft,
  formOfDraft,
  isSurface,
  type Reading,
  readingOf,
  type SurfacePart,
  staysTubes,
} from '../document.ts';
import { isFormInReach } from '../inReach.ts';
import { LIMITS } from '../limits.ts';
import { strayIn, straySection } from '../strays.ts';
import {
  isPlainDetail,
  kindOfStrokes,
  MADE_OF,
  PLAIN,
  type SurfaceForm,
  steppedBack,
} from '../surfacePart.ts';
import { changeParts } from './changeParts.ts';

/** Whose strokes are meant: those of a kept part, or, without an id, of the unfinished form. */
export interface Whose {
  readonly part?: string;
}

/** What becomes of a form that is read as `kind`; null, or the same form: nothing. */
export type Change = (form: SurfaceForm, kind: Reading) => SurfaceForm | null;

/** The form that is meant, and what it is read as; null: there is none. */
export function formMeant(
  document: Document,
  { part }: Whose,
): { readonly form: SurfaceForm; readonly kind: Reading } | null {
  const { draft, parts } = document;
  if (part !== undefined) {
    const found = parts.filter(isSurface).find(({ id }) => id === part);
    return found ? { form: found, kind: found.kind } : null;
  }
  const kind = readingOf(document);
  return draft && kind ? { form: formOfDraft(draft), kind } : null;
}

/** Whether it does, of each form by itself. */
export type GoesOn = boolean | ((form: SurfaceForm, kind: Reading) => boolean);

const isGoingOn = (goes: GoesOn, form: SurfaceForm, kind: Reading): boolean =>
  typeof goes === 'function' ? goes(form, kind) : goes;

/**
 * With other strokes: what it is follows from their number. What no file could hold is not done. `goes`: whoever stepped back to what fewer
 * strokes make goes on from there; else that stays.
 */
export function changeForm(
  document: Document,
  { part }: Whose,
  change: Change,
  goes: GoesOn = false,
): Document {
  if (part !== undefined)
    return changeParts(document, [part], (found) =>
      isSurface(found) ? changedPart(found, change, goes) : found,
    );
  const { draft } = document;
  const kind = readingOf(document);
  if (!draft || !kind) return document;
  const form = formOfDraft(draft);
  const goesOn = isGoingOn(goes, form, kind);
  const next = change(form, kind);
  if (!next || next === form || !fits(next)) return document;
  // of solids only the strokes can change
  if (kind === 'solid' && !isSameBut(next, form)) return document;
  if (goesOn && !isCounted(next, kindOfStrokes(next))) return document;
  const tubesOnly = document.tubesOnly && !(goesOn && staysTubes(document));
  return { ...document, tubesOnly, draft: draftWith(draft, next, goesOn) };
}

function changedPart(part: SurfacePart, change: Change, goes: GoesOn): SurfacePart {
  const next = change(part, part.kind);
  if (!next || next === part || !fits(next)) return part;
  const { strokes, sections, back, between, bends, detail } = next;
  const kind = steppedBack(next, isGoingOn(goes, part, part.kind) ? undefined : part.kind);
  if (!isCounted(next, kind)) return part;
  return { ...part, kind, strokes, sections, back, between, bends, detail };
}

const fits = (form: SurfaceForm): boolean =>
  form.sections.length <= LIMITS.sections &&
  form.bends.length <= LIMITS.bends &&
  form.sections.every(({ redraws }) => redraws.length <= LIMITS.redraws) &&
  isFormInReach(form) &&
  !strayIn(form.strokes) &&
  !straySection(form.strokes, form.sections);

const isCounted = ({ strokes }: SurfaceForm, kind: keyof typeof MADE_OF): boolean =>
  strokes.length >= MADE_OF[kind].strokes.least && strokes.length <= MADE_OF[kind].strokes.most;

const isSameBut = (a: SurfaceForm, b: SurfaceForm): boolean =>
  a.sections === b.sections && a.back === b.back && a.between === b.between && a.detail === b.detail;

/** What says nothing is left out. */
export function draftWith(draft: Draft, next: SurfaceForm, goesOn = false): Draft {
  const { strokes, sections, back, between, detail } = next;
  const { form, sections: _s, back: _b, between: _w, detail: _d, ...rest } = draft;
  // closed strokes of which nothing is said would be a solid once their sections are gone
  const said = goesOn ? (strokes[0]!.closed ? kindOfStrokes(next) : undefined) : form;
  return {
    ...rest,
    strokes,
    ...(said && { form: said }),
    ...(sections.length > 0 && { sections }),
    ...(back !== PLAIN.back && { back }),
    ...(between !== PLAIN.between && { between }),
    ...(!isPlainDetail(detail) && { detail }),
  };
}
