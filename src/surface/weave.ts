/**
 * What lies under a patch: stands along u, outlines across (alike.ts) and their mix (between.ts), and where rows and columns are.
 */
import { length2 } from '../math/tuple.ts';
import { type Alike, type AlikePiece, alike } from './alike.ts';
import { alongOf } from './along.ts';
import { type Between, type Mix, mixOf } from './between.ts';
import { type KnotPiece, knotPieces, knotsOf } from './knots.ts';
import type { Outline } from './outline.ts';
import type { Source } from './source.ts';

/** A section where it stands. */
export interface PlacedOutline {
  /** along the construction curves, 0–1 */
  readonly u: number;
  readonly outline: Outline;
}

export interface Weave {
  readonly source: Source;
  readonly alike: Alike;
  readonly mix: Mix;
  /** control spans between stops and sections */
  readonly along: readonly KnotPiece[];
  /** control spans between creases, one for each of alike's pieces */
  readonly across: readonly KnotPiece[];
}

export interface WeaveSpans {
  /** of all pieces together, about; null: as many as keep to the construction curves (along.ts) */
  readonly rows: number | null;
  /** of all pieces together, about; where the rows are as many as needed at least, and twice or four times as many for sections of many folds */
  readonly columns: number;
}

/** places across at which the changes of outlines are compared */
const COMPARED = 16;

/** At least one section. Those in one place count once, the last given. */
export function weaveOf(
  source: Source,
  sections: readonly PlacedOutline[],
  between: Between,
  { rows, columns }: WeaveSpans,
): Weave {
  // of a ring the end is the beginning
  const placed = sections.map((section) =>
    source.closed && section.u >= 1 ? { ...section, u: 0 } : section,
  );
  const kept = placed
    .filter(({ u }, i) => !placed.some((other, j) => j > i && other.u === u))
    .sort((a, b) => a.u - b.u);
  const us = kept.map(({ u }) => u);
  const made = alike(kept.map(({ outline }) => outline));
  return {
    source,
    alike: made,
    mix: mixOf(us, formsOf(made, us.length), between, source.closed),
    along: alongOf(source, us, rows),
    across: rows === null ? acrossFor(made, columns) : acrossOf(made, columns),
  };
}

/** Points of every outline at the same v. */
export function formsOf({ pieces }: Alike, sections: number): number[][] {
  const vs = Array.from({ length: COMPARED }, (_, i) => i / COMPARED);
  return Array.from({ length: sections }, (_, k) =>
    pieces.flatMap(({ from, to, along }) => vs.flatMap((t) => along[k]!.point(from + (to - from) * t))),
  );
}

/** more columns than this do not come by themselves */
const MOST_COLUMNS = 64;
/** half chords: what a section may be missed by. Sixteen columns miss a hem of nine folds by 0.23, 64 by 0.01 */
const MISS = 0.01;

/** Doubled until cubic pieces from column to column keep to all sections. */
function acrossFor(made: Alike, columns: number): KnotPiece[] {
  const across = acrossOf(made, columns);
  const keeps = across.every((piece, i) => keepsTo(made.pieces[i]!, knotsOf(piece)));
  return keeps || 2 * columns > MOST_COLUMNS ? across : acrossFor(made, 2 * columns);
}

/** By the Hermite cubic of every span, half way. */
const keepsTo = ({ along }: AlikePiece, knots: readonly number[]): boolean =>
  along.every(({ point, derivative }) =>
    knots.slice(1).every((to, k) => {
      const from = knots[k]!;
      const [a, b, middle] = [point(from), point(to), point((from + to) / 2)];
      const [da, db] = [derivative(from), derivative(to)];
      const miss = (i: 0 | 1) => (a[i] + b[i]) / 2 + ((to - from) * (da[i] - db[i])) / 8 - middle[i];
      return length2([miss(0), miss(1)]) < MISS;
    }),
  );

/** Creases, q_l and q_r are columns. */
function acrossOf({ closed, seamless, pieces }: Alike, columns: number): KnotPiece[] {
  const breaks = [...pieces.map(({ from }) => from), pieces[pieces.length - 1]!.to];
  // a ring of one piece needs three columns, and an even number has q_r in the middle
  const least = seamless ? 4 : closed && pieces.length === 1 ? 3 : 1;
  const wish = seamless ? 2 * Math.ceil(columns / 2) : columns;
  return knotPieces(breaks, closed ? [0.5, 1, 1.5] : [], wish, () => least);
}
