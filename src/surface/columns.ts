/**
 * An outline cut into the columns of a grid: even in v between its corners, which become creases along the surface; more of them
 * where it turns much (turning.ts).
 */
import type { Vec2 } from '../math/vec.ts';
import type { Columns } from '../mesh/grid.ts';
import type { Outline } from './outline.ts';
import { pieces } from './rows.ts';
import { leastPieces, turnOf } from './turning.ts';

export interface OutlineColumns extends Columns {
  readonly closed: boolean;
  /** of each entry; the last of closed ones is the first to the last bit */
  readonly points: readonly Vec2[];
  /** d point / dv, at creases one-sided */
  readonly rates: readonly Vec2[];
}

/** v nearer than this are one */
const SAME = 1e-9;
/** quads turn through at most so many times the angle of a circle's */
const COARSER = 2.5;

/** About `quads` quads; q_l and q_r are always entries. */
export function columnsOf(outline: Outline, quads: number): OutlineColumns {
  const { closed } = outline;
  const wished = [0, ...(closed ? [0.5] : []), ...outline.corners, 1].sort((a, b) => a - b);
  const stops = wished.filter((v, i) => i === 0 || v - wished[i - 1]! > SAME);
  stops[stops.length - 1] = 1;
  const isCorner = (v: number): boolean => outline.corners.some((corner) => Math.abs(corner - v) <= SAME);
  const vs: number[] = [];
  const joined: boolean[] = [];
  const sides: (-1 | 1)[] = [];
  const least = closed ? Math.ceil(3 / (stops.length - 1)) : 1;
  const turns = stops.slice(1).map((to, i) => turnOf(outline.point, stops[i]!, to));
  const needed = leastPieces(turns, quads, COARSER);
  for (const piece of pieces(stops, quads, (i) => Math.max(least, needed[i]!))) {
    piece.forEach((v, k) => {
      // a stop that is no corner is one entry, not two
      if (k === 0 && vs.length > 0 && !isCorner(v)) return;
      vs.push(v);
      joined.push(k > 0);
      sides.push(k === piece.length - 1 ? -1 : 1);
    });
  }
  const points = vs.map((v) => outline.point(v));
  for (let j = 1; j < points.length; j++) if (!joined[j]) points[j] = points[j - 1]!;
  if (closed) points[points.length - 1] = points[0]!;
  return { closed, vs, joined, points, rates: vs.map((v, j) => outline.derivative(v, sides[j]!)) };
}
