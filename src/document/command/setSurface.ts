import type { Document } from '../document.ts';
import { RANGES } from '../limits.ts';
import type { Back, Between, Detail, SurfaceForm } from '../surfacePart.ts';
import { changeForm } from './changeForm.ts';
import { nameOf } from './changeParts.ts';
import type { CommandKind } from './index.ts';
import { isInHand } from './recreate.ts';

export interface Change {
  readonly back?: Back;
  readonly between?: Between;
  readonly detail?: DetailChange;
}

export interface DetailChange extends Partial<Detail> {
  /** subdivisions more (or, below 0, fewer) both ways than each surface has, as far as there are such */
  readonly finer?: number;
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
  const next = detail ? detailWith(form.detail, detail) : form.detail;
  const isSame =
    back === form.back &&
    between === form.between &&
    (Object.keys(next) as (keyof Detail)[]).every((key) => next[key] === form.detail[key]);
  return isSame ? form : { ...form, back, between, detail: next };
}

function detailWith(before: Detail, { finer = 0, ...set }: DetailChange): Detail {
  const { min, max } = RANGES.subdivisions;
  const next = { ...before, ...set };
  const within = (times: number) => Math.min(max, Math.max(min, times + finer));
  return { ...next, u: within(next.u), v: within(next.v) };
}
