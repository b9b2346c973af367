/** What can be done with the selected parts: at the lower edge while there is no unfinished form that asks first. */
import { html, nothing, type TemplateResult } from 'lit';
import { CLAY } from '../document/build.ts';
import { partsWith } from '../document/chosen.ts';
import { nameOf } from '../document/command/changeParts.ts';
import { isSurface, type SurfacePart } from '../document/document.ts';
import { mirrorOf } from '../document/mirror.ts';
import { startBend } from './bending.ts';
import { chosenColour } from './chosenParts.ts';
import { type Actions, iconButton } from './controls.ts';
import { ball } from './icons.ts';
import {
  duplicateSelection,
  hideSelection,
  mirrorCopy,
  mirrorSelection,
  removeSelection,
} from './partDeeds.ts';
import { isHidden } from './partRows.ts';
import { recreatePart } from './recreating.ts';
import { startRedraw } from './redraws.ts';
import type { Session } from './session.ts';
import { isSkeletonOn, selectedSkeleton, toggleSkeleton } from './skeletonEdit.ts';
import { EDIT_WORDS, PART_WORDS, SKELETON_WORDS, SOLID_WORDS } from './words.ts';

const { action } = PART_WORDS;

export function actionsBar(session: Session, actions: Actions): TemplateResult | typeof nothing {
  const { document, selection } = session;
  if (selection.length === 0 || document.draft || session.tool !== 'select') return nothing;
  const hidden = isHidden(document, selection);
  // what its own deeds leave no room for is in the list of parts, and on H
  const surface = bendable(session);
  const docked = actions.open === 'parts' || actions.open === 'settings';
  return html`<div class="acts card chrome ${docked ? 'docked' : ''}" part="actions" role="toolbar" aria-label=${nameOf(document, selection)}>
    ${iconButton(null, PART_WORDS.colour, () => actions.toggle('palette'), {
      expanded: actions.open === 'palette',
      class: surface ? 'elsewhere least' : '',
      body: html`<span class="swatch">${ball('toon', chosenColour(session) ?? CLAY)}</span>`,
    })}
    ${surface ? nothing : iconButton(hidden ? 'eye' : 'eyeOff', hidden ? action.show : action.hide, () => hideSelection(session), { key: 'H', class: 'elsewhere least' })}
    ${hidden ? nothing : iconButton('focus', action.focus, () => session.focus(selection), { class: 'elsewhere' })}
    ${surface ? edits(session, surface.id) : nothing}
    ${iconButton('duplicate', action.duplicate, () => duplicateSelection(session), { shortcut: 'Control+D' })}
    ${hidden ? nothing : mirrors(session)}
    ${selectedSkeleton(session) ? iconButton('skeleton', SKELETON_WORDS.show, () => toggleSkeleton(session), { key: 'K', pressed: isSkeletonOn(session) }) : nothing}
    <span class="separator"></span>
    ${iconButton('trash', action.remove, () => removeSelection(session), { class: 'danger', shortcut: 'Delete' })}
  </div>`;
}

/** One surface that is seen; null: something else is selected. */
function bendable({ document, selection }: Session): SurfacePart | null {
  const [part, ...others] = partsWith(document, selection);
  return part && others.length === 0 && !part.hidden && isSurface(part) ? part : null;
}

/** Phones have no room for what is right below them, among the tools. */
const edits = (session: Session, id: string): TemplateResult =>
  html`${iconButton('bend', EDIT_WORDS.bend, () => startBend(session), { key: EDIT_WORDS.bendKey, class: 'railed' })}
    ${iconButton('redraw', EDIT_WORDS.redraw, () => startRedraw(session), { key: EDIT_WORDS.redrawKey, class: 'railed' })}
    ${iconButton('recreate', EDIT_WORDS.recreate, () => recreatePart(session, id), { hint: EDIT_WORDS.recreateHint })}`;

/** Where the mirror stands is told by their tooltips. */
function mirrors(session: Session): TemplateResult {
  const across = mirrorOf(session.document, session.selection, session.view)?.across ?? null;
  const hint = SOLID_WORDS.mirrorHint(across);
  return html`${iconButton('mirror', SOLID_WORDS.mirror, () => mirrorSelection(session), { key: 'Shift M', hint })}
    ${iconButton('mirrorCopy', SOLID_WORDS.mirrorCopy, () => mirrorCopy(session), { hint })}`;
}
