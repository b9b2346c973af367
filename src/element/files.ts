/**
 * The drawing as a file: a controller of the element that joins opening, saving, keeping and exporting, and from which the
 * templates read what to show.
 */
import type { ReactiveController, ReactiveControllerHost } from 'lit';
import { watchDrop } from './drop.ts';
import type { ChangeDetail } from './events.ts';
import { Exports, type ExportsHost } from './exports.ts';
import type { Picked } from './fileAccess.ts';
import { Keeping } from './keeping.ts';
import { Opening } from './opening.ts';
import { Origins } from './origins.ts';
import { Samples } from './samples.ts';
import { Saving } from './saving.ts';
import type { Session } from './session.ts';
import { isBlank } from './snapshot.ts';
import type { Theme } from './theme.ts';
import { Voice } from './voice.ts';

export interface FilesHost extends ReactiveControllerHost, HTMLElement, ExportsHost {
  readonly session: Session;
  /** the key under which the browser keeps the drawing */
  readonly autosave: string | null;
  /** the address of a list of samples */
  readonly gallery: string | null;
  readonly readOnly: boolean;
  readonly controls: 'all' | 'none';
  readonly theme: Theme | null;
  load(source: string, options: { readonly name: string }): Promise<void>;
  /** closes the panel, else takes the focus to the drawing */
  dismiss(): void;
}

/** Where what was drawn is, in a word. */
export type Kept = 'none' | 'saved' | 'kept' | 'saving' | 'unsaved';

export class Files implements ReactiveController {
  readonly opening: Opening;
  readonly saving: Saving;
  readonly exports: Exports;
  readonly samples: Samples;
  readonly origins: Origins;
  /** null where the browser keeps nothing */
  keeping: Keeping | null = null;
  /** files hang over the element */
  over = false;
  readonly #voice: Voice;
  readonly #host: FilesHost;
  #life: AbortController | null = null;

  constructor(host: FilesHost) {
    this.#host = host;
    this.#voice = new Voice(() => host.session);
    this.origins = new Origins(host.session, (drawing) => void this.keeping?.autosave.setAside(drawing));
    this.opening = new Opening(host, this.origins, this.#voice);
    this.saving = new Saving(host, this.origins, this.#voice);
    this.exports = new Exports(host, this.#voice);
    this.samples = new Samples(() => host.requestUpdate());
    host.addController(this);
  }

  hostConnected(): void {
    this.#life = new AbortController();
    const { signal } = this.#life;
    const changed = (event: Event) => this.origins.changed((event as CustomEvent<ChangeDetail>).detail);
    this.#host.addEventListener('change', changed, { signal });
    this.#watchDrop(signal);
    this.keeping?.autosave.connect();
    if (this.keeping) this.#watchPage(this.keeping, signal);
  }

  /** Only where something is kept: such listeners cost a page its place in the browser's memory of pages. */
  #watchPage(keeping: Keeping, signal: AbortSignal): void {
    const { autosave } = keeping;
    window.addEventListener('beforeunload', (event) => this.#guard(event), { signal });
    window.addEventListener('pagehide', () => autosave.leave(), { signal });
    document.addEventListener('visibilitychange', () => void autosave.flush(), { signal });
  }

  hostDisconnected(): void {
    this.#life?.abort();
    this.keeping?.autosave.disconnect();
  }

  /** Before the first picture: what is kept is asked for at once. */
  hostUpdate(): void {
    const { autosave: key } = this.#host;
    if (key === null || this.keeping) return;
    this.keeping = new Keeping(key, this.#host, this.origins, this.saving, this.#voice);
    if (this.#life) this.#watchPage(this.keeping, this.#life.signal);
  }

  hostUpdated(): void {
    void this.samples.show(this.#host.gallery);
    this.origins.remember();
    this.keeping?.autosave.touch();
    this.keeping?.watch();
  }

  #watchDrop(signal: AbortSignal): void {
    const target = {
      ready: () => !this.#host.readOnly && this.#host.controls === 'all',
      over: (on: boolean) => {
        if (this.over === on) return;
        this.over = on;
        this.#host.requestUpdate();
      },
      dropped: (files: readonly Promise<Picked>[]) => void this.opening.dropped(files),
    };
    watchDrop(this.#host, target, signal);
  }

  // ── where it is ─────────────────────────────────────────────────────────────────────────────────────

  /** What is kept may still take the place of the empty page. */
  get restoring(): boolean {
    return this.keeping?.autosave.state === 'reading';
  }

  /** Nothing is drawn, and nothing is named. */
  get blank(): boolean {
    return isBlank(this.#host.session.drawing);
  }

  get kept(): Kept {
    const autosave = this.keeping?.autosave;
    const where = this.origins.where(this.#host.session.drawing);
    if (this.blank || this.restoring) return 'none';
    if (where === 'file') return 'saved';
    if (autosave && !autosave.pending) return 'kept';
    if (autosave?.state === 'on' && autosave.error === null) return 'saving';
    return where ? 'none' : 'unsaved';
  }

  /** Only what neither the browser nor a file has is lost with the page. */
  #guard(event: BeforeUnloadEvent): void {
    if (!this.keeping || this.#host.readOnly) return;
    const { autosave } = this.keeping;
    void autosave.flush();
    const safe = this.origins.where(this.#host.session.drawing) !== null;
    if (autosave.pending && !this.blank && !safe) event.preventDefault();
  }
}
