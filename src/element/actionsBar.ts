/** What can be done with the selected parts: at the lower edge while there is no unfinished form that asks first. */
import { html, nothing, type TemplateResult } from 'lit';
import { CLAY } from '../document/build.ts';
import { colourOf } from '../document/document.ts';
import { type Actions, iconButton } from './controls.ts';
import { ball } from './icons.ts';
import { chosenParts, partsName } from './partCard.ts';
import { duplicateSelection, hideSelection, removeSelection } from './partDeeds.ts';
import type { Session } from './session.ts';
import { PART_WORDS } from './words.ts';

const { action } = PART_WORDS;

export function actionsBar(session: Session, actions: Actions): TemplateResult | typeof nothing {
  const parts = chosenParts(session);
  if (parts.length === 0 || session.document.draft || session.tool !== 'select') return nothing;
  const hidden = parts.every((part) => part.hidden);
  const docked = actions.open === 'parts' || actions.open === 'settings';
  return html`<div class="acts card chrome ${docked ? 'docked' : ''}" part="actions" role="toolbar" aria-label=${partsName(parts)}>
    ${iconButton(null, PART_WORDS.colour, () => actions.toggle('palette'), {
      expanded: actions.open === 'palette',
      body: html`<span class="swatch">${ball('toon', colourOf(parts[0]!) ?? CLAY)}</span>`,
    })}
    ${iconButton(hidden ? 'eye' : 'eyeOff', hidden ? action.show : action.hide, () => hideSelection(session), { key: 'H' })}
    ${hidden ? nothing : iconButton('focus', action.focus, () => session.focus(session.selection))}
    ${iconButton('duplicate', action.duplicate, () => duplicateSelection(session))}
    <span class="separator"></span>
    ${iconButton('trash', action.remove, () => removeSelection(session), { class: 'danger', shortcut: 'Delete' })}
  </div>`;
}
