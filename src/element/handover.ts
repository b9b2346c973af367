/** Which of several pages keeps the drawing: the older one, until another asks for it. What is said is in `tabs.ts`. */
import type { OpenTabs, TabMessage, Tabs } from './tabs.ts';

/** The page this one speaks for. */
export interface Claimant {
  /** this page writes what it keeps */
  writes(): boolean;
  /** something of this page is kept: a blank page has nothing that another one could take from it */
  keeps(): boolean;
  /** another page keeps its drawing from now on */
  yield(): void;
  /** writes what is not written yet, then yields */
  give(): Promise<void>;
}

/** ms: how long a page that is asked may take; one that sleeps does not answer at all */
const PATIENCE = 700;

export class Handover {
  #tabs: Tabs | null = null;
  #given: (() => void) | null = null;
  readonly #since = Date.now();
  readonly #id = `${Math.random()}`;
  readonly #openTabs: OpenTabs;
  readonly #claimant: Claimant;

  constructor(openTabs: OpenTabs, claimant: Claimant) {
    this.#openTabs = openTabs;
    this.#claimant = claimant;
  }

  open(): void {
    this.#tabs ??= this.#openTabs((message) => this.#receive(message));
  }

  close(): void {
    this.#tabs?.close();
    this.#tabs = null;
  }

  /** Is anyone else keeping it? */
  hello(): void {
    this.#tabs?.post({ type: 'hello' });
  }

  mine(): void {
    this.#tabs?.post({ type: 'mine', since: this.#since, id: this.#id });
  }

  /** Resolves when the other page has written all it has, or does not answer. */
  ask(): Promise<void> {
    return new Promise((resolve) => {
      this.#given = resolve;
      this.#tabs?.post({ type: 'take' });
      setTimeout(resolve, PATIENCE);
    });
  }

  #receive(message: TabMessage): void {
    const claimant = this.#claimant;
    if (message.type === 'given') this.#given?.();
    if (!claimant.writes()) return;
    if (message.type === 'hello' && claimant.keeps()) this.mine();
    if (message.type === 'mine' && this.#yields(message)) claimant.yield();
    if (message.type === 'take') void claimant.give().then(() => this.#tabs?.post({ type: 'given' }));
  }

  /** To the older one, and to one that keeps something while this page does not. */
  #yields({ since, id }: { readonly since: number; readonly id: string }): boolean {
    if (!this.#claimant.keeps()) return true;
    return since < this.#since || (since === this.#since && id < this.#id);
  }
}
