/**
 * The lists of bricks on the device while their body is being edited. Each brick keeps its slot, where its header and its values lie; what an
 * edit makes anew is appended, and all of it is written again only where more than half is waste. Where a brick goes the last slot's
 * moves into its place, so that there are no holes.
 */
import type { PackedBricks, PackedEdit } from '../../field/packedBricks.ts';

/** Words to be written into a buffer from word `at` on. */
export interface Write {
  readonly buffer: 'lists' | 'grid';
  readonly at: number;
  readonly words: Uint32Array<ArrayBuffer> | Int32Array<ArrayBuffer>;
}

/** What the device has to do. */
export interface Dirty {
  readonly writes: readonly Write[];
  /** slots whose own nodes are to be evaluated */
  readonly evaluated: Uint32Array<ArrayBuffer>;
  /** slots that may have such nodes in common with others */
  readonly shared: Uint32Array<ArrayBuffer>;
}

interface Slot {
  /** of the brick in the grid */
  readonly number: number;
  /** words of its header */
  readonly place: number;
  readonly error: number;
  readonly entries: Uint32Array;
  /** the row where these begin */
  at: number;
}

const WORDS = 4;
/** as much room as is needed, and some more: bricks come and go */
const SPARE = 1.5;
const SLOTS = 64;
const ROWS = 1024;

export class LiveLists {
  /** bricks along x, y, z */
  readonly #along: readonly [number, number, number];
  /** of each brick of the lattice its slot, or OUTSIDE or INSIDE */
  readonly #grid: Int32Array<ArrayBuffer>;
  readonly #slots: Slot[] = [];
  #room = SLOTS;
  #rows = 0;
  /** the first row that is free, and how many before it no brick has any more */
  #end = 0;
  #waste = 0;

  constructor({ lattice, count, grid, lists }: PackedBricks) {
    const [x, y, z] = lattice.counts;
    this.#along = [(x - 1) / 4, (y - 1) / 4, (z - 1) / 4];
    this.#grid = grid.slice();
    const slots = slotsOf(lists, count);
    grid.forEach((slot, number) => {
      if (slot >= 0) this.#slots[slot] = { ...slots[slot]!, number };
    });
    this.#layOut();
  }

  get count(): number {
    return this.#slots.length;
  }

  /** Slots and rows that there have to be buffers for: while they stay the same, so does what lies in these. */
  get room(): { readonly slots: number; readonly rows: number } {
    return { slots: this.#room, rows: this.#rows };
  }

  /** All that is to be on the device. */
  get whole(): Dirty {
    const all = Uint32Array.from(this.#slots, (_, slot) => slot);
    const writes: Write[] = [
      { buffer: 'lists', at: 0, words: this.#words() },
      { buffer: 'grid', at: 0, words: this.#grid },
    ];
    return { writes, evaluated: all, shared: all };
  }

  edit({ grid, renewed, lists }: PackedEdit): Dirty {
    const { turned, moved, numberOf } = this.#follow(grid);
    const from = this.#end;
    const fresh = slotsOf(lists, renewed.length).map((slot, i) => this.#renew(numberOf[renewed[i]!]!, slot));
    const evaluated = new Set([...fresh, ...moved]);
    const headers = [...evaluated];
    // who owns what there, and what is proven beside it, may be otherwise
    for (const number of turned) this.#eachAround(number, (slot) => evaluated.add(slot));
    const shared = new Set(evaluated);
    for (const slot of evaluated) this.#eachAround(this.#slots[slot]!.number, (near) => shared.add(near));
    if (this.count > this.#room) {
      this.#layOut();
      return this.whole;
    }
    const inGrid = [...turned, ...moved.map((slot) => this.#slots[slot]!.number)];
    return {
      writes: [...this.#written(headers, fresh, from), ...runs('grid', inGrid, this.#grid)],
      evaluated: Uint32Array.from(evaluated),
      shared: Uint32Array.from(shared),
    };
  }

  /** Slots for those that came, none for those that went. */
  #follow(next: Int32Array) {
    const numberOf: number[] = [];
    const turned: number[] = [];
    const came: number[] = [];
    const free: number[] = [];
    next.forEach((now, number) => {
      const before = this.#grid[number]!;
      if (now >= 0) numberOf[now] = number;
      if (now >= 0 ? before >= 0 : before === now) return;
      turned.push(number);
      if (now >= 0) {
        came.push(number);
        return;
      }
      if (before >= 0) free.push(before);
      this.#grid[number] = now;
    });
    for (const slot of free) this.#waste += this.#slots[slot]!.entries.length / WORDS;
    for (const number of came) this.#put(free.pop() ?? this.count, { ...NOTHING, number });
    const moved = free.toSorted((a, b) => b - a).map((slot) => this.#close(slot));
    return { numberOf, turned, moved: moved.filter((slot) => slot < this.count) };
  }

  #put(slot: number, what: Slot): void {
    this.#slots[slot] = what;
    this.#grid[what.number] = slot;
  }

  /** The last one moves into a slot that is free. */
  #close(slot: number): number {
    const last = this.#slots.pop()!;
    if (slot < this.count) this.#put(slot, last);
    return slot;
  }

  #renew(number: number, { place, error, entries }: Slot): number {
    const slot = this.#grid[number]!;
    this.#waste += this.#slots[slot]!.entries.length / WORDS;
    this.#slots[slot] = { number, place, error, entries, at: this.#end };
    this.#end += entries.length / WORDS;
    return slot;
  }

  /** Headers, and the entries from row `from` on; all of it where there is no room or too much waste. */
  #written(headers: readonly number[], fresh: readonly number[], from: number): readonly Write[] {
    if (this.#end > this.#rows || 2 * this.#waste > this.#end - this.#room) {
      this.#layOut();
      return [{ buffer: 'lists', at: 0, words: this.#words() }];
    }
    const added = new Uint32Array(WORDS * (this.#end - from));
    for (const slot of fresh) {
      const { entries, at } = this.#slots[slot]!;
      added.set(entries, WORDS * (at - from));
    }
    const own = new Uint32Array(WORDS * this.count);
    for (const slot of headers) own.set(headerOf(this.#slots[slot]!), WORDS * slot);
    const words = headers.flatMap((slot) => [0, 1, 2, 3].map((lane) => WORDS * slot + lane));
    const tail: readonly Write[] =
      added.length > 0 ? [{ buffer: 'lists', at: WORDS * from, words: added }] : [];
    return [...runs('lists', words, own), ...tail];
  }

  /** All entries one after the other, behind room for headers. */
  #layOut(): void {
    if (this.count > this.#room) this.#room = Math.ceil(SPARE * this.count) + SLOTS;
    this.#end = this.#room;
    this.#waste = 0;
    for (const slot of this.#slots) {
      slot.at = this.#end;
      this.#end += slot.entries.length / WORDS;
    }
    if (this.#end > this.#rows) this.#rows = Math.ceil(SPARE * this.#end) + ROWS;
  }

  #words(): Uint32Array<ArrayBuffer> {
    const words = new Uint32Array(WORDS * this.#end);
    this.#slots.forEach((slot, i) => {
      words.set(headerOf(slot), WORDS * i);
      words.set(slot.entries, WORDS * slot.at);
    });
    return words;
  }

  /** The slots of the bricks around one, and its own. */
  #eachAround(number: number, visit: (slot: number) => void): void {
    const [nx, ny, nz] = this.#along;
    const [i, j, k] = [number % nx, Math.floor(number / nx) % ny, Math.floor(number / (nx * ny))];
    for (let z = Math.max(k - 1, 0); z <= Math.min(k + 1, nz - 1); z++)
      for (let y = Math.max(j - 1, 0); y <= Math.min(j + 1, ny - 1); y++)
        for (let x = Math.max(i - 1, 0); x <= Math.min(i + 1, nx - 1); x++) {
          const slot = this.#grid[x + nx * (y + ny * z)]!;
          if (slot >= 0) visit(slot);
        }
  }
}

const NOTHING = { number: -1, place: 0, error: 0, at: 0, entries: new Uint32Array(0) };

const headerOf = ({ place, at, error }: Slot): readonly number[] => [place, at, error, 0];

/** What lists.ts wrote: headers, then entries, in the same order. */
function slotsOf(lists: Uint32Array, count: number): readonly Slot[] {
  const start = (i: number) => (i < count ? lists[WORDS * i + 1]! : lists.length / WORDS);
  return Array.from({ length: count }, (_, i) => ({
    ...NOTHING,
    place: lists[WORDS * i]!,
    error: lists[WORDS * i + 2]!,
    entries: lists.slice(WORDS * start(i), WORDS * start(i + 1)),
  }));
}

/** Those words of an array, neighbours together. */
function runs(
  buffer: Write['buffer'],
  words: readonly number[],
  from: Uint32Array<ArrayBuffer> | Int32Array<ArrayBuffer>,
): readonly Write[] {
  const places = [...new Set(words)].sort((a, b) => a - b);
  const found: Write[] = [];
  for (let i = 0, first = 0; i < places.length; i++) {
    if (places[i + 1] === places[i]! + 1) continue;
    found.push({ buffer, at: places[first]!, words: from.slice(places[first]!, places[i]! + 1) });
    first = i + 1;
  }
  return found;
}
