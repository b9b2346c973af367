import { nearestSection, type Section, type SectionStroke, type SurfaceForm } from '../surfacePart.ts';
import { changeForm, type Whose } from './changeForm.ts';
import type { CommandKind } from './index.ts';

export interface Data extends Whose {
  /** where it was drawn over */
  readonly u: number;
  /** on the section's own plane */
  readonly drawn: SectionStroke;
}

/**
 * Cross-sectional oversketch (thesis 6.2): the stroke takes the place of the part of a section that it was drawn over. Surfaces with one
 * section follow all along; round ones and tubes become surfaces of that section.
 */
export const redrawSection: CommandKind<'redrawSection', Data> = {
  type: 'redrawSection',
  apply: (document, { u, drawn, ...whose }) =>
    changeForm(document, whose, (form) => {
      const whole = form.sections.length > 0 ? form : rounded(form, u);
      const at = nearestSection(whole.sections, u);
      const sections = whole.sections.map((section, i) =>
        i === at ? { ...section, redraws: [...section.redraws, drawn] } : section,
      );
      return { ...whole, sections };
    }),
  describe: (_document, { u }) => `section at ${Math.round(100 * u)} % redrawn`,
};

/** With the section that tubes and round forms have, closed all round. */
function rounded(form: SurfaceForm, u: number): SurfaceForm {
  const round: Section = { u, front: null, back: null, redraws: [] };
  return { ...form, sections: [round], back: 'front' };
}
