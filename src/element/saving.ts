/** Saving: to the file a drawing came from, or to another one; and the way it was drawn, as a script. */
import type { Drawing } from '../document/drawing.ts';
import { nameOf, serialize, serializeScript } from '../document/serialize.ts';
import { fileName } from '../export/names.ts';
import { messageOf } from './events.ts';
import { type Saved, save } from './fileAccess.ts';
import type { FilesHost } from './files.ts';
import type { Origins } from './origins.ts';
import { isBlank } from './snapshot.ts';
import type { Voice } from './voice.ts';
import { FILE_WORDS } from './words.ts';

const LONGEST_NAME = 80;

export const fileNameOf = (name: string): string => fileName(name || FILE_WORDS.untitled);

export class Saving {
  readonly #host: FilesHost;
  readonly #origins: Origins;
  readonly #voice: Voice;

  constructor(host: FilesHost, origins: Origins, voice: Voice) {
    this.#host = host;
    this.#origins = origins;
    this.#voice = voice;
  }

  /** To the file it came from; without one, or `as` another, where the person says. */
  async save(as = false): Promise<void> {
    const { drawing } = this.#host.session;
    if (this.#host.readOnly) return;
    if (isBlank(drawing)) {
      this.#voice.say(FILE_WORDS.nothingToSave);
      return;
    }
    const name = `${fileNameOf(drawing.name)}.rotund`;
    const handle = as ? null : (this.#origins.current?.handle ?? null);
    try {
      const saved = await save(serialize(drawing), name, handle);
      if (saved.way !== 'cancelled') await this.#saved(drawing, name, saved);
    } catch (error) {
      this.#voice.say(FILE_WORDS.notSaved);
      const another = { label: FILE_WORDS.saveAs, run: () => void this.save(true) };
      this.#voice.notify(FILE_WORDS.notWritten(messageOf(error)), another);
    }
  }

  async #saved(drawing: Drawing, proposed: string, saved: Saved): Promise<void> {
    const handle = saved.way === 'file' ? saved.handle : null;
    const file = handle?.name ?? proposed;
    const named = await this.#named(drawing, proposed, handle);
    const { session } = this.#host;
    if (session.name === drawing.name) session.name = named.name;
    this.#origins.current = { name: file, handle };
    this.#origins.mark(drawing.document, named.name, 'file');
    this.#voice.hush();
    this.#voice.say(FILE_WORDS.saved(file));
  }

  /** The name that a person gave in the browser's dialog is the drawing's. */
  async #named(drawing: Drawing, proposed: string, handle: FileSystemFileHandle | null): Promise<Drawing> {
    if (!handle || handle.name === proposed || handle.name === this.#origins.current?.name) return drawing;
    const named = { ...drawing, name: nameOf(handle.name) };
    await save(serialize(named), handle.name, handle);
    return named;
  }

  /** The commands that lead here, as a file that can be opened and replayed. */
  async saveScript(): Promise<void> {
    const { drawing, script } = this.#host.session;
    const name = `${fileNameOf(drawing.name)}.script.rotund`;
    try {
      const { way } = await save(serializeScript(script, drawing), name, null);
      if (way !== 'cancelled') this.#voice.say(FILE_WORDS.saved(name));
    } catch (error) {
      this.#voice.notify(FILE_WORDS.notWritten(messageOf(error)));
    }
  }

  /** No undo step: a name belongs to the file, not to what is drawn. */
  rename(name: string): void {
    const { session } = this.#host;
    session.name = [...name.trim()].slice(0, LONGEST_NAME).join('');
    session.update();
  }
}
