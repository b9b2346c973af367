/**
 * Autosave: what is written when, and what never is. One page keeps one drawing; it writes shortly after a change, never
 * before it has read what is there, and never over what another page wrote. What a failed read leaves unknown stays as
 * it is. No DOM: the store, the other pages and the drawing are handed in.
 */
import type { Drawing } from '../document/drawing.ts';
import { parse, serialize } from '../document/serialize.ts';
import { Handover } from './handover.ts';
import { type Facts, isBlank, type Snapshot, same, sameWork, snapshot } from './snapshot.ts';
import type { OpenTabs } from './tabs.ts';
import { type Stored, Superseded, type Vault } from './vault.ts';

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
const PATIENCE = 4000;

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
  #stored: Snapshot | null = null;
  #seen: Snapshot | null = null;
  #timer: ReturnType<typeof setTimeout> | undefined;
  #writing: Promise<void> | null = null;
  readonly #vault: Vault;
  readonly #keeper: Keeper;
  readonly #handover: Handover;

  constructor(vault: Vault, openTabs: OpenTabs, keeper: Keeper) {
    this.#vault = vault;
    this.#keeper = keeper;
    this.#handover = new Handover(openTabs, {
      writes: () => this.state === 'on',
      keeps: () => this.#stored !== null,
      yield: () => this.#to('elsewhere'),
      give: async () => {
        await this.flush();
        this.#to('elsewhere');
      },
    });
  }

  /** The page hears of other pages, and they of it. */
  connect(): void {
    this.#handover.open();
    if (this.state === 'on') this.#handover.hello();
  }

  disconnect(): void {
    this.leave();
    this.#handover.close();
    this.#vault.close();
  }

  // ── reading ─────────────────────────────────────────────────────────────────────────────────────────

  /** What was kept, parsed; null when there is none. Call `adopt` once it is shown. */
  async restore(): Promise<{ readonly drawing: Drawing; readonly stored: Stored } | null> {
    try {
      const stored = await this.#read();
      const drawing = stored && (await this.#parsed(stored));
      this.#to('on');
      this.#handover.hello();
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
    const [current, previous, unreadable] = await within(slots, PATIENCE);
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

  get #now(): Snapshot {
    return snapshot(this.#keeper.drawing(), this.#keeper.facts());
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
      if (first) this.#handover.mine();
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

  #record({ drawing, facts }: Pick<Snapshot, 'drawing' | 'facts'>, step: number): Stored {
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

  /**
   * From now on this page keeps its drawing, and the other one stops. What the other one had comes back, to be shown,
   * unless this page has work of its own: then that is kept, and the other's lies beside it.
   */
  async takeOver(): Promise<{ readonly drawing: Drawing; readonly stored: Stored } | null> {
    await this.#handover.ask();
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
