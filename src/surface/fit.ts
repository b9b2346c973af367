/** How many rows a patch needs, so that its spline keeps to both construction curves between them. */
import { length3 } from '../math/tuple.ts';
import { limitMask } from './bspline.ts';
import { type KnotPiece, knotsOf } from './knots.ts';
import { masked, subdivided } from './net.ts';
import type { Standing } from './placing.ts';
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

/** The fewest of 16, 32, … 256 with which `cut` (rows → pieces) misses the curves by no more than 0.5 % of the chord. */
export function rowsFor(standing: Standing, cut: (rows: number) => readonly KnotPiece[]): number {
  let rows = FEWEST_ROWS;
  while (rows < MOST_ROWS && !cut(rows).every((piece) => fits(standing, piece, longestChord(standing))))
    rows *= 2;
  return rows;
}

function longestChord(standing: Standing): number {
  return Math.max(...Array.from({ length: 65 }, (_, i) => 2 * standing.at(i / 64, 1).radius));
}

/** q_l and q_r as a patch of two columns, compared with themselves. */
function fits(standing: Standing, piece: KnotPiece, longest: number): boolean {
  const truth = (us: readonly number[]) =>
    us.map((u, k) =>
      rowAt(
        { standing, mix: () => [{ section: 0, weight: 1, rate: 0 }] },
        [[-1, 0, 1, 0]],
        'points',
        u,
        k === us.length - 1 ? -1 : 1,
      ),
    );
  const rows = truth(knotsOf(piece));
  const net = netOfRows(
    clampedThrough(
      rows.map(({ at }) => at),
      {
        first: rows[0]!.rate.map((x) => x * piece.map.slope(0)),
        last: rows[rows.length - 1]!.rate.map((x) => x * piece.map.slope(piece.spans)),
      },
    ),
  );
  const fine = subdivided(net, 'u', 'clamped', TIMES);
  const { points } = masked(fine, 'u', limitMask(fine.rows, 'clamped'));
  return truth(knotsOf(piece, TIMES)).every(({ at }, i) => {
    const chord = length3([at[3]! - at[0]!, at[4]! - at[1]!, at[5]! - at[2]!]);
    const allowed = MISS * Math.max(chord, SHORTEST * longest);
    const away = (k: number): number =>
      length3(
        [0, 1, 2].map((d) => points[6 * i + k + d]! - at[k + d]!) as unknown as [number, number, number],
      );
    return away(0) <= allowed && away(3) <= allowed;
  });
}
