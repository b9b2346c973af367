/**
 * Columns of control points across sections: as along.ts has rows, so that the spline through the points of every section keeps to it
 * between them. Pieces that miss get half as many again, each by itself.
 *
 * Tried: the Hermite cubic of a span, half way along, for all pieces at once: eight bumps were missed by 3 % of the half chord, for the
 * spline's slopes are others, and a miss is seldom widest in the middle.
 */
import type { Alike, AlikePiece, Along } from './alike.ts';
import { limitMask } from './bspline.ts';
import { type KnotPiece, knotPieces, knotsOf } from './knots.ts';
import { masked, subdivided } from './net.ts';
import { clampedThrough, netOfRows, periodicThrough } from './through.ts';

/** half chords: what the spline may miss a section by */
const MISS = 0.005;
/** where it is looked at: quarters of spans */
const TIMES = 2;
/** sections cost at most so many times the wished number, or so many: a scribble is missed by any */
const TIMES_MORE = 6;
const MOST_COLUMNS = 256;

/** Control spans between creases, one for each of alike's pieces: about `columns` in all, more where a section has many bumps. */
export function acrossOf(made: Alike, columns: number): KnotPiece[] {
  const least = made.pieces.map(() => leastOf(made));
  for (;;) {
    const across = piecesOf(made, columns, least);
    const misses = across.map((piece, i) => !keepsTo(made.pieces[i]!, piece, made.seamless));
    const count = across.reduce((sum, { spans }) => sum + spans, 0);
    if (count >= Math.min(TIMES_MORE * columns, MOST_COLUMNS) || !misses.includes(true)) return across;
    across.forEach(({ spans }, i) => {
      least[i] = misses[i] ? Math.ceil(1.5 * spans) : spans;
      if (made.seamless) least[i] = even(least[i]!);
    });
  }
}

/** A ring of one piece needs three columns, and an even number has q_r in the middle. */
const leastOf = ({ seamless, closed, pieces }: Alike): number =>
  seamless ? 4 : closed && pieces.length === 1 ? 3 : 1;

const even = (count: number): number => 2 * Math.ceil(count / 2);

/** Creases, q_l and q_r are columns. */
function piecesOf(
  { closed, seamless, pieces }: Alike,
  columns: number,
  least: readonly number[],
): KnotPiece[] {
  const breaks = [...pieces.map(({ from }) => from), pieces[pieces.length - 1]!.to];
  return knotPieces(
    breaks,
    closed ? [0.5, 1, 1.5] : [],
    seamless ? even(columns) : columns,
    (i) => least[i]!,
  );
}

/** Every section, at quarters of all spans. */
function keepsTo({ along }: AlikePiece, piece: KnotPiece, seamless: boolean): boolean {
  const ends = seamless ? 'periodic' : 'clamped';
  const vs = knotsOf(piece, TIMES);
  return along.every((outline) => {
    const controls = controlsAcross(outline, piece, seamless).map(([x, y]) => Float64Array.of(x!, y!, 0));
    const fine = subdivided(netOfRows(controls), 'u', ends, TIMES);
    const { rows, points } = masked(fine, 'u', limitMask(fine.rows, ends));
    return vs.every((v, k) => {
      const [x, y] = outline.point(v);
      const at = 3 * (k % rows);
      return Math.abs(points[at]! - x) < MISS && Math.abs(points[at + 1]! - y) < MISS;
    });
  });
}

/** Control points of one outline, x y each. */
export function controlsAcross(outline: Along, knots: KnotPiece, seamless: boolean): Float64Array[] {
  const points = knotsOf(knots).map((v) => Float64Array.from(outline.point(v)));
  if (seamless) return periodicThrough(points.slice(0, -1));
  const slope = (v: number, t: number): Float64Array =>
    Float64Array.from(outline.derivative(v), (x) => x * knots.map.slope(t));
  return clampedThrough(points, { first: slope(knots.from, 0), last: slope(knots.to, knots.spans) });
}
