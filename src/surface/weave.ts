/**
 * What lies under a patch: stands along u, outlines across (alike.ts) and their mix (between.ts), and where rows and columns are.
 *
 * A stand maps outlines linearly into space. So mixing outlines and placing them may as well be done to the control points of
 * outlines as to their points, and derivatives along u follow by the product rule.
 */
import type { Vec3 } from '../math/vec.ts';
import { type Alike, alike } from './alike.ts';
import { type Between, type Mix, mixOf, type Share } from './between.ts';
import { type KnotPiece, knotPieces } from './knots.ts';
import type { Outline } from './outline.ts';
import type { Stand, Standing } from './placing.ts';

/** An outline where it is a section of the surface. */
export interface PlacedOutline {
  readonly u: number;
  readonly outline: Outline;
}

export interface Weave {
  readonly standing: Standing;
  readonly alike: Alike;
  readonly mix: Mix;
  /** control spans between stops (and, without a spline, sections) */
  readonly along: readonly KnotPiece[];
  /** control spans between creases, one for each of alike's pieces */
  readonly across: readonly KnotPiece[];
}

export interface WeaveSpans {
  /** of all pieces together, about */
  readonly rows: number;
  readonly columns: number;
}

/** places across at which the changes of outlines are compared */
const COMPARED = 16;

/** At least one section. Those in one place count once, the last given. */
export function weaveOf(
  standing: Standing,
  sections: readonly PlacedOutline[],
  between: Between,
  { rows, columns }: WeaveSpans,
): Weave {
  const kept = sections
    .filter(({ u }, i) => !sections.some((other, j) => j > i && other.u === u))
    .sort((a, b) => a.u - b.u);
  const us = kept.map(({ u }) => u);
  const made = alike(kept.map(({ outline }) => outline));
  return {
    standing,
    alike: made,
    mix: mixOf(us, formsOf(made, us.length), between, standing.closed),
    along: alongOf(standing, us, between, rows),
    across: acrossOf(made, columns),
  };
}

/** Points of every outline at the same v. */
function formsOf({ pieces }: Alike, sections: number): number[][] {
  const vs = Array.from({ length: COMPARED }, (_, i) => i / COMPARED);
  return Array.from({ length: sections }, (_, k) =>
    pieces.flatMap(({ from, to, along }) => vs.flatMap((t) => along[k]!.point(from + (to - from) * t))),
  );
}

/** Every section is a row. Without a spline it is the end of a piece, for there is an edge. */
function alongOf({ stops, closed }: Standing, us: readonly number[], between: Between, rows: number): KnotPiece[] {
  const ends = stops.map(({ u }) => u);
  const own = between === 'plain' ? us.filter((u) => ends.every((end) => Math.abs(end - u) > 1e-6)) : [];
  const breaks = [...ends, ...own].sort((a, b) => a - b);
  const pole = (u: number): boolean => stops.some((stop) => stop.u === u && stop.pole);
  const least = (i: number): number => {
    if (pole(breaks[i]!) && pole(breaks[i + 1]!)) return 2;
    return closed ? Math.ceil(3 / (breaks.length - 1)) : 1;
  };
  return knotPieces(breaks, us, rows, least);
}

/** Creases, q_l and q_r are columns. */
function acrossOf({ closed, seamless, pieces }: Alike, columns: number): KnotPiece[] {
  const breaks = [...pieces.map(({ from }) => from), pieces[pieces.length - 1]!.to];
  // a ring of one piece needs three columns, and an even number has q_r in the middle
  const least = seamless ? 4 : closed && pieces.length === 1 ? 3 : 1;
  const wish = seamless ? 2 * Math.ceil(columns / 2) : columns;
  return knotPieces(breaks, closed ? [0.5, 1, 1.5] : [], wish, () => least);
}

/** A row, x y z, and its derivative by u. */
export interface WovenRow {
  readonly at: Float64Array;
  readonly rate: Float64Array;
}

/**
 * What becomes of outline vectors (x y x y …, one list a section) at u. `kind`: points, or derivatives of points, which have no
 * place.
 */
export function rowAt(
  { standing, mix }: Pick<Weave, 'standing' | 'mix'>,
  forms: readonly (readonly number[])[],
  kind: 'points' | 'vectors',
  u: number,
  side: -1 | 1,
): WovenRow {
  const shares = mix(u, side);
  const { stand, rate } = standing.at(u, side);
  const form = blended(forms, shares, 'weight');
  const isPoint = kind === 'points';
  const moved = onStand(rate, form, isPoint);
  const changed = onStand(stand, blended(forms, shares, 'rate'), false);
  return { at: onStand(stand, form, isPoint), rate: moved.map((x, i) => x + changed[i]!) };
}

function blended(forms: readonly (readonly number[])[], shares: readonly Share[], by: 'weight' | 'rate'): number[] {
  const out = new Array<number>(forms[0]!.length).fill(0);
  for (const share of shares) {
    const factor = share[by];
    if (factor === 0) continue;
    const form = forms[share.section]!;
    for (let i = 0; i < out.length; i++) out[i]! += factor * form[i]!;
  }
  return out;
}

function onStand({ centre, half, depth }: Stand, form: readonly number[], isPoint: boolean): Float64Array {
  const out = new Float64Array((form.length / 2) * 3);
  const from: Vec3 = isPoint ? centre : [0, 0, 0];
  for (let j = 0; 2 * j < form.length; j++) {
    const [x, y] = [form[2 * j]!, form[2 * j + 1]!];
    for (let k = 0; k < 3; k++) out[3 * j + k] = from[k]! + x * half[k]! + y * depth[k]!;
  }
  return out;
}
