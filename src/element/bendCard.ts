/** While a part is being bent: what to draw, whether its length stays, keep or drop. At the lower edge, out of the pen's way. */
import { html, nothing, type TemplateResult } from 'lit';
import { nameOf } from '../document/command/changeParts.ts';
import { madeBend } from '../tool/bend.ts';
import { dropBend, keepBend, setBendLength } from './bending.ts';
import { segment } from './editSegment.ts';
import { icon } from './icons.ts';
import type { Session } from './session.ts';
import { EDIT_WORDS } from './words.ts';

const { kept, stretched } = EDIT_WORDS;

export function bendCard(session: Session): TemplateResult | typeof nothing {
  if (session.tool !== 'bend') return nothing;
  const { bending } = session.state;
  const made = bending && madeBend(bending, session.document);
  const isNew = made && made !== bending.old;
  const name = bending ? nameOf(session.document, [bending.id]) : '';
  const words = !bending ? EDIT_WORDS.which : isNew ? EDIT_WORDS.bent(name) : EDIT_WORDS.drawLine;
  return html`<div class="acts edit card chrome" part="actions" role="group" aria-label=${EDIT_WORDS.bend}>
    <div class="what">${icon('bend')}<b>${words}</b></div>
    ${bending ? lengths(session, bending.keepsLength) : nothing}
    <button class="b quiet text" aria-label="Drop" aria-keyshortcuts="Escape" @click=${() => dropBend(session)}>${icon('x', 20)}<span class="word">Drop</span></button>
    ${isNew ? html`<button class="b primary text" aria-keyshortcuts="N Enter" @click=${() => keepBend(session)}>${icon('check', 20)}Keep</button>` : nothing}
  </div>`;
}

const lengths = (session: Session, keepsLength: boolean): TemplateResult =>
  segment(EDIT_WORDS.length, [
    { name: kept, hint: EDIT_WORDS.keptHint, on: keepsLength, run: () => setBendLength(session, true) },
    {
      name: stretched,
      hint: EDIT_WORDS.stretchedHint,
      on: !keepsLength,
      run: () => setBendLength(session, false),
    },
  ]);
