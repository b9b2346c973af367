/** The drawing’s name, whether it is saved, and the way to its file menu. */
import { nothing, type TemplateResult } from 'lit';
import type { Actions } from './controls.ts';
import type { Session } from './session.ts';

export function fileTray(_session: Session, _actions: Actions): TemplateResult | typeof nothing {
  return nothing;
}
