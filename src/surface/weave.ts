/**
 * What lies under a patch: stands along u, outlines across (alike.ts) and their mix (between.ts), and where rows and columns are.
 */
import { type Alike, alike } from './alike.ts';
import { alongOf } from './along.ts';
import { type Between, type Mix, mixOf } from './between.ts';
import { type KnotPiece, knotPieces } from './knots.ts';
import type { Outline } from './outline.ts';
import type { Source } from './source.ts';
import { leastPieces, turnOf } from './turning.ts';

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
    across: acrossOf(made, columns),
  };
}

/** Points of every outline at the same v. */
export function formsOf({ pieces }: Alike, sections: number): number[][] {
  const vs = Array.from({ length: COMPARED }, (_, i) => i / COMPARED);
  return Array.from({ length: sections }, (_, k) =>
    pieces.flatMap(({ from, to, along }) => vs.flatMap((t) => along[k]!.point(from + (to - from) * t))),
  );
}

/** control spans turn through at most so many times the angle of a circle’s: 28° by default */
const COARSER = 1.25;

/** Creases, q_l and q_r are columns; where a section turns much there are more. */
function acrossOf({ closed, seamless, pieces }: Alike, columns: number): KnotPiece[] {
  const breaks = [...pieces.map(({ from }) => from), pieces[pieces.length - 1]!.to];
  // a ring of one piece needs three columns, and an even number has q_r in the middle
  const least = seamless ? 4 : closed && pieces.length === 1 ? 3 : 1;
  const even = (count: number): number => (seamless ? 2 * Math.ceil(count / 2) : count);
  const turns = pieces.map(({ from, to, along }) =>
    Math.max(...along.map(({ point }) => turnOf(point, from, to))),
  );
  const needed = leastPieces(turns, columns, COARSER);
  return knotPieces(breaks, closed ? [0.5, 1, 1.5] : [], even(columns), (i) =>
    even(Math.max(least, needed[i]!)),
  );
}
