/** The list of the parts, and what can be set of those that are selected. */
import { nothing, type TemplateResult } from 'lit';
import type { Actions } from './controls.ts';
import type { Session } from './session.ts';

export function partsPanel(_session: Session, _actions: Actions): TemplateResult | typeof nothing {
  return nothing;
}
