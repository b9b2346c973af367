import type { SurfaceForm } from '../surfacePart.ts';
import { changeForm, type Whose } from './changeForm.ts';
import type { CommandKind } from './index.ts';

export interface Data extends Whose {
  /** in the order of u, from 0 */
  readonly index: number;
  /** its back alone, or one of those drawn over it */
  readonly only?: 'back' | 'redraw';
  /** of what was drawn over it, which, from 0; default: the last */
  readonly redraw?: number;
}

/** A section goes, or what it has beside its front; a surface without sections is round again. What was drawn later over it stays. */
export const removeSection: CommandKind<'removeSection', Data> = {
  type: 'removeSection',
  apply: (document, data) => changeForm(document, data, (form) => without(form, data)),
  describe: (_document, { index, only }) =>
    only === undefined
      ? `section ${index + 1} removed`
      : `${only === 'back' ? 'back' : 'redrawing'} of section ${index + 1} removed`,
};

function without(form: SurfaceForm, { index, only, redraw }: Data): SurfaceForm | null {
  const section = form.sections[index];
  // a number says that one of those drawn over it is meant, not the section
  if (!section || (redraw !== undefined && only !== 'redraw')) return null;
  if (only === undefined) return { ...form, sections: form.sections.filter((_, i) => i !== index) };
  const { back, redraws } = section;
  const which = redraw ?? redraws.length - 1;
  if (only === 'back' ? back === null : !(which in redraws)) return null;
  const less =
    only === 'back'
      ? { ...section, back: null }
      : { ...section, redraws: redraws.filter((_, i) => i !== which) };
  return { ...form, sections: form.sections.map((other, i) => (i === index ? less : other)) };
}
