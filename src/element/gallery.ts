/** Drawings to open on the empty page. */
import { nothing, type TemplateResult } from 'lit';
import type { Actions } from './controls.ts';
import type { Session } from './session.ts';

export function gallery(_session: Session, _actions: Actions): TemplateResult | typeof nothing {
  return nothing;
}
