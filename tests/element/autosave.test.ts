/** Autosave against a store and other pages that are none: what is written when, and what never is. */
import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest';
import { EMPTY_DOCUMENT } from '../../src/document/document.ts';
import { type Drawing, EMPTY_DRAWING } from '../../src/document/drawing.ts';
import { parse, serialize } from '../../src/document/serialize.ts';
import { Autosave } from '../../src/element/autosave.ts';
import type { OpenTabs, TabMessage } from '../../src/element/tabs.ts';
import { type Slot, type Stored, Superseded, type Vault } from '../../src/element/vault.ts';
import { random } from '../fixtures/random.ts';

/** ms: longer than autosave waits */
const LATER = 1000;

class FakeVault implements Vault {
  readonly slots = new Map<Slot, Stored>();
  writes = 0;
  reading: 'works' | 'fails' | 'hangs' = 'works';
  writing: 'works' | 'fails' = 'works';

  async read(slot: Slot): Promise<Stored | null> {
    if (this.reading === 'hangs') return new Promise(() => {});
    if (this.reading === 'fails') throw new Error('no store');
    return this.slots.get(slot) ?? null;
  }

  async write(slot: Slot, stored: Stored, after?: number): Promise<void> {
    await Promise.resolve();
    if (this.writing === 'fails') throw new Error('full');
    const there = this.slots.get(slot);
    if (after !== undefined && there && there.revision !== after) throw new Superseded();
    this.writes++;
    this.slots.set(slot, stored);
  }

  async remove(slot: Slot): Promise<void> {
    this.slots.delete(slot);
  }

  close(): void {}

  get current(): Drawing | null {
    const stored = this.slots.get('current');
    return stored ? parse(stored.text, 'stored') : null;
  }
}

/** Pages that hear each other a moment later. */
class FakeTabs {
  readonly #all = new Set<(message: TabMessage) => void>();
  deaf = false;

  readonly open: OpenTabs = (receive) => {
    this.#all.add(receive);
    return {
      post: (message) => {
        const others = [...this.#all].filter((other) => other !== receive);
        if (!this.deaf) for (const other of others) queueMicrotask(() => other(message));
      },
      close: () => this.#all.delete(receive),
    };
  };
}

/** A page with its drawing. */
class Page {
  drawing: Drawing = EMPTY_DRAWING;
  readonly autosave: Autosave;

  constructor(vault: Vault, tabs: FakeTabs) {
    this.autosave = new Autosave(vault, tabs.open, {
      drawing: () => this.drawing,
      facts: () => ({ ownPaper: false, file: null }),
      changed: () => {},
    });
    this.autosave.connect();
  }

  async open(): Promise<this> {
    const found = await this.autosave.restore();
    if (found) this.show(found.drawing);
    await vi.advanceTimersByTimeAsync(1);
    return this;
  }

  show(drawing: Drawing): void {
    this.drawing = drawing;
    this.autosave.adopt();
  }

  /** Documents differ by reference, as after a command; the brush tells them apart. */
  change(radius: number): void {
    const { brush } = this.drawing.document;
    this.drawing = {
      ...this.drawing,
      name: this.drawing.name || 'Pear',
      document: { ...this.drawing.document, brush: { ...brush, radius } },
    };
    this.autosave.touch();
  }

  clear(): void {
    this.drawing = { ...EMPTY_DRAWING, document: { ...EMPTY_DOCUMENT } };
    this.autosave.touch();
  }

  turn(height: number): void {
    this.drawing = { ...this.drawing, view: { ...this.drawing.view, height } };
    this.autosave.touch();
  }

  get radius(): number {
    return this.drawing.document.brush.radius;
  }
}

let vault: FakeVault;
let tabs: FakeTabs;
const page = () => new Page(vault, tabs);
const later = () => vi.advanceTimersByTimeAsync(LATER);
const radiusKept = () => vault.current?.document.brush.radius;

beforeEach(() => {
  vi.useFakeTimers();
  vault = new FakeVault();
  tabs = new FakeTabs();
});

afterEach(() => void vi.useRealTimers());

describe('writing', () => {
  it('keeps a change within a second, once', async () => {
    const one = await page().open();
    one.change(7);
    one.change(8);
    expect(one.autosave.pending).toBe(true);
    await later();
    expect(radiusKept()).toBe(8);
    expect(one.autosave.pending).toBe(false);
    expect(vault.writes).toBe(1);
  });

  it('brings back all of it', async () => {
    const one = await page().open();
    one.change(7);
    one.turn(123.456789012345);
    await later();
    const two = await new Page(vault, new FakeTabs()).open();
    expect(two.drawing).toEqual(one.drawing);
    expect(two.autosave.pending).toBe(false);
    await later();
    expect(vault.writes).toBe(1);
  });

  it('keeps how one looks at it, but calls that no loss', async () => {
    const one = await page().open();
    one.change(7);
    await later();
    one.turn(90);
    expect(one.autosave.pending).toBe(false);
    await later();
    expect(vault.current?.view.height).toBe(90);
  });

  it('goes on after changes in the middle of a write', async () => {
    const one = await page().open();
    one.change(7);
    const written = one.autosave.flush();
    one.change(8);
    await written;
    await later();
    expect(radiusKept()).toBe(8);
  });

  it('writes once for two that ask at the same time', async () => {
    const one = await page().open();
    one.change(7);
    await Promise.all([one.autosave.flush(), one.autosave.flush(), one.autosave.flush()]);
    expect(one.autosave.state).toBe('on');
    expect(vault.writes).toBe(1);
  });

  it('keeps what is there when the page leaves, also in the middle of a write', async () => {
    const one = await page().open();
    one.change(7);
    void one.autosave.flush();
    one.change(8);
    one.autosave.leave();
    await vi.advanceTimersByTimeAsync(0);
    expect(radiusKept()).toBe(8);
    one.change(9);
    await later();
    expect(one.autosave.state).toBe('on');
    expect(radiusKept()).toBe(9);
  });
});

describe('good data', () => {
  it('is not replaced by a page that has not read it', async () => {
    const before = await page().open();
    before.change(7);
    await later();
    for (const trouble of ['fails', 'hangs'] as const) {
      vault.reading = trouble;
      const blind = new Page(vault, new FakeTabs());
      const opening = blind.open();
      blind.change(9);
      await vi.advanceTimersByTimeAsync(10_000);
      await opening;
      blind.change(10);
      blind.autosave.leave();
      await later();
      expect(blind.autosave.state).toBe('blocked');
      expect(blind.autosave.pending).toBe(true);
      expect(radiusKept()).toBe(7);
    }
  });

  it('is not replaced by a blank page, unless a person emptied it', async () => {
    const one = await page().open();
    one.turn(90);
    await later();
    expect(vault.writes).toBe(0);
    one.change(7);
    await later();
    one.clear();
    await later();
    expect(vault.current?.name).toBe('');
  });

  it('that cannot be read is put aside before anything is written', async () => {
    const broken = {
      text: '{"format":"rotund",',
      name: 'Pear',
      time: 1,
      revision: 4,
      ownPaper: false,
      file: null,
    };
    vault.slots.set('current', broken);
    const one = await page().open();
    expect(one.autosave.refused?.text).toBe(broken.text);
    expect(vault.slots.get('unreadable')?.text).toBe(broken.text);
    one.change(7);
    await later();
    expect(radiusKept()).toBe(7);
    expect(vault.slots.get('unreadable')?.text).toBe(broken.text);
    await one.autosave.forgetUnreadable();
    expect(vault.slots.has('unreadable')).toBe(false);
  });

  it('that cannot be read and cannot be put aside stays', async () => {
    const broken = { text: 'nothing', name: '', time: 1, revision: 4, ownPaper: false, file: null };
    vault.slots.set('current', broken);
    vault.writing = 'fails';
    const one = await page().open();
    vault.writing = 'works';
    one.change(7);
    await later();
    expect(one.autosave.state).toBe('blocked');
    expect(vault.slots.get('current')).toBe(broken);
  });

  it('is kept beside what replaced it', async () => {
    const one = await page().open();
    one.change(7);
    await one.autosave.setAside(one.drawing);
    const two = await new Page(vault, new FakeTabs()).open();
    expect(two.autosave.previous?.text).toBe(serialize(one.drawing));
  });
});

describe('a full store', () => {
  it('is known, and tried again with the next change', async () => {
    const one = await page().open();
    vault.writing = 'fails';
    one.change(7);
    await later();
    expect(one.autosave.error).toEqual(new Error('full'));
    expect(one.autosave.pending).toBe(true);
    vault.writing = 'works';
    one.change(8);
    await later();
    expect(one.autosave.error).toBeNull();
    expect(radiusKept()).toBe(8);
  });
});

describe('two pages', () => {
  const both = async () => {
    const older = await page().open();
    older.change(7);
    await later();
    const younger = await page().open();
    return { older, younger };
  };

  it('show the same; the older one keeps it', async () => {
    const { older, younger } = await both();
    expect(younger.radius).toBe(7);
    expect([older.autosave.state, younger.autosave.state]).toEqual(['on', 'elsewhere']);
    younger.change(9);
    await later();
    expect(radiusKept()).toBe(7);
    expect(younger.autosave.pending).toBe(true);
  });

  it('both blank: the one that draws first keeps it', async () => {
    const one = await page().open();
    const two = await page().open();
    expect([one.autosave.state, two.autosave.state]).toEqual(['on', 'on']);
    two.change(7);
    await later();
    expect([one.autosave.state, two.autosave.state]).toEqual(['elsewhere', 'on']);
  });

  it('hand over with the last stroke', async () => {
    const { older, younger } = await both();
    older.change(8);
    const taking = younger.autosave.takeOver();
    await later();
    const found = await taking;
    expect(found?.drawing.document.brush.radius).toBe(8);
    younger.show(found!.drawing);
    expect([older.autosave.state, younger.autosave.state]).toEqual(['elsewhere', 'on']);
    younger.change(9);
    older.change(10);
    await later();
    expect(radiusKept()).toBe(9);
  });

  it('hand over to work of its own, and lose neither', async () => {
    const { younger } = await both();
    younger.change(9);
    const taking = younger.autosave.takeOver();
    await later();
    expect(await taking).toBeNull();
    expect(radiusKept()).toBe(9);
    expect(parse(vault.slots.get('previous')!.text, 'previous').document.brush.radius).toBe(7);
  });

  it('that cannot hear each other do not write over each other', async () => {
    tabs.deaf = true;
    const { older, younger } = await both();
    younger.change(9);
    await later();
    older.change(10);
    await later();
    expect(radiusKept()).toBe(9);
    expect(older.autosave.state).toBe('elsewhere');
    expect(older.autosave.pending).toBe(true);
  });
});

describe.each([1, 2, 3, 4, 5])('a random hour of two pages, seed %i', (seed) => {
  it('never calls kept what is not', async () => {
    const next = random(seed);
    const pages = [await page().open(), await page().open()];
    for (let step = 1; step <= 200; step++) {
      const one = pages[next() < 0.5 ? 0 : 1]!;
      const dice = next();
      tabs.deaf = next() < 0.2;
      vault.writing = next() < 0.1 ? 'fails' : 'works';
      if (dice < 0.5) one.change(1 + step / 10);
      else if (dice < 0.6) one.turn(100 + step);
      else if (dice < 0.65) one.clear();
      else if (dice < 0.7) {
        const taking = one.autosave.takeOver();
        await later();
        const found = await taking;
        if (found) one.show(found.drawing);
      } else if (dice < 0.75) void one.autosave.flush();
      else await vi.advanceTimersByTimeAsync(700 * next());
      await vi.advanceTimersByTimeAsync(0);
      for (const { autosave, drawing } of pages) {
        if (autosave.state !== 'on' || autosave.pending || drawing.name === '') continue;
        // Only a page that could not hear the other may still believe in what it wrote last.
        const revisions = pages.filter((other) => other.autosave.state === 'on').length;
        if (revisions === 1) expect(vault.current?.document).toEqual(drawing.document);
      }
    }
  });
});
