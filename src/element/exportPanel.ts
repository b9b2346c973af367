/** Formats other programs read, and pictures. */
import { nothing, type TemplateResult } from 'lit';
import type { Actions } from './controls.ts';
import type { Session } from './session.ts';

export function exportPanel(_session: Session, _actions: Actions): TemplateResult | typeof nothing {
  return nothing;
}
