/** All drawings there are to go to: a new one, a file, the one before, the samples. Each is a step that undo takes back. */
import { html, nothing, type TemplateResult } from 'lit';
import type { Actions } from './controls.ts';
import { row, when } from './fileRows.ts';
import { cards } from './gallery.ts';
import { frame } from './panelFrame.ts';
import type { Session } from './session.ts';
import { FILE_WORDS } from './words.ts';

export function drawingsPanel(session: Session, actions: Actions): TemplateResult {
  const { files } = actions;
  const { opening, samples, keeping, blank } = files;
  const previous = keeping?.autosave.previous;
  const then = (run: () => void) => () => {
    actions.dismiss();
    run();
  };
  const body = html`<section>
      ${
        blank
          ? nothing
          : row(
              'fresh',
              'New drawing',
              then(() => opening.startNew()),
            )
      }
      ${row(
        'open',
        'Open a file',
        then(() => void opening.choose()),
        { key: 'Ctrl O' },
      )}
      ${
        previous
          ? row(
              'history',
              'Previous drawing',
              then(() => void opening.previous(previous)),
              {
                small: `${previous.name || FILE_WORDS.untitled}, replaced ${when(previous.time)}`,
              },
            )
          : nothing
      }
      ${blank ? nothing : row('save', `${session.name || FILE_WORDS.untitled}: name, save, export`, () => actions.toggle('file'))}
    </section>
    ${
      samples.list.length > 0
        ? html`<section><h3>Samples</h3>${cards(files, () => actions.dismiss())}</section>`
        : nothing
    }`;
  return frame('Drawings', 'drawings', actions, body);
}
