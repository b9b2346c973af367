/** All drawings there are to go to: a new one, a file, the one before, the samples. Each is a step that undo takes back. */
import { html, nothing, type TemplateResult } from 'lit';
import type { Actions } from './controls.ts';
import { row, when } from './fileRows.ts';
import type { Files } from './files.ts';
import { cards } from './gallery.ts';
import { frame } from './panelFrame.ts';
import type { Session } from './session.ts';
import type { Stored } from './vault.ts';
import { FILE_WORDS } from './words.ts';

export function drawingsPanel({ name }: Session, actions: Actions): TemplateResult {
  const { files } = actions;
  const { opening, samples, keeping, blank } = files;
  const previous = keeping?.autosave.previous;
  const then = (run: () => void) => () => {
    actions.dismiss();
    run();
  };
  const fresh = then(() => opening.startNew());
  const open = then(() => void opening.choose());
  const back = (stored: Stored) => then(() => void opening.previous(stored));
  const toFile = () => actions.toggle('file');
  const body = html`<section>
      ${blank ? nothing : row('fresh', 'New drawing', fresh)} ${row('open', 'Open a file', open, { key: 'Ctrl O' })}
      ${previous ? row('history', 'Previous drawing', back(previous), { small: facts(previous) }) : nothing}
      ${blank ? nothing : row('save', name || FILE_WORDS.untitled, toFile, { small: ways(files) })}
    </section>
    ${
      samples.list.length > 0
        ? html`<section><h3>Samples</h3>${cards(files, () => actions.dismiss())}</section>`
        : nothing
    }`;
  return frame('Drawings', 'drawings', actions, body);
}

const facts = ({ name, time }: Stored) => `${name || FILE_WORDS.untitled}, replaced ${when(time)}`;

/** On a narrow screen this is the only place that says whether it is saved. */
const ways = ({ kept }: Files) => [FILE_WORDS.tray[kept], 'name, save, export'].filter(Boolean).join(' · ');
