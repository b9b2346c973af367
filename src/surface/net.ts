/**
 * Nets of points, rows × columns, as tensor products: what a mask does to a spline it does to every row (along v) or to every
 * column (along u), in either order.
 */
import { type Ends, limitMask, type Mask, slopeMask, subdivisionMask } from './bspline.ts';

export interface Net {
  readonly rows: number;
  readonly columns: number;
  /** rows × columns × 3: x y z, row by row */
  readonly points: Float64Array;
}

/** u: from row to row; v: from column to column. */
export type Direction = 'u' | 'v';

/** Points, and derivatives per span, at the knots of a control net. */
export interface Limit {
  readonly points: Net;
  readonly du: Net;
  readonly dv: Net;
  readonly duv: Net;
}

/** The mask over every column (u) or row (v). */
export function masked(net: Net, direction: Direction, mask: Mask): Net {
  const along = direction === 'u';
  const count = along ? net.rows : net.columns;
  const step = along ? 3 * net.columns : 3;
  const blocks = along ? 1 : net.rows;
  const points = new Float64Array(blocks * mask.length * step);
  const given = net.points;
  for (let block = 0; block < blocks; block++) {
    const from = block * count * step;
    for (let j = 0; j < mask.length; j++) {
      const { from: first, weights } = mask[j]!;
      const to = (block * mask.length + j) * step;
      for (let k = 0; k < weights.length; k++) {
        const weight = weights[k]!;
        const source = from + ((first + k + count) % count) * step;
        for (let i = 0; i < step; i++) points[to + i]! += weight * given[source + i]!;
      }
    }
  }
  return along
    ? { rows: mask.length, columns: net.columns, points }
    : { rows: net.rows, columns: mask.length, points };
}

/** A control net of the same surface with every span halved `times` times. */
export function subdivided(net: Net, direction: Direction, ends: Ends, times: number): Net {
  let found = net;
  for (let i = 0; i < times; i++) {
    const count = direction === 'u' ? found.rows : found.columns;
    found = masked(found, direction, subdivisionMask(count, ends));
  }
  return found;
}

/** The surface at the knots of its net: (spans + 1) points where it is clamped, spans where it is periodic. */
export function limitOf(net: Net, ends: { readonly u: Ends; readonly v: Ends }): Limit {
  const u = { at: limitMask(net.rows, ends.u), slope: slopeMask(net.rows, ends.u) };
  const v = { at: limitMask(net.columns, ends.v), slope: slopeMask(net.columns, ends.v) };
  const across = masked(net, 'v', v.at);
  const slopes = masked(net, 'v', v.slope);
  return {
    points: masked(across, 'u', u.at),
    du: masked(across, 'u', u.slope),
    dv: masked(slopes, 'u', u.at),
    duv: masked(slopes, 'u', u.slope),
  };
}
