/** What `src` names: fetched, read, handed over. One at a time: a new address, or the element’s leaving, ends the one before. */
import type { Drawing } from '../document/drawing.ts';
import { FileError, nameOf, parse } from '../document/serialize.ts';

export interface SourceOwner {
  /** Whether the address is to be read at all: what the browser kept goes before what a page begins with. */
  wanted(): Promise<boolean>;
  skipped(): void;
  opened(drawing: Drawing): void;
  failed(error: unknown): void;
}

export class Source {
  /** resolves when nothing is under way, whether it went well or not */
  settled: Promise<void> = Promise.resolve();
  /** a fetch is under way */
  busy = false;
  #address: string | null = null;
  #stop: AbortController | null = null;
  readonly #owner: SourceOwner;

  constructor(owner: SourceOwner) {
    this.#owner = owner;
  }

  /** `now`: there is a page that asks; else it waits for `resume`. */
  open(address: string | null, now: boolean): void {
    this.pause();
    this.#address = address;
    if (now) this.resume();
  }

  /** The element is on a page again: what its leaving interrupted begins anew. */
  resume(): void {
    const address = this.#address;
    if (this.busy || !address) return;
    const stop = new AbortController();
    this.#stop = stop;
    this.busy = true;
    this.settled = this.#read(address, stop.signal);
  }

  /** The element leaves the page. */
  pause(): void {
    this.#stop?.abort();
    this.#stop = null;
    this.busy = false;
  }

  /** Something else was opened. */
  forget(): void {
    this.pause();
    this.#address = null;
  }

  async #read(address: string, signal: AbortSignal): Promise<void> {
    const wanted = await this.#owner.wanted();
    if (signal.aborted) return;
    if (!wanted) {
      this.busy = false;
      this.#address = null;
      this.#owner.skipped();
      return;
    }
    const result = await fetched(address, signal)
      .then((text) => named(parse(text, fileName(address)), fileName(address)))
      .catch((error: unknown) => ({ error }));
    if (signal.aborted) return;
    this.busy = false;
    this.#address = null;
    if ('error' in result) this.#owner.failed(result.error);
    else this.#owner.opened(result);
  }
}

async function fetched(address: string, signal: AbortSignal): Promise<string> {
  const refused = (what: string) => new FileError(address, '', what);
  if (!URL.canParse(address, document.baseURI)) throw refused('is no address');
  try {
    const answer = await fetch(new URL(address, document.baseURI), { signal });
    if (answer.ok) return await answer.text();
    throw refused(`the server answers ${answer.status}, not with a drawing`);
  } catch (error) {
    throw signal.aborted || error instanceof FileError ? error : refused('could not be fetched');
  }
}

/** The last step of an address, as people wrote it; messages and the drawing’s name come from it. */
function fileName(address: string): string {
  const last = address
    .replace(/[?#].*$/, '')
    .split('/')
    .at(-1);
  if (!last || /^(data|blob):/.test(address)) return 'drawing';
  try {
    return decodeURIComponent(last);
  } catch {
    return last;
  }
}

/** A drawing without a name of its own is called as its file is. */
export function named(drawing: Drawing, file: string): Drawing {
  return drawing.name ? drawing : { ...drawing, name: nameOf(file) };
}
