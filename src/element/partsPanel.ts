/** The list of the parts, and what can be set of those that are selected. */
import { html, type TemplateResult } from 'lit';
import type { Actions } from './controls.ts';
import { frame } from './panelFrame.ts';
import { partCard } from './partCard.ts';
import { partList } from './partList.ts';
import type { Session } from './session.ts';
import { PART_WORDS } from './words.ts';

export function partsPanel(session: Session, actions: Actions): TemplateResult {
  const body =
    session.document.parts.length === 0
      ? html`<p class="quiet-words">${PART_WORDS.none}</p>`
      : html`${partList(session)} ${partCard(session)}`;
  return frame('Parts', 'parts', actions, body);
}
