/** The rows of one piece of a patch along u, and its ends as outlines, for what goes on from them: lids, domes, joints at corners. */
import { dot3, sub3 } from '../math/tuple.ts';
import type { Vec2, Vec3 } from '../math/vec.ts';
import type { OutlineColumns } from './columns.ts';
import { columnsOf, type Entry, gathered } from './entries.ts';
import type { Net } from './net.ts';
import { normalsOf } from './normals.ts';
import { type Axes, axesOf } from './placing.ts';
import type { SheetRow } from './sheet.ts';
import type { Source } from './source.ts';
import type { Woven } from './woven.ts';

export interface PieceRows {
  readonly rows: readonly SheetRow[];
  /** the outline at its first or last row */
  form(end: 'first' | 'last'): OutlineColumns;
}

export function pieceRows(
  source: Source,
  across: readonly Woven[],
  entries: readonly Entry[],
  closed: boolean,
): PieceRows {
  const us = across[0]!.us;
  const last = us.length - 1;
  const tips = { first: isTip(source, us[0]!), last: isTip(source, us[last]!) };
  const normals = across.map(({ limit }) => normalsOf(limit, tips));
  const rowOf = (i: number, part: 'points' | 'dv', shared: boolean): Float64Array =>
    gathered(
      entries,
      across.map(({ limit }) => cut(limit[part], i)),
      closed,
      shared,
    );
  const rows = us.map((u, i): SheetRow => {
    const points = rowOf(i, 'points', true);
    const pole = (i === 0 && tips.first) || (i === last && tips.last);
    if (pole) for (let k = 3; k < points.length; k++) points[k] = points[k - 3]!;
    return {
      points,
      normals: gathered(
        entries,
        normals.map((all) => all[i]!),
        closed,
        false,
      ),
      pole,
      joined: i > 0,
      at: { u, side: i === last ? -1 : 1 },
    };
  });
  return {
    rows,
    form: (end) => {
      const i = end === 'first' ? 0 : last;
      const axes = axesOf(source.stand(us[i]!, end === 'first' ? 1 : -1));
      const back = backOn(axes);
      const vectors = backOn({ ...axes, centre: [0, 0, 0] });
      return {
        closed,
        ...columnsOf(entries),
        points: each(rowOf(i, 'points', true), back),
        rates: each(rowOf(i, 'dv', false), vectors),
      };
    },
  };
}

export function isTip({ stops }: Source, u: number): boolean {
  return stops.some((stop) => stop.u === u && stop.pole);
}

function cut({ columns, points }: Net, row: number): Float64Array {
  return points.subarray(3 * columns * row, 3 * columns * (row + 1));
}

/** From space to (x, y) of the outline there. */
function backOn({ centre, half, depth }: Axes): (p: Vec3) => Vec2 {
  const squared = dot3(half, half);
  return (p) => {
    const from = sub3(p, centre);
    return [dot3(from, half) / squared, from[2] / depth[2]];
  };
}

function each(points: Float64Array, map: (p: Vec3) => Vec2): Vec2[] {
  return Array.from({ length: points.length / 3 }, (_, j) =>
    map([points[3 * j]!, points[3 * j + 1]!, points[3 * j + 2]!]),
  );
}
