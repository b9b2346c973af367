/** Opening: a file, a sample, what was dropped, what was replaced. Always one undo step; what cannot be read changes nothing. */
import { LIMITS } from '../document/limits.ts';
import { isScript } from '../document/serialize.ts';
import { messageOf } from './events.ts';
import { type Picked, pick } from './fileAccess.ts';
import type { FilesHost } from './files.ts';
import type { Origin, Origins } from './origins.ts';
import { fetchSample, type Sample } from './samples.ts';
import { isBlank } from './snapshot.ts';
import type { Stored } from './vault.ts';
import { painted, type Voice } from './voice.ts';
import { FILE_WORDS } from './words.ts';

interface Found {
  /** as messages call it, and a drawing that has no name of its own */
  readonly label: string;
  readonly origin: Origin | null;
  /** where it is just so */
  readonly where: 'file' | 'sample' | null;
  read(): Promise<string>;
}

export class Opening {
  readonly #host: FilesHost;
  readonly #origins: Origins;
  readonly #voice: Voice;

  constructor(host: FilesHost, origins: Origins, voice: Voice) {
    this.#host = host;
    this.#origins = origins;
    this.#voice = voice;
  }

  /** The browser's dialog. */
  async choose(): Promise<void> {
    if (this.#host.readOnly) return;
    try {
      const picked = await pick();
      if (picked) await this.#picked(picked);
    } catch (error) {
      this.#refuse(error, FILE_WORDS.file);
    }
  }

  /** The first of them. */
  async dropped(files: readonly Promise<Picked>[]): Promise<void> {
    const first = await files[0];
    if (!first) return;
    const opened = await this.#picked(first);
    if (opened && files.length > 1) this.#voice.say(FILE_WORDS.firstOf(files.length, first.file.name));
  }

  #picked({ file, handle }: Picked): Promise<boolean> {
    const { name } = file;
    const read = async () => {
      if (file.size > LIMITS.bytes) throw new Error(FILE_WORDS.tooLarge(name));
      return file.text();
    };
    return this.#open({ label: name, origin: { name, handle }, where: 'file', read });
  }

  async sample(sample: Sample): Promise<void> {
    const { name } = sample;
    await this.#open({ label: name, origin: null, where: 'sample', read: () => fetchSample(sample) });
  }

  /** What was set aside comes back; what it replaces is set aside in its turn. */
  async previous({ text, name }: Stored): Promise<void> {
    await this.#open({ label: name, origin: null, where: null, read: async () => text });
  }

  /** An empty page; undo brings the drawing back. */
  startNew(): void {
    const { session } = this.#host;
    const covers = !isBlank(session.drawing);
    session.clear();
    this.#origins.current = null;
    this.#voice.say(FILE_WORDS.fresh(covers));
  }

  async #open({ label, origin, where, read }: Found): Promise<boolean> {
    const { session } = this.#host;
    const called = label || FILE_WORDS.untitled;
    this.#voice.say(FILE_WORDS.opening(called));
    await painted();
    try {
      const text = await read();
      const covers = !isBlank(session.drawing);
      // Saving would put a drawing in the place of the commands somebody wrote.
      this.#origins.next = isScript(text) ? null : origin;
      await this.#host.load(text, { name: label });
      if (where) this.#origins.mark(session.document, session.name, where);
      this.#voice.hush();
      this.#voice.say(FILE_WORDS.opened(session.name, covers));
      // So that its keys answer.
      if (document.activeElement === document.body) this.#host.dismiss();
      return true;
    } catch (error) {
      this.#refuse(error, called);
      return false;
    } finally {
      this.#origins.next = null;
    }
  }

  #refuse(error: unknown, label: string): void {
    this.#voice.say(FILE_WORDS.notOpened(label));
    const another = { label: FILE_WORDS.openAnother, run: () => void this.choose() };
    this.#voice.notify(messageOf(error), another);
  }
}
