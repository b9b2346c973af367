import { changeForm, type Whose } from './changeForm.ts';
import type { CommandKind } from './index.ts';

export interface Data extends Whose {
  /** in the order of u, from 0 */
  readonly index: number;
  /** its back alone, or what was drawn over it last */
  readonly only?: 'back' | 'redraw';
}

/** A section goes, or what it has beside its front; a surface without sections is round again. */
export const removeSection: CommandKind<'removeSection', Data> = {
  type: 'removeSection',
  apply: (document, { index, only, ...whose }) =>
    changeForm(document, whose, (form) => {
      const section = form.sections[index];
      if (!section) return null;
      if (only === undefined) return { ...form, sections: form.sections.filter((_, i) => i !== index) };
      if (only === 'back' ? section.back === null : section.redraws.length === 0) return null;
      const less =
        only === 'back' ? { ...section, back: null } : { ...section, redraws: section.redraws.slice(0, -1) };
      return { ...form, sections: form.sections.map((other, i) => (i === index ? less : other)) };
    }),
  describe: (_document, { index, only }) =>
    only === undefined
      ? `section ${index + 1} removed`
      : `${only === 'back' ? 'back' : 'redrawing'} of section ${index + 1} removed`,
};
