import type { Reading } from '../document.ts';
import {
  isThere,
  nearestSection,
  type RedrawnStroke,
  ROUND,
  type Section,
  type SurfaceForm,
  sectionsInForce,
  withSection,
} from '../surfacePart.ts';
import { changeForm, type Whose } from './changeForm.ts';
import type { CommandKind } from './index.ts';

export interface Data extends Whose {
  /** where it was drawn over */
  readonly u: number;
  /** on the section's own plane */
  readonly drawn: RedrawnStroke;
  /** only there: towards the ends, or the next sections, the surface stays as it is */
  readonly local?: true;
}

/**
 * Cross-sectional oversketch (thesis 6.2): the stroke takes the place of the part of a section that it was drawn over. Surfaces with one
 * section follow all along; round ones and tubes become surfaces of that section. Sections that a person stepped back from go: what is
 * redrawn is what is seen.
 */
export const redrawSection: CommandKind<'redrawSection', Data> = {
  type: 'redrawSection',
  apply: (document, { u, drawn, local = false, ...whose }) =>
    changeForm(
      document,
      whose,
      (form, kind) => {
        const seen = seenIn(form, kind, u);
        const sections = local ? withLocal(seen.sections, u) : seen.sections;
        const at = nearestSection(sections, u);
        const redrawn = sections.map((section, i) =>
          i === at ? { ...section, redraws: [...section.redraws, drawn] } : section,
        );
        return { ...seen, sections: redrawn };
      },
      true,
    ),
  describe: (_document, { u }) => `section at ${Math.round(100 * u)} % redrawn`,
};

/** Tubes and round forms have a section that is closed all round. */
function seenIn(form: SurfaceForm, kind: Reading, u: number): SurfaceForm {
  const sections = kind === 'solid' ? [] : sectionsInForce(kind, form.sections);
  if (sections.length === 0) return { ...form, sections: [{ ...ROUND, u }], back: 'front' };
  return { ...form, sections };
}

/** With one at u that is as the surface is there; the only one there was goes to both ends. */
function withLocal(sections: readonly Section[], u: number): readonly Section[] {
  const [only, ...others] = sections;
  const all =
    only && others.length === 0
      ? [
          { ...only, u: 0 },
          { ...only, u: 1 },
        ]
      : sections;
  return isThere(all, u) ? all : withSection(all, { ...ROUND, u, follows: true });
}
