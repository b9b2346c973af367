import type { Document } from '../document.ts';
import {
  isRing,
  nearestSection,
  type Section,
  type SectionStroke,
  type SurfaceForm,
  sectionThere,
  withSection,
} from '../surfacePart.ts';
import { changeForm, type Whose } from './changeForm.ts';
import type { CommandKind } from './index.ts';

export interface Data extends Whose {
  /** along the construction curves, 0–1 */
  readonly u: number;
  readonly drawn: SectionStroke;
  /** what it is of; a back belongs to the section nearest to it. Default: the front */
  readonly side?: 'front' | 'back';
}

/** A cross section drawn from one construction curve to the other (thesis 5.4); in the place of one that is there already, whose back stays. */
export const addSection: CommandKind<'addSection', Data> = {
  type: 'addSection',
  apply: (document, { u, drawn, side = 'front', ...whose }) =>
    changeForm(document, whose, (form) => (side === 'back' ? withBack : withFront)(form, u, drawn), true),
  describe: (_document: Document, { u, side }) =>
    `${side === 'back' ? 'back' : 'section'} at ${Math.round(100 * u)} %`,
};

function withFront(form: SurfaceForm, u: number, front: SectionStroke): SurfaceForm {
  const old = sectionThere(form.sections, u, isRing(form));
  const section: Section = { u, front, back: old?.back ?? null, redraws: [] };
  return { ...form, sections: withSection(form.sections, section, isRing(form)) };
}

function withBack(form: SurfaceForm, u: number, back: SectionStroke): SurfaceForm {
  const at = nearestSection(form.sections, u, isRing(form));
  const sections =
    at < 0
      ? [{ u, front: null, back, redraws: [] }]
      : form.sections.map((section, i) => (i === at ? { ...section, back } : section));
  return { ...form, sections, back: 'drawn' };
}
