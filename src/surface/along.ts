/**
 * Rows of control points along u (thesis fig. 5.15: too few of them miss the construction curves).
 *
 * Pieces end at stops and at sections, so that every section is a row. There are 16 in all, and wherever the spline
 * misses a curve by more than 0.5 % of the chord there, its piece is halved again and again; a tip that was drawn with a
 * small hook costs rows at the tip alone. Pieces meet with one derivative. Tried: doubling all rows; 256 of them still miss
 * the tips of a leaf drawn by hand by 11 % of their chord.
 */
import { length3 } from '../math/tuple.ts';
import { limitMask } from './bspline.ts';
import { type KnotPiece, knotPieces, knotsOf } from './knots.ts';
import { masked, subdivided } from './net.ts';
import type { Source } from './source.ts';
import { clampedThrough, netOfRows } from './through.ts';
import { rowAt } from './wovenRow.ts';

export const FEWEST_ROWS = 16;
export const MOST_ROWS = 256;

/** the surface may miss a curve by this part of the chord there … */
const MISS = 0.005;
/** … a chord that is as short as this part of the longest counting as so long */
const SHORTEST = 1e-3;
/** places looked at in every span: quarters */
const TIMES = 2;
/** pieces of so many spans are halved with as many in each half, longer ones with half as many */
const FEW = 4;
/** u nearer to each other are one place */
const SAME = 2e-3;

interface Known {
  readonly key: string;
  readonly pieces: readonly KnotPiece[];
}

/** Of each source the last: it depends on the places of sections alone, not on what is drawn there. */
const spans = new WeakMap<Source, Known>();

/** Control spans along `source` with sections at `us`; `rows`: about so many, null: as many as it needs. */
export function alongOf(source: Source, us: readonly number[], rows: number | null): readonly KnotPiece[] {
  const key = JSON.stringify([us, rows]);
  const known = spans.get(source);
  if (known?.key === key) return known.pieces;
  const pieces = spansAlong(source, us, rows);
  spans.set(source, { key, pieces });
  return pieces;
}

function spansAlong(source: Source, us: readonly number[], rows: number | null): KnotPiece[] {
  const { stops, closed } = source;
  const breaks = stops.map(({ u }) => u);
  for (const u of us) if (breaks.every((other) => Math.abs(other - u) > SAME)) breaks.push(u);
  breaks.sort((a, b) => a - b);
  const pole = (u: number): boolean => stops.some((stop) => stop.u === u && stop.pole);
  const least = (i: number): number => {
    if (pole(breaks[i]!) && pole(breaks[i + 1]!)) return 2;
    return closed ? Math.ceil(3 / (breaks.length - 1)) : 1;
  };
  const even = knotPieces(breaks, [], rows ?? FEWEST_ROWS, least);
  return rows === null ? refined(source, even) : even;
}

interface Tried {
  readonly piece: KnotPiece;
  /** the most it misses by, in what is allowed */
  readonly miss: number;
}

function refined(source: Source, even: readonly KnotPiece[]): KnotPiece[] {
  const longest = Math.max(...Array.from({ length: 65 }, (_, i) => 2 * source.stand(i / 64, 1).radius));
  const tried = (piece: KnotPiece): Tried => ({ piece, miss: missOf(source, piece, longest) });
  const pieces = even.map(tried);
  let rows = even.reduce((sum, { spans }) => sum + spans, 0);
  while (rows < MOST_ROWS) {
    const worst = pieces.reduce((a, b) => (b.miss > a.miss ? b : a));
    if (!(worst.miss > 1)) break;
    const halves = halved(worst.piece);
    rows += 2 * halves[0]!.spans - worst.piece.spans;
    pieces.splice(pieces.indexOf(worst), 1, ...halves.map(tried));
  }
  return pieces.map(({ piece }) => piece);
}

function halved({ from, to, spans }: KnotPiece): KnotPiece[] {
  const each = spans > FEW ? Math.ceil(spans / 2) : spans;
  return knotPieces([from, (from + to) / 2, to], [], 2 * each, () => each);
}

/** How far q_l and q_r, as a patch of two columns, come from themselves. */
function missOf(source: Source, piece: KnotPiece, longest: number): number {
  const mix = () => [{ section: 0, weight: 1, rate: 0 }];
  const rowsAt = (us: readonly number[]) =>
    us.map((u, k) => rowAt({ source, mix }, [[-1, 0, 1, 0]], 'points', u, k === us.length - 1 ? -1 : 1));
  const rows = rowsAt(knotsOf(piece));
  const slope = (k: number, t: number): Float64Array => rows[k]!.rate.map((x) => x * piece.map.slope(t));
  const ends = { first: slope(0, 0), last: slope(rows.length - 1, piece.spans) };
  const points = rows.map(({ at }) => at);
  const fine = subdivided(netOfRows(clampedThrough(points, ends)), 'u', 'clamped', TIMES);
  const found = masked(fine, 'u', limitMask(fine.rows, 'clamped')).points;
  let most = 0;
  rowsAt(knotsOf(piece, TIMES)).forEach(({ at }, i) => {
    const chord = length3([at[3]! - at[0]!, at[4]! - at[1]!, at[5]! - at[2]!]);
    const allowed = MISS * Math.max(chord, SHORTEST * longest);
    for (const k of [0, 3]) {
      const [x, y, z] = [0, 1, 2].map((d) => found[6 * i + k + d]! - at[k + d]!);
      most = Math.max(most, length3([x!, y!, z!]) / (allowed || 1));
    }
  });
  return most;
}
