/** What can be done with the selected parts. */
import { nothing, type TemplateResult } from 'lit';
import type { Actions } from './controls.ts';
import type { Session } from './session.ts';

export function actionsBar(_session: Session, _actions: Actions): TemplateResult | typeof nothing {
  return nothing;
}
