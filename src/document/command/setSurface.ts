import type { Document } from '../document.ts';
import type { Back, Between, Detail, SurfaceForm } from '../surfacePart.ts';
import { changeForm } from './changeForm.ts';
import { nameOf } from './changeParts.ts';
import type { CommandKind } from './index.ts';
import { isInHand } from './recreate.ts';

export interface Change {
  readonly back?: Back;
  readonly between?: Between;
  readonly detail?: Partial<Detail>;
}

export interface Data {
  /** of parts; without them the unfinished form */
  readonly ids?: readonly string[];
  readonly change: Change;
}

/** Back, blending and subdivision of surfaces (thesis A.2.2, A.4): no stroke moves. */
export const setSurface: CommandKind<'setSurface', Data> = {
  type: 'setSurface',
  apply(document, { ids, change }) {
    const set = (form: SurfaceForm) => changed(form, change);
    if (!ids) return changeForm(document, {}, set);
    const next = ids.reduce((before, part) => changeForm(before, { part }, set), document);
    // its strokes are seen as they are in hand, and come back so
    return isInHand(document, ids) ? changeForm(next, {}, set) : next;
  },
  describe: (document: Document, { ids, change }) => {
    const [what = 'nothing'] = (['back', 'between', 'detail'] as const).filter((key) => key in change);
    const word = { back: 'back', between: 'blending of sections', detail: 'detail', nothing: 'nothing' }[
      what
    ];
    return ids ? `${word} of ${nameOf(document, ids)}` : word;
  },
};

function changed(
  form: SurfaceForm,
  { back = form.back, between = form.between, detail }: Change,
): SurfaceForm {
  const next = detail ? { ...form.detail, ...detail } : form.detail;
  const isSame =
    back === form.back &&
    between === form.between &&
    (Object.keys(next) as (keyof Detail)[]).every((key) => next[key] === form.detail[key]);
  return isSame ? form : { ...form, back, between, detail: next };
}
