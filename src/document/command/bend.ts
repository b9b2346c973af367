import type { Bend } from '../surfacePart.ts';
import { changeForm } from './changeForm.ts';
import { nameOf } from './changeParts.ts';
import type { CommandKind } from './index.ts';

export interface Data {
  readonly id: string;
  /** in the part's own space */
  readonly bend: Bend;
}

/** Orthogonal deformation (thesis 6.1): on top of the bends a part has. */
export const bend: CommandKind<'bend', Data> = {
  type: 'bend',
  apply: (document, { id, bend: added }) =>
    changeForm(document, { part: id }, (form) => ({ ...form, bends: [...form.bends, added] })),
  describe: (document, { id }) => `${nameOf(document, [id])} bent`,
};
