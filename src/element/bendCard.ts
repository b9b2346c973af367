/** While a part is being bent: what to draw, whether its length stays, keep or drop. At the lower edge, out of the pen's way. */
import { html, nothing, type TemplateResult } from 'lit';
import { nameOf } from '../document/command/changeParts.ts';
import { madeBend } from '../tool/bend.ts';
import { dropBend, keepBend, setBendLength } from './bending.ts';
import { roving } from './controls.ts';
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

function lengths(session: Session, keepsLength: boolean): TemplateResult {
  const choices = [
    { name: kept, hint: EDIT_WORDS.keptHint, keeps: true },
    { name: stretched, hint: EDIT_WORDS.stretchedHint, keeps: false },
  ];
  return html`<div class="segment" role="radiogroup" aria-label=${EDIT_WORDS.length} @keydown=${roving}>
    ${choices.map(
      ({
        name,
        hint,
        keeps,
      }) => html`<button role="radio" aria-checked=${keeps === keepsLength} tabindex=${keeps === keepsLength ? 0 : -1}
        title="${EDIT_WORDS.length}: ${hint}" @click=${() => keeps !== keepsLength && setBendLength(session, keeps)}>${name}</button>`,
    )}
  </div>`;
}
