/** Exporting: meshes for other programs and pictures, one at a time, as downloads. */
import type { ReactiveControllerHost } from 'lit';
import type { Exporter, Format, OutFile } from '../export/index.ts';
import { messageOf } from './events.ts';
import { download } from './fileAccess.ts';
import type { Waiting } from './needs.ts';
import { fileNameOf } from './saving.ts';
import type { Session } from './session.ts';
import type { Shot } from './shot.ts';
import { painted, type Voice } from './voice.ts';
import { FILE_WORDS, WORDS } from './words.ts';

export interface ExportsHost extends ReactiveControllerHost {
  readonly session: Session;
  export(format: Format, waiting?: Waiting): Promise<readonly OutFile[]>;
  picture(shot?: Shot): Promise<Blob>;
}

interface Made {
  readonly name: string;
  readonly blob: Blob;
}

export class Exports {
  /** null until the panel has asked for them */
  formats: readonly Exporter[] | null = null;
  /** what is being written */
  busy: string | null = null;
  /** 0–1 of the bodies that the file waits for; null: of none */
  share: number | null = null;
  #abort: AbortController | null = null;
  #asked = false;
  readonly #host: ExportsHost;
  readonly #voice: Voice;

  constructor(host: ExportsHost, voice: Voice) {
    this.#host = host;
    this.#voice = voice;
  }

  /** The writers are fetched when somebody looks at them. */
  async list(): Promise<void> {
    if (this.formats || this.#asked) return;
    this.#asked = true;
    try {
      const { exporters } = await import('../export/index.ts');
      this.formats = Object.values(exporters);
      this.#host.requestUpdate();
    } catch {
      const again = () => {
        this.#asked = false;
        void this.list();
      };
      this.#voice.notify(FILE_WORDS.noWriters, { label: WORDS.tryAgain, run: again });
    }
  }

  async write({ id, label, mime }: Exporter): Promise<void> {
    await this.#make(label, async () => {
      this.#abort = new AbortController();
      const progress = (share: number) => {
        this.share = share < 1 ? share : null;
        this.#host.requestUpdate();
      };
      const files = await this.#host.export(id, { signal: this.#abort.signal, progress });
      return files.map(({ name, bytes }) => ({ name, blob: new Blob([bytes as BlobPart], { type: mime }) }));
    });
  }

  /** Gives up what waits for bodies. */
  cancel(): void {
    this.#abort?.abort();
  }

  /** px of the longer side; null: as large as on the screen */
  async picture(longest: number | null): Promise<void> {
    await this.#make(FILE_WORDS.picture, async () => {
      const { size, name } = this.#host.session;
      const scale = (longest ?? 0) / Math.max(size.width, size.height);
      const side = (pixels: number) => Math.max(16, Math.round(pixels * scale));
      const shot = longest === null ? {} : { width: side(size.width), height: side(size.height) };
      return [{ name: `${fileNameOf(name)}.png`, blob: await this.#host.picture(shot) }];
    });
  }

  async #make(what: string, make: () => Promise<readonly Made[]>): Promise<void> {
    if (this.busy !== null) return;
    this.busy = what;
    this.#voice.say(FILE_WORDS.exporting(what));
    try {
      await painted();
      const files = await make();
      download(files);
      this.#voice.hush();
      this.#voice.say(FILE_WORDS.exported(files.map(({ name, blob: { size } }) => ({ name, size }))));
    } catch (error) {
      this.#voice.say(FILE_WORDS.notExported(what));
      if (!this.#abort?.signal.aborted) this.#voice.notify(messageOf(error));
    } finally {
      this.busy = null;
      this.share = null;
      this.#abort = null;
      this.#host.requestUpdate();
    }
  }
}
