/** The Redraw tool in the hand: what is lit, and whether what is drawn reaches all along. */
import { html, nothing, type TemplateResult } from 'lit';
import { redrawing } from '../tool/redraw.ts';
import { iconButton } from './controls.ts';
import { segment } from './editSegment.ts';
import { icon } from './icons.ts';
import { leaveRedraw } from './redraws.ts';
import type { Session } from './session.ts';
import { EDIT_WORDS } from './words.ts';

export function redrawCard(session: Session): TemplateResult | typeof nothing {
  const { redrawing: held } = session.state;
  // the chip of an unfinished form is the card there
  if (session.tool !== 'redraw' || !held || session.document.draft) return nothing;
  const reach = (local: boolean) => () => session.begin(redrawing(local));
  return html`<div class="acts edit card chrome" part="actions" role="group" aria-label=${EDIT_WORDS.redraw}>
    <div class="what">${icon('redraw')}<b>${held.over ? EDIT_WORDS.redrawLit[held.over] : EDIT_WORDS.redrawHover}</b></div>
    ${segment(EDIT_WORDS.reach, [
      { name: EDIT_WORDS.whole, hint: EDIT_WORDS.wholeHint, on: !held.local, run: reach(false) },
      { name: EDIT_WORDS.here, hint: EDIT_WORDS.hereHint, on: held.local, run: reach(true) },
    ])}
    ${iconButton('x', 'Close', () => leaveRedraw(session))}
  </div>`;
}
