/**
 * What lies under a patch: stands along u, outlines across (alike.ts) and their mix (between.ts), and where rows and columns are.
 */
import { acrossOf } from './across.ts';
import { type Alike, alike } from './alike.ts';
import { alongOf } from './along.ts';
import { type Between, type Mix, mixOf } from './between.ts';
import type { KnotPiece } from './knots.ts';
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
  /** of all pieces together, about, and as many more as it takes to keep to sections of many bumps (across.ts) */
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
  const kept = inOrder(sections, source.closed);
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

/** By u, of those in one place the last given; of a ring the end is the beginning. */
export function inOrder(sections: readonly PlacedOutline[], isRound: boolean): readonly PlacedOutline[] {
  const placed = sections.map((section) => (isRound && section.u >= 1 ? { ...section, u: 0 } : section));
  return placed
    .filter(({ u }, i) => !placed.some((other, j) => j > i && other.u === u))
    .sort((a, b) => a.u - b.u);
}

/** Points of every outline at the same v. */
export function formsOf({ pieces }: Alike, sections: number): number[][] {
  const vs = Array.from({ length: COMPARED }, (_, i) => i / COMPARED);
  return Array.from({ length: sections }, (_, k) =>
    pieces.flatMap(({ from, to, along }) => vs.flatMap((t) => along[k]!.point(from + (to - from) * t))),
  );
}
