/**
 * Autosave: what is written when, and what never is. One page keeps one drawing; it writes shortly after a change, never
 * before it has read what is there, and never over what another page wrote. What a failed read leaves unknown stays as
 * it is. No DOM: the store, the other pages and the drawing are handed in.
 */
import type { Drawing } from '../document/drawing.ts';
import { parse, serialize } from '../document/serialize.ts';
import type { OpenTabs, TabMessage, Tabs } from './tabs.ts';
import { type Stored, Superseded, type Vault } from './vault.ts';

/** What is known of a drawing besides. */
export type Facts = Pick<Stored, 'ownPaper' | 'file'>;

export interface Keeper {
  drawing(): Drawing;
  facts(): Facts;
  /** the controls are stale */
  changed(): void;
}

/**
 * reading: what is stored is not known yet; blocked: it cannot be known; elsewhere: another page keeps its drawing.
 * Nothing is written in any of the three.
 */
export type AutosaveState = 'reading' | 'on' | 'blocked' | 'elsewhere';

/** ms */
const DELAY = 400;
const PATIENCE = { read: 4000, handover: 700 } as const;

/** A page without anything drawn and without a name: nothing to keep. */
export const isBlank = ({ document: { parts, draft }, name }: Drawing): boolean =>
  parts.length === 0 && !draft && name === '';

/** What is stored, or would be. */
interface Shot {
  readonly drawing: Drawing;
  readonly facts: Facts;
  /** the view and the facts: looking is no deed, but it is kept, too */
  readonly rest: string;
}

const sameWork = (a: Shot | null, { drawing }: Shot) =>
  a?.drawing.document === drawing.document && a.drawing.name === drawing.name;
const same = (a: Shot | null, b: Shot) =>
  a !== null && sameWork(a, b) && a.drawing.look === b.drawing.look && a.rest === b.rest;

export class Autosave {
  state: AutosaveState = 'reading';
  /** why the last write failed; null when it did not */
  error: unknown = null;
  /** the last drawing that was replaced and is in no file */
  previous: Stored | null = null;
  /** what was stored and could not be read */
  unreadable: Stored | null = null;
  /** the same, when it was found just now */
  refused: Stored | null = null;
  #revision = 0;
  /** what the vault has, as far as this page knows; null: nothing, or nothing that could be read */
  #stored: Shot | null = null;
  #seen: Shot | null = null;
  #timer: ReturnType<typeof setTimeout> | undefined;
  #writing: Promise<void> | null = null;
  #given: (() => void) | null = null;
  readonly #since: number;
  readonly #id: string;
  readonly #vault: Vault;
  readonly #openTabs: OpenTabs;
  readonly #keeper: Keeper;
  #tabs: Tabs | null = null;

  constructor(vault: Vault, openTabs: OpenTabs, keeper: Keeper) {
    this.#vault = vault;
    this.#openTabs = openTabs;
    this.#keeper = keeper;
    this.#since = Date.now();
    this.#id = `${Math.random()}`;
  }

  /** The page hears of other pages, and they of it. */
  connect(): void {
    this.#tabs ??= this.#openTabs((message) => this.#receive(message));
    if (this.state === 'on') this.#tabs.post({ type: 'hello' });
  }

  disconnect(): void {
    this.leave();
    this.#tabs?.close();
    this.#tabs = null;
    this.#vault.close();
  }

  // ── reading ─────────────────────────────────────────────────────────────────────────────────────────

  /** What was kept, parsed; null when there is none. Call `adopt` once it is shown. */
  async restore(): Promise<{ readonly drawing: Drawing; readonly stored: Stored } | null> {
    try {
      const stored = await this.#read();
      const drawing = stored && (await this.#parsed(stored));
      this.#to('on');
      this.#tabs?.post({ type: 'hello' });
      return stored && drawing && { drawing, stored };
    } catch (error) {
      this.error = error;
      this.#to('blocked');
      return null;
    }
  }

  async #read(): Promise<Stored | null> {
    const slots = Promise.all([
      this.#vault.read('current'),
      this.#vault.read('previous'),
      this.#vault.read('unreadable'),
    ]);
    const [current, previous, unreadable] = await within(slots, PATIENCE.read);
    this.#revision = current?.revision ?? 0;
    this.previous = previous;
    this.unreadable = unreadable;
    return current;
  }

  /** Null when it cannot be read: then it lies in a slot of its own before anything else is written. */
  async #parsed(stored: Stored): Promise<Drawing | null> {
    try {
      return { ...parse(stored.text, stored.name || 'drawing'), name: stored.name };
    } catch {
      await this.#vault.write('unreadable', stored);
      this.unreadable = this.refused = stored;
      return null;
    }
  }

  /** The drawing shown now is the stored one: only what comes after is a change. */
  adopt(): void {
    this.#stored = this.#seen = this.#now;
    this.#keeper.changed();
  }

  // ── writing ─────────────────────────────────────────────────────────────────────────────────────────

  get #now(): Shot {
    const drawing = this.#keeper.drawing();
    const facts = this.#keeper.facts();
    const { ownPaper, file } = facts;
    return { drawing, facts, rest: JSON.stringify([drawing.view, ownPaper, file?.name, file?.unchanged]) };
  }

  /** Anything may have changed; cheap. */
  touch(): void {
    const now = this.#now;
    if (same(this.#seen, now)) return;
    this.#seen = now;
    if (this.state === 'on' && this.#due) this.#timer ??= setTimeout(() => void this.flush(), DELAY);
  }

  /** A blank page is written only over something: a person emptied it then. */
  get #due(): boolean {
    const now = this.#now;
    return !same(this.#stored, now) && !(this.#stored === null && isBlank(now.drawing));
  }

  /** What was drawn or named, and is not stored yet. How one looks at it is no loss. */
  get pending(): boolean {
    const now = this.#now;
    return !sameWork(this.#stored, now) && !(this.#stored === null && isBlank(now.drawing));
  }

  /** Writes at once what is not stored yet. */
  async flush(): Promise<void> {
    clearTimeout(this.#timer);
    this.#timer = undefined;
    while (this.#writing) await this.#writing;
    if (this.state !== 'on' || !this.#due) return;
    this.#writing = this.#write().finally(() => {
      this.#writing = null;
    });
    await this.#writing;
    // Drawing went on meanwhile.
    if (this.error === null) {
      this.#seen = this.#stored;
      this.touch();
    }
  }

  async #write(): Promise<void> {
    const first = this.#stored === null;
    const now = this.#now;
    try {
      const stored = this.#record(now, 1);
      await this.#vault.write('current', stored, this.#revision);
      this.#revision = stored.revision;
      this.#stored = now;
      this.error = null;
      if (first) this.#sayMine();
    } catch (error) {
      if (error instanceof Superseded) this.#to('elsewhere');
      else this.error = error;
    }
    this.#keeper.changed();
  }

  /** The page goes: no time to look what is there, and no other page is known to write. */
  leave(): void {
    clearTimeout(this.#timer);
    this.#timer = undefined;
    if (this.state !== 'on' || !this.#due) return;
    const now = this.#now;
    // One more than a write that is under way.
    const stored = this.#record(now, 2);
    const done = () => {
      this.#revision = stored.revision;
      this.#stored = now;
    };
    this.#vault.write('current', stored).then(done, () => {});
  }

  #record({ drawing, facts }: Pick<Shot, 'drawing' | 'facts'>, step: number): Stored {
    const revision = this.#revision + step;
    return { text: serialize(drawing), name: drawing.name, time: Date.now(), revision, ...facts };
  }

  /** Another drawing took the place of this one, which is in no file. */
  async setAside(drawing: Drawing): Promise<void> {
    await this.#keepAside(this.#record({ drawing, facts: { ...this.#keeper.facts(), file: null } }, 0));
  }

  /** What was stored is not shown: something was drawn before it was read. */
  async setStoredAside(stored: Stored): Promise<void> {
    await this.#keepAside({ ...stored, file: null });
  }

  async #keepAside(stored: Stored): Promise<void> {
    this.previous = stored;
    this.#keeper.changed();
    if (this.state === 'on') await this.#vault.write('previous', this.previous).catch(() => {});
  }

  /** What could not be read was saved as a file, or is not wanted. */
  async forgetUnreadable(): Promise<void> {
    this.unreadable = null;
    this.#keeper.changed();
    await this.#vault.remove('unreadable').catch(() => {});
  }

  #to(state: AutosaveState): void {
    this.state = state;
    this.#keeper.changed();
  }

  // ── other pages ─────────────────────────────────────────────────────────────────────────────────────

  #sayMine(): void {
    this.#tabs?.post({ type: 'mine', since: this.#since, id: this.#id });
  }

  #receive(message: TabMessage): void {
    const { state } = this;
    // A blank page has nothing that another one could take from it.
    if (message.type === 'hello' && state === 'on' && this.#stored) this.#sayMine();
    if (message.type === 'mine' && state === 'on' && this.#yields(message)) this.#to('elsewhere');
    if (message.type === 'take' && state === 'on') void this.#give();
    if (message.type === 'given') this.#given?.();
  }

  /** To the older one, and to one that keeps something while this page does not. */
  #yields({ since, id }: { readonly since: number; readonly id: string }): boolean {
    if (this.#stored === null) return true;
    return since < this.#since || (since === this.#since && id < this.#id);
  }

  async #give(): Promise<void> {
    await this.flush();
    this.#to('elsewhere');
    this.#tabs?.post({ type: 'given' });
  }

  /**
   * From now on this page keeps its drawing, and the other one stops. What the other one had comes back, to be shown,
   * unless this page has work of its own: then that is kept, and the other's lies beside it.
   */
  async takeOver(): Promise<{ readonly drawing: Drawing; readonly stored: Stored } | null> {
    await new Promise<void>((resolve) => {
      this.#given = resolve;
      this.#tabs?.post({ type: 'take' });
      setTimeout(resolve, PATIENCE.handover);
    });
    this.#given = null;
    const own = this.pending;
    try {
      const stored = await this.#read();
      const drawing = stored && (await this.#parsed(stored));
      this.#to('on');
      if (own && stored && drawing) await this.setStoredAside(stored);
      if (!own) return stored && drawing && { drawing, stored };
      this.#stored = null;
      await this.flush();
    } catch (error) {
      this.error = error;
      this.#to('blocked');
    }
    return null;
  }
}

/** A store that never answers is one that cannot be read. */
function within<T>(promise: Promise<T>, milliseconds: number): Promise<T> {
  return new Promise((resolve, reject) => {
    const timer = setTimeout(() => reject(new Error('The browser’s store does not answer.')), milliseconds);
    promise.then(resolve, reject).finally(() => clearTimeout(timer));
  });
}
