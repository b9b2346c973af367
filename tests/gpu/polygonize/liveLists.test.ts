/** The lists of an edited body, as the device has them after what was written: each brick finds its own, whatever came and went. */
import { expect, test } from 'vitest';
import { INSIDE, OUTSIDE } from '../../../src/field/bricks.ts';
import type { PackedEdit } from '../../../src/field/packedBricks.ts';
import { type Dirty, LiveLists } from '../../../src/gpu/polygonize/liveLists.ts';
import { random } from '../../fixtures/random.ts';

const ALONG = [5, 4, 3] as const;
const BRICKS = ALONG[0] * ALONG[1] * ALONG[2];
const lattice = { origin: [0, 0, 0], step: 1, counts: [21, 17, 13] } as const;

/** Lists as lists.ts packs them: a brick's entries are rows of its mark. */
function packed(marks: readonly number[]): Uint32Array<ArrayBuffer> {
  const rows = marks.map((mark) => 1 + (mark % 4));
  const words: number[] = [];
  let at = marks.length;
  for (const [i, mark] of marks.entries()) {
    words.push(mark, at, mark + 1, 0);
    at += rows[i]!;
  }
  for (const [i, mark] of marks.entries()) for (let k = 0; k < 4 * rows[i]!; k++) words.push(mark);
  return Uint32Array.from(words.length > 0 ? words : [0, 0, 0, 0]);
}

/** What lies on the device. */
class Device {
  lists = new Uint32Array(1 << 16);
  grid = new Int32Array(BRICKS);
  /** which brick with which mark each slot was evaluated for */
  readonly values = new Map<number, string>();

  take({ writes, evaluated }: Dirty): number {
    for (const { buffer, at, words } of writes) this[buffer].set(words, at);
    for (const slot of evaluated) this.values.set(slot, this.markOf(slot));
    return writes.reduce((sum, { words }) => sum + words.length, 0);
  }

  markOf(slot: number): string {
    return `${this.grid.indexOf(slot)}: ${this.lists[4 * slot]}`;
  }

  /** Of a brick, all words that its header leads to, which are of its mark. */
  expectBrick(number: number, mark: number): void {
    const slot = this.grid[number]!;
    const [own, at, error] = this.lists.subarray(4 * slot, 4 * slot + 3);
    expect([own, error]).toEqual([mark, mark + 1]);
    const entries = this.lists.slice(4 * at!, 4 * at! + 4 * (1 + (mark % 4)));
    expect([...new Set(entries)]).toEqual([mark]);
  }
}

test.each([1, 2, 3, 4, 5, 6])('40 edits, of few and of many bricks, seed %i', (seed) => {
  const next = random(seed);
  const marks = new Map<number, number>();
  let mark = 1;
  const share = [0.02, 0.1, 0.6][seed % 3]!;
  for (let n = 0; n < BRICKS; n++) if (next() < 0.3) marks.set(n, mark++);
  const gridOf = () => {
    const order = [...marks.keys()].sort((a, b) => a - b);
    const grid = new Int32Array(BRICKS).map(() => (next() < 0.5 ? OUTSIDE : INSIDE));
    for (const [place, number] of order.entries()) grid[number] = place;
    return { grid, order };
  };
  const first = gridOf();
  const lists = new LiveLists({
    lattice,
    count: first.order.length,
    hasCreases: false,
    grid: first.grid,
    lists: packed(first.order.map((number) => marks.get(number)!)),
  });
  const device = new Device();
  const whole = device.take(lists.whole);
  let least = Infinity;
  for (let edit = 0; edit < 40; edit++) {
    const renewed = new Set<number>();
    for (let n = 0; n < BRICKS; n++) {
      if (next() > share) continue;
      if (next() < 0.3) marks.delete(n);
      else {
        marks.set(n, mark++);
        renewed.add(n);
      }
    }
    const { grid, order } = gridOf();
    const places = order.flatMap((number, place) => (renewed.has(number) ? [place] : []));
    const what: PackedEdit = {
      grid,
      hasCreases: false,
      renewed: Uint32Array.from(places),
      lists: packed(places.map((place) => marks.get(order[place]!)!)),
    };
    const dirty = lists.edit(what);
    least = Math.min(least, device.take(dirty));
    expect(lists.count).toBe(marks.size);
    const slots = order.map((number) => device.grid[number]!);
    expect(slots.toSorted((a, b) => a - b)).toEqual(Array.from(slots, (_, slot) => slot));
    for (const [number, own] of marks) device.expectBrick(number, own);
    // of all, also of those that are where another one was, the values are their own
    for (const slot of slots) expect(device.values.get(slot)).toBe(device.markOf(slot));
    for (const slot of dirty.evaluated) expect(dirty.shared).toContain(slot);
  }
  if (share < 0.05) expect(least).toBeLessThan(0.6 * whole);
});
