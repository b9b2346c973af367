/** Formats other programs read, and pictures. What is left out is said before, not after. */
import { html, nothing, type TemplateResult } from 'lit';
import type { Actions } from './controls.ts';
import { row } from './fileRows.ts';
import { frame } from './panelFrame.ts';
import type { Session } from './session.ts';
import { FILE_WORDS } from './words.ts';

/** px of the longer side */
const SIZES: readonly (readonly [longest: number | null, name: string])[] = [
  [null, 'As on the screen'],
  [2048, '2048 pixels wide or high'],
  [4096, '4096 pixels wide or high'],
];

export function exportPanel(session: Session, actions: Actions): TemplateResult {
  const { exports } = actions.files;
  void exports.list();
  const { parts, draft } = session.document;
  const hidden = parts.filter((part) => part.hidden).length;
  const none = parts.length === hidden;
  const off = exports.busy !== null;
  const note = (text: string) => html`<p class="note">${text}</p>`;
  const body = html`
    ${none ? note(parts.length ? FILE_WORDS.allHidden : FILE_WORDS.noForms) : nothing}
    ${draft ? html`${note(FILE_WORDS.draftOut)}${row('check', 'Keep it', () => session.keep())}` : nothing}
    ${hidden && !none ? note(FILE_WORDS.hiddenOut(hidden)) : nothing}
    ${
      none
        ? nothing
        : html`<section aria-busy=${off}>
            <h3>For other programs</h3>
            ${exports.formats?.map((format) => row('box', format.label, () => void exports.write(format), { small: format.carries, off }))}
          </section>
          <section aria-busy=${off}>
            <h3>Picture, PNG</h3>
            ${SIZES.map(([longest, name]) => row('image', name, () => void exports.picture(longest), { off }))}
          </section>`
    }
    ${
      exports.share === null
        ? nothing
        : html`${note(FILE_WORDS.waitingFor(Math.floor(100 * exports.share)))}
            ${row('x', FILE_WORDS.cancel, () => exports.cancel())}`
    }
    ${off ? html`<div class="progress" role="progressbar" aria-label=${FILE_WORDS.exporting(exports.busy ?? '')}></div>` : nothing}`;
  return frame('Export', 'export', actions, body);
}
