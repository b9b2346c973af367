/** A drawing kept in the browser: brought back when the page is, and what a person has to know about it. */
import type { Drawing } from '../document/drawing.ts';
import { Autosave } from './autosave.ts';
import { download } from './fileAccess.ts';
import type { FilesHost } from './files.ts';
import type { Origins } from './origins.ts';
import { fileNameOf, type Saving } from './saving.ts';
import { isBlank } from './snapshot.ts';
import { tabsOf } from './tabs.ts';
import { PAPER_OF, themeOf } from './theme.ts';
import { createVault, type Stored } from './vault.ts';
import type { Voice } from './voice.ts';
import { FILE_WORDS } from './words.ts';

type Trouble = 'none' | 'elsewhere' | 'store';

export class Keeping {
  readonly autosave: Autosave;
  /** when the store has answered; true: what it kept is open */
  readonly restored: Promise<boolean>;
  /** what was said once is not said again before it is over */
  #told: Trouble = 'none';
  readonly #host: FilesHost;
  readonly #origins: Origins;
  readonly #saving: Saving;
  readonly #voice: Voice;

  constructor(key: string, host: FilesHost, origins: Origins, saving: Saving, voice: Voice) {
    this.#host = host;
    this.#origins = origins;
    this.#saving = saving;
    this.#voice = voice;
    this.autosave = new Autosave(createVault(key), tabsOf(key), {
      drawing: () => host.session.drawing,
      facts: () => ({ ownPaper: host.session.looks.choseBackground, file: origins.fact }),
      changed: () => host.requestUpdate(),
    });
    this.autosave.connect();
    this.restored = this.#restore();
  }

  async #restore(): Promise<boolean> {
    const { autosave } = this;
    const found = await autosave.restore();
    if (!found && autosave.refused) this.#offer(autosave.refused);
    if (!found) return false;
    // Drawn or opened before the store had answered: that stays, and the other is not lost.
    if (isBlank(this.#host.session.drawing)) {
      this.#show(found);
      return !isBlank(found.drawing);
    }
    await autosave.setStoredAside(found.stored);
    return false;
  }

  /** As if one had never left: nothing to undo, and looked at from the very same place. */
  #show({ drawing, stored }: { readonly drawing: Drawing; readonly stored: Stored }): void {
    const { session, theme } = this.#host;
    const { file, ownPaper } = stored;
    session.open(drawing, { fit: false, fresh: true });
    session.looks.choseBackground = ownPaper;
    if (!ownPaper) session.setLook(PAPER_OF[themeOf(theme)]);
    this.#origins.current = file && { name: file.name, handle: file.handle ?? null };
    if (file?.unchanged) this.#origins.mark(session.document, session.name, 'file');
    this.autosave.adopt();
    if (!isBlank(drawing)) this.#voice.say(FILE_WORDS.restored(drawing.name));
  }

  #offer(stored: Stored): void {
    const way = { label: FILE_WORDS.saveIt, run: () => this.saveUnreadable(stored) };
    this.#voice.notify(FILE_WORDS.unreadable, way);
  }

  /** As it is, for whoever can still read it. */
  saveUnreadable(stored: Stored): void {
    const name = `${fileNameOf(stored.name)}.unreadable.rotund`;
    download([{ name, blob: new Blob([stored.text]) }]);
    void this.autosave.forgetUnreadable();
  }

  /** After each update. Said once, and only when there is something to lose. */
  watch(): void {
    const trouble = this.#trouble;
    if (trouble === this.#told || (trouble !== 'none' && isBlank(this.#host.session.drawing))) return;
    this.#told = trouble;
    // What an update shows is not to be changed by it.
    queueMicrotask(() => {
      if (trouble === 'elsewhere') this.#tellElsewhere();
      if (trouble === 'store') this.#tellStore();
    });
  }

  get #trouble(): Trouble {
    const { state, error, pending } = this.autosave;
    if (state === 'elsewhere') return 'elsewhere';
    return (state === 'blocked' || error) && pending ? 'store' : 'none';
  }

  #tellElsewhere(): void {
    this.#voice.notify(
      FILE_WORDS.elsewhere,
      { label: FILE_WORDS.takeOver, run: () => void this.takeOver() },
      { label: FILE_WORDS.openCopy, run: () => this.#copy() },
    );
  }

  #tellStore(): void {
    const { error } = this.autosave;
    const full = error instanceof DOMException && error.name === 'QuotaExceededError';
    const text = full ? FILE_WORDS.full : FILE_WORDS.blocked;
    this.#voice.notify(text, { label: FILE_WORDS.saveCopy, run: () => void this.#saving.save(true) });
  }

  async takeOver(): Promise<void> {
    const found = await this.autosave.takeOver();
    if (found) this.#show(found);
    this.#voice.hush();
    this.#voice.say(FILE_WORDS.tookOver);
  }

  /** A drawing of its own, kept by no page until it is a file. */
  #copy(): void {
    this.#origins.current = null;
    this.#saving.rename(FILE_WORDS.copyOf(this.#host.session.name));
    this.#voice.say(FILE_WORDS.isCopy);
  }
}
