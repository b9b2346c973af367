/**
 * What is near in each brick, as the GPU reads it: one buffer of 16-byte rows. First a header for each brick (its place, where its
 * entries begin, its error), then the entries: of every sum, in the order in which the program comes to them, which terms are
 * asked and what stands for the others; a run of dropped sums is one row. Read by shaders/polygonize/nearList.wgsl.
 */
import { type Brick, type Bricks, hasCreases } from '../../field/bricks.ts';
import type { Near, NearLeaf } from '../../field/near.ts';
import type { FieldNode } from '../../field/node.ts';
import type { PackedBricks } from '../../field/packedBricks.ts';
import { type Program, programOf, TAKE } from '../program.ts';
import { SUM } from '../structs.ts';

/** What an entry says of its sums. */
export const ENTRY = { LISTED: 0, DROPPED_LOW: 1, DROPPED_HIGH: 2 } as const;

/** bricks along an axis: places are 10 bits each */
export const MOST_ALONG = 1 << 10;

const WORDS = 4;

/** What is read of a brick. */
export interface ListedBrick extends Pick<Brick, 'i' | 'j' | 'k'> {
  readonly near: Pick<Near, 'error' | 'eachLeaf' | 'branches'>;
}

/** What is read of bricks. */
export interface ListedBricks extends Pick<Bricks, 'lattice' | 'grid'> {
  readonly active: readonly ListedBrick[];
}

/** Bricks of that very tree. */
export function packBricks(node: FieldNode, { lattice, active, grid }: ListedBricks): PackedBricks {
  const lists = packLists(programOf(node), active);
  return {
    lattice,
    count: active.length,
    hasCreases: hasCreases(active),
    grid,
    lists,
  };
}

/** RangeError for a brick whose near does not tell of every sum. */
export function packLists(program: Program, bricks: readonly ListedBrick[]): Uint32Array<ArrayBuffer> {
  const sums = sumsOf(program);
  const rows = new Rows(bricks.length);
  const found: (NearLeaf | null)[] = sums.map(() => null);
  const placeOf = new Map(sums.map(({ leaf }, place) => [leaf, place]));
  for (const [number, { i, j, k, near }] of bricks.entries()) {
    rows.put(number, [i | (j << 10) | (k << 20), rows.end, 0, 0]);
    rows.putFloat(number, 2, near.error);
    found.fill(null);
    near.eachLeaf((leaf) => {
      const place = placeOf.get(leaf.leaf);
      if (place !== undefined) found[place] = leaf;
    });
    addEntries(rows, sums, found);
  }
  return rows.words();
}

interface SumLeaf {
  /** in the tree's order */
  readonly leaf: number;
  readonly threshold: number;
}

/** In the program's order. */
function sumsOf({ steps, records }: Program): readonly SumLeaf[] {
  const leaves = leavesOf(steps);
  return steps
    .map(({ take, at }, i) => ({ take, at, leaf: leaves[i]! }))
    .filter(({ take }) => take === TAKE.SUM)
    .map(({ at, leaf }) => ({
      leaf,
      threshold: SUM.read(new DataView(records, 16 * at, SUM.stride), 0).threshold,
    }));
}

/** Of each step the number of its leaf in the tree, −1 for the stack: records are written in the tree's order. */
export function leavesOf(steps: Program['steps']): readonly number[] {
  const own = steps.filter(({ take }) => take !== TAKE.STACK);
  const places = own.map(({ at }) => at).sort((a, b) => a - b);
  const leafAt = new Map(places.map((at, leaf) => [at, leaf]));
  return steps.map(({ take, at }) => (take === TAKE.STACK ? -1 : leafAt.get(at)!));
}

function addEntries(rows: Rows, sums: readonly SumLeaf[], found: readonly (NearLeaf | null)[]) {
  for (let i = 0; i < sums.length; ) {
    const leaf = found[i];
    if (!leaf) throw new RangeError(`a brick says nothing of leaf ${sums[i]!.leaf}`);
    const kind = kindOf(leaf);
    const first = i++;
    if (leaf.dropped === null) {
      addListed(rows, sums[first]!, i, leaf);
      continue;
    }
    while (i < sums.length && found[i] && kindOf(found[i]!) === kind) i++;
    rows.put(rows.add(1), [kind, i, 0, 0]);
  }
}

function kindOf(leaf: NearLeaf): number {
  if (leaf.dropped === null) return ENTRY.LISTED;
  return leaf.dropped === 'low' ? ENTRY.DROPPED_LOW : ENTRY.DROPPED_HIGH;
}

const NOTHING = new Float64Array(10);

function addListed(rows: Rows, { threshold }: SumLeaf, end: number, { terms, far }: NearLeaf): void {
  const numbers = terms ?? [];
  const at = rows.add(5 + Math.ceil(numbers.length / WORDS));
  const taylor = far?.taylor ?? NOTHING;
  const colour = far?.colour ?? NOTHING;
  rows.put(at, [ENTRY.LISTED, end, numbers.length, 0]);
  rows.putFloat(at, 3, far ? taylor[0]! : -threshold);
  const four = (row: number, values: ArrayLike<number>, first: number, last: number) => {
    for (let lane = 0; lane < 3; lane++) rows.putFloat(at + row, lane, values[first + lane]!);
    rows.putFloat(at + row, 3, last);
  };
  four(1, far?.centre ?? NOTHING, 0, colour[0]!);
  for (let row = 0; row < 3; row++) four(2 + row, taylor, 1 + 3 * row, colour[1 + row]!);
  rows.put(at + 5, numbers);
}

/** Rows of four words, as many as it takes. */
class Rows {
  #words: Uint32Array<ArrayBuffer>;
  #floats: Float32Array;
  /** rows */
  end: number;

  constructor(rows: number) {
    this.end = rows;
    this.#words = new Uint32Array(WORDS * Math.max(1, 8 * rows));
    this.#floats = new Float32Array(this.#words.buffer);
  }

  /** Where they begin. */
  add(rows: number): number {
    const at = this.end;
    this.end += rows;
    if (WORDS * this.end > this.#words.length) {
      const larger = new Uint32Array(2 * WORDS * this.end);
      larger.set(this.#words);
      this.#words = larger;
      this.#floats = new Float32Array(larger.buffer);
    }
    return at;
  }

  put(row: number, values: readonly number[]): void {
    this.#words.set(values, WORDS * row);
  }

  putFloat(row: number, lane: number, value: number): void {
    this.#floats[WORDS * row + lane] = value;
  }

  /** One row at least: WebGPU binds no empty buffer. */
  words(): Uint32Array<ArrayBuffer> {
    return this.#words.slice(0, WORDS * Math.max(1, this.end));
  }
}
