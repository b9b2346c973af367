/** How the columns of a patch's pieces become the entries of its rows: creases twice, closed ones once round from q_l. */
import type { Columns } from '../mesh/grid.ts';
import type { Woven } from './woven.ts';

/** A column of one of the pieces across. */
export interface Entry {
  readonly piece: number;
  readonly column: number;
  readonly v: number;
  readonly joined: boolean;
}

/** The entries of all rows, v ascending from 0 to 1. */
export function entriesOf(across: readonly Pick<Woven, 'vs'>[], closed: boolean): Entry[] {
  const all = across.flatMap(({ vs }, piece) =>
    vs.map((v, column) => ({ piece, column, v, joined: column > 0 })),
  );
  // a closed outline whose first crease is not at q_l is opened there, if that is a column
  const start = closed && all[0]!.v > 0 ? all.findIndex(({ v }) => v === 1) : 0;
  if (start <= 0) {
    const from = all[0]!.v;
    return all.map((entry) => ({ ...entry, v: Math.min(entry.v - from, 1) }));
  }
  const head = all
    .slice(start)
    .map((entry, i) => ({ ...entry, v: entry.v - 1, joined: i > 0 && entry.joined }));
  return [...head, ...all.slice(0, start + 1)];
}

export function columnsOf(entries: readonly Entry[]): Columns {
  return { vs: entries.map(({ v }) => v), joined: entries.map(({ joined }) => joined) };
}

/** One row of a piece's nets each, as entries. Entries in one place share their coordinates when `shared`. */
export function gathered(
  entries: readonly Entry[],
  pieces: readonly Float64Array[],
  closed: boolean,
  shared: boolean,
): Float64Array {
  const out = new Float64Array(3 * entries.length);
  for (let j = 0; j < entries.length; j++) {
    const { piece, column } = entries[j]!;
    const row = pieces[piece]!;
    for (let i = 0; i < 3; i++) out[3 * j + i] = row[3 * column + i]!;
  }
  if (!shared) return out;
  entries.forEach(({ joined }, j) => {
    if (j > 0 && !joined) out.copyWithin(3 * j, 3 * j - 3, 3 * j);
  });
  if (closed) out.copyWithin(out.length - 3, 0, 3);
  return out;
}
