import { type Document, type Draft, type Joins, readingOf, staysTubes } from '../document.ts';
import { isForm, mostStrokes } from '../solid.ts';
import { WORD } from '../words.ts';
import type { CommandKind } from './index.ts';

export interface Data {
  /** what the strokes become; null: what their number says */
  readonly form?: NonNullable<Draft['form']> | null;
  /** where the solid goes; null: a part of its own */
  readonly joins?: Joins | null;
  readonly carves?: boolean;
}

/** What the unfinished form is to become. What is left out stays. Where every stroke is a tube, another form ends that: nothing would be seen of it. */
export const setForm: CommandKind<'setForm', Data> = {
  type: 'setForm',
  apply(document, change) {
    const { draft } = document;
    if (!draft) return document;
    const { form: wasForm, joins: wasJoins, carves: wasCarves, ...rest } = draft;
    const { form = wasForm ?? null, joins = wasJoins ?? null, carves = wasCarves ?? false } = change;
    // one ring has no holes, and a form round has two sides
    if (form && draft.strokes.length > most(form)) return document;
    const next: Draft = {
      ...rest,
      ...(form && { form }),
      ...(joins && { joins }),
      ...(carves && { carves: true as const }),
    };
    const names = change.form !== undefined && change.form !== 'tube';
    const tubesOnly = document.tubesOnly && !(names && staysTubes(document));
    // nor has a surface
    const reading = readingOf({ ...document, tubesOnly, draft: next });
    if (reading !== 'solid' && reading !== 'tube' && draft.strokes.length > 2) return document;
    const isSame = JSON.stringify(said(next)) === JSON.stringify(said(draft));
    return isSame && tubesOnly === document.tubesOnly ? document : { ...document, tubesOnly, draft: next };
  },
  describe: (document: Document, change) => {
    const { form, joins, carves } = change;
    // the number of strokes decides, and what it decides has a name
    const made = form === null ? readingOf(setForm.apply(document, change)) : form;
    if (made) return `${WORD[made].toLowerCase()} from the strokes`;
    if (joins !== undefined) return joins ? 'joined' : 'a part of its own';
    return carves ? 'carving' : 'form of the strokes';
  },
};

const most = (form: NonNullable<Draft['form']>): number => {
  if (form === 'tube') return Infinity;
  return isForm(form) ? mostStrokes(form) : 2;
};

const said = ({ form, joins, carves }: Draft) => [form, joins?.solid, joins?.component, carves];
