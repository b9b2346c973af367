import type { Bend } from '../surfacePart.ts';
import { changeForm } from './changeForm.ts';
import { nameOf } from './changeParts.ts';
import type { CommandKind } from './index.ts';

export interface Data {
  readonly id: string;
  /** from 0, the first one that was made */
  readonly index: number;
  /** null: it goes */
  readonly change: Partial<Bend> | null;
}

/** A bend is drawn anew, changed, switched off, or goes; those above it stay on top of it. */
export const setBend: CommandKind<'setBend', Data> = {
  type: 'setBend',
  apply: (document, { id, index, change }) =>
    changeForm(document, { part: id }, (form) => {
      const old = form.bends[index];
      if (!old) return null;
      const isSame =
        change && (Object.keys(change) as (keyof Bend)[]).every((key) => change[key] === old[key]);
      if (isSame) return null;
      return {
        ...form,
        bends: form.bends.flatMap((b, i) => (i === index ? (change ? [{ ...b, ...change }] : []) : [b])),
      };
    }),
  describe: (document, { id, index, change }) =>
    `bend ${index + 1} of ${nameOf(document, [id])} ${change ? 'changed' : 'removed'}`,
};
