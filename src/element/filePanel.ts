/** The drawing as a file: its name, where it is kept, and what can be done with it. */
import { html, nothing, type TemplateResult } from 'lit';
import type { Actions } from './controls.ts';
import { fact, row } from './fileRows.ts';
import type { Files } from './files.ts';
import { frame } from './panelFrame.ts';
import type { Session } from './session.ts';
import { FILE_WORDS } from './words.ts';

export function filePanel(session: Session, actions: Actions): TemplateResult {
  const { opening, saving } = actions.files;
  const then = (run: () => void) => () => {
    actions.dismiss();
    run();
  };
  const save = then(() => void saving.save());
  const saveAs = then(() => void saving.save(true));
  const script = then(() => void saving.saveScript());
  const exporting = () => actions.toggle('export');
  const fresh = then(() => opening.startNew());
  const open = then(() => void opening.choose());
  const body = html`${nameField(session, actions)} ${whereabouts(session, actions.files)}
    <section>
      ${row('save', 'Save', save, { key: 'Ctrl S' })} ${row('saveAs', 'Save as', saveAs, { key: 'Ctrl Shift S' })}
      ${row('script', 'Save the way it was drawn', script, { small: 'a script: every step, to be replayed' })}
      ${row('share', 'Export', exporting, { small: 'for other programs, or as a picture' })}
    </section>
    <section>
      ${row('fresh', 'New drawing', fresh)} ${row('open', 'Open a file', open, { key: 'Ctrl O' })}
    </section>`;
  return frame('File', 'file', actions, body);
}

function nameField(session: Session, actions: Actions): TemplateResult {
  const field = (event: Event) => event.target as HTMLInputElement;
  const typed = (event: KeyboardEvent) => {
    // Escape leaves the name as it was; Enter takes it.
    if (event.key === 'Escape') field(event).value = session.name;
    if (event.key !== 'Enter') return;
    // Else it would press the button that has the focus next.
    event.preventDefault();
    field(event).blur();
    actions.dismiss();
  };
  const renamed = (event: Event) => {
    actions.files.saving.rename(field(event).value);
    field(event).value = session.name;
  };
  // Not `live`: an update in the middle of a word, as autosave makes one, would take back what was typed.
  return html`<label class="field"><span>Name</span>
    <input type="text" autocomplete="off" spellcheck="false" maxlength="80" placeholder=${FILE_WORDS.untitled}
      .value=${session.name} @keydown=${typed} @change=${renamed} />
  </label>`;
}

/** Two places, and neither is told for the other. */
function whereabouts({ drawing }: Session, { keeping, origins }: Files): TemplateResult {
  const file = origins.current?.name;
  const unchanged = origins.where(drawing) === 'file';
  const inFile = file
    ? unchanged
      ? FILE_WORDS.inFile(file)
      : FILE_WORDS.changedSince(file)
    : FILE_WORDS.noFile;
  const autosave = keeping?.autosave;
  const kept = autosave !== undefined && !autosave.pending && autosave.state === 'on';
  const unreadable = autosave?.unreadable;
  return html`<section>
    ${keeping ? fact(kept, inBrowser(keeping)) : nothing} ${fact(unchanged, inFile)}
    ${keeping ? html`<p class="note">${FILE_WORDS.keptBut}</p>` : nothing}
    ${autosave?.state === 'elsewhere' ? row('history', FILE_WORDS.takeOver, () => void keeping?.takeOver()) : nothing}
    ${unreadable ? row('save', 'A drawing that could not be read', () => keeping?.saveUnreadable(unreadable), { small: FILE_WORDS.saveIt }) : nothing}
  </section>`;
}

function inBrowser({ autosave: { state, error, pending } }: NonNullable<Files['keeping']>): string {
  if (state === 'elsewhere') return FILE_WORDS.keptElsewhere;
  if (state === 'blocked' || error !== null) return FILE_WORDS.keepsNothing;
  return pending ? FILE_WORDS.keeping : FILE_WORDS.keptHere;
}
