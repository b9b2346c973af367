/** The drawing’s name, in a word where it is kept, and the ways to all drawings and to its file. */
import { html, type TemplateResult } from 'lit';
import { type Actions, iconButton } from './controls.ts';
import { icon, wordmark } from './icons.ts';
import type { Session } from './session.ts';
import { FILE_WORDS } from './words.ts';

export function fileTray(session: Session, actions: Actions): TemplateResult {
  const { open, files } = actions;
  return html`<div class="tray chrome card doc" part="tray" role="group" aria-label="File">
    ${iconButton('drawings', 'Drawings', () => actions.toggle('drawings'), { expanded: open === 'drawings' })}
    <span class="separator"></span>
    ${files.blank ? wordmark : named(session, actions)}
  </div>`;
}

function named({ name }: Session, actions: Actions): TemplateResult {
  const { files, open } = actions;
  const word = FILE_WORDS.tray[files.kept];
  return html`<button class="b title" aria-label="${name || FILE_WORDS.untitled}${word ? `, ${word.toLowerCase()}` : ''}: file" aria-expanded=${open === 'file'} @click=${() => actions.toggle('file')}>
    <b>${name || FILE_WORDS.untitled}</b> <small class=${files.kept}>${word}</small>${icon('down', 20)}
  </button>`;
}
