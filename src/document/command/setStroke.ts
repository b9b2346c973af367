import type { Stroke } from '../../stroke/stroke.ts';
import { changeForm, type Whose } from './changeForm.ts';
import type { CommandKind } from './index.ts';

export interface Data extends Whose {
  /** of the construction curves, from 0 */
  readonly index: number;
  /** on the plane of the form; null: it goes */
  readonly stroke: Stroke | null;
}

/** A construction curve is drawn anew, or goes; the last one stays. */
export const setStroke: CommandKind<'setStroke', Data> = {
  type: 'setStroke',
  apply: (document, { index, stroke, ...whose }) =>
    changeForm(document, whose, (form) => {
      if (!(index in form.strokes)) return null;
      const strokes = form.strokes.flatMap((other, i) => (i === index ? (stroke ? [stroke] : []) : [other]));
      return strokes.length > 0 ? { ...form, strokes } : null;
    }),
  describe: (_document, { index, stroke }) => `stroke ${index + 1} ${stroke ? 'redrawn' : 'removed'}`,
};
