import type { Reading } from '../document.ts';
import {
  isRing,
  isThere,
  nearestSection,
  type RedrawnStroke,
  ROUND,
  type Section,
  type SurfaceForm,
  sectionsInForce,
  withSection,
} from '../surfacePart.ts';
import { changeForm, formMeant, type Whose } from './changeForm.ts';
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
 * section follow all along; round ones and tubes become surfaces of that section. Who stepped back loses no section. Back to one section of
 * several: that one is redrawn, the others wait, and the form stays stepped back. Back to a round form or a tube: what is redrawn is a
 * round section among the others (on one that is there already, that one), and the form is what all of them make, as it is when a section
 * is added; so it is, too, where a redraw is to fade, which takes several sections.
 */
export const redrawSection: CommandKind<'redrawSection', Data> = {
  type: 'redrawSection',
  apply: (document, { u, drawn, local = false, ...whose }) =>
    changeForm(
      document,
      whose,
      (form, kind) => {
        const { whole, at } = meant(form, kind, u, local);
        const sections = whole.sections.map((section, i) =>
          i === at ? { ...section, redraws: [...section.redraws, drawn] } : section,
        );
        return { ...whole, sections };
      },
      (form, kind) => local || !isOneOfSeveral(form, kind),
    ),
  describe(document, { u, local = false, ...whose }) {
    const found = formMeant(document, whose);
    const redrawn = found && meant(found.form, found.kind, u, local);
    const at = redrawn?.whole.sections[redrawn.at]?.u ?? u;
    return `section at ${Math.round(100 * at)} % redrawn`;
  },
};

const SECTION = 'crossSection';

const isOneOfSeveral = ({ sections }: SurfaceForm, kind: Reading): boolean =>
  kind === SECTION && sections.length > 1;

/** The section that is drawn over, which may lie elsewhere than at u, and the form with it. */
function meant(form: SurfaceForm, kind: Reading, u: number, local: boolean): Meant {
  if (!local && isOneOfSeveral(form, kind))
    return { whole: form, at: form.sections.indexOf(sectionsInForce(SECTION, form.sections)[0]!) };
  const whole = roundIn(form, kind, u);
  const sections = local ? withLocal(whole.sections, u, isRing(form)) : whole.sections;
  return { whole: { ...whole, sections }, at: nearestSection(sections, u, isRing(form)) };
}

interface Meant {
  readonly whole: SurfaceForm;
  /** index */
  readonly at: number;
}

/** Tubes and round forms have a section that is closed all round. */
function roundIn(form: SurfaceForm, kind: Reading, u: number): SurfaceForm {
  if (kind !== 'solid' && sectionsInForce(kind, form.sections).length > 0) return form;
  const back = form.sections.length > 0 && form.back !== 'none' ? form.back : 'front';
  const sections = isThere(form.sections, u, isRing(form))
    ? form.sections
    : withSection(form.sections, { ...ROUND, u }, isRing(form));
  return { ...form, sections, back };
}

/** With one at u that is as the surface is there; the only one there was goes to both ends, of a ring to the other side. */
function withLocal(sections: readonly Section[], u: number, ring: boolean): readonly Section[] {
  const [only, ...others] = sections;
  const ends = ring ? [(u + 0.5) % 1] : [0, 1];
  const all = only && others.length === 0 ? ends.map((end) => ({ ...only, u: end })) : sections;
  return isThere(all, u, ring) ? all : withSection(all, { ...ROUND, u, follows: true }, ring);
}
