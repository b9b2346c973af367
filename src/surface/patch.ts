/**
 * B-spline patches (thesis 3.4, 5.5): two or more sections, each at its own u, blended by one tensor-product cubic spline
 * whose rows follow the construction curves (fig. 5.15).
 *
 * Departures: the patch passes through its rows instead of being pulled towards them (through.ts), so that it keeps to the strokes
 * that were drawn; corners of strokes and of sections stay creases, where the thesis' patch smooths them away: the patch
 * ends there and another begins in the same points, which is what a control point repeated three times does in one.
 */

import type { Between } from './between.ts';
import { columnsOf, type Entry, entriesOf, gathered } from './entries.ts';
import { facing } from './facing.ts';
import { normalsOf } from './normals.ts';
import type { Standing } from './placing.ts';
import type { Sheet, SheetRow, Spine } from './sheet.ts';
import { type PlacedOutline, type Weave, weaveOf } from './weave.ts';
import { splined, type Times, unsplined, type Woven } from './woven.ts';

export interface PatchOptions {
  readonly between: Between;
  /** control spans along the construction curves, about; null: as many as keep within 0.5 % of the chord of them, 16 to 256 */
  readonly rows: number | null;
  /** control spans across, about */
  readonly columns: number;
  /** how often each of them is halved */
  readonly subdivisions: Times;
}

/** normals nearer to each other are one */
const ONE_NORMAL = 1e-6;

/** Rows and columns without caps. */
export function patchSheet(
  standing: Standing,
  spine: Spine,
  sections: readonly PlacedOutline[],
  options: PatchOptions,
): Sheet {
  const weave = weaveOf(standing, sections, options.between, options);
  const woven =
    options.between === 'plain'
      ? unsplined(weave, options.subdivisions)
      : splined(weave, options.subdivisions);
  const entries = entriesOf(woven[0]!, weave.alike.closed);
  const rows = faced(lobesOf(weave, woven, entries), weave.alike.closed).flat();
  if (standing.closed) rows.push({ ...rows.pop()!, points: rows[0]!.points });
  return { rows, columns: columnsOf(entries), spine };
}

/** Rows between tips: each lobe has an inside of its own. */
function lobesOf(
  { standing, alike }: Weave,
  woven: readonly (readonly Woven[])[],
  entries: readonly Entry[],
): SheetRow[][] {
  const lobes: SheetRow[][] = [[]];
  for (const across of woven) {
    const us = across[0]!.us;
    const [first, last] = [us[0]!, us[us.length - 1]!].map((u) => isTip(standing, u)) as [boolean, boolean];
    const before = lobes[lobes.length - 1]!.at(-1);
    if (first && before) lobes.push([]);
    const [start, ...others] = rowsOf(across, entries, alike.closed, { first, last });
    const isOne = before && isInside(standing, us[0]!) && agree(before.normals, start!.normals);
    // rows in one place share their coordinates to the last bit
    if (!isOne) lobes[lobes.length - 1]!.push(before ? { ...start!, points: before.points } : start!);
    lobes[lobes.length - 1]!.push(...others);
  }
  return lobes;
}

/** Between stops. */
function isInside({ stops }: Standing, u: number): boolean {
  return stops.every((stop) => stop.u !== u);
}

function agree(a: Float64Array, b: Float64Array): boolean {
  return a.every((x, k) => Math.abs(x - b[k]!) < ONE_NORMAL);
}

function isTip({ stops }: Standing, u: number): boolean {
  return stops.some((stop) => stop.u === u && stop.pole);
}

function rowsOf(
  across: readonly Woven[],
  entries: readonly Entry[],
  closed: boolean,
  tips: { readonly first: boolean; readonly last: boolean },
): SheetRow[] {
  const us = across[0]!.us;
  const last = us.length - 1;
  const normals = across.map(({ limit }) => normalsOf(limit, tips));
  return us.map((u, i) => {
    const cut = across.map(({ limit: { points } }) =>
      points.points.subarray(3 * points.columns * i, 3 * points.columns * (i + 1)),
    );
    const points = gathered(entries, cut, closed, true);
    const pole = (i === 0 && tips.first) || (i === last && tips.last);
    if (pole) for (let k = 3; k < points.length; k++) points[k] = points[k - 3]!;
    return {
      points,
      normals: gathered(
        entries,
        normals.map((rows) => rows[i]!),
        closed,
        false,
      ),
      pole,
      joined: i > 0,
      at: { u, side: i === last ? -1 : 1 },
    };
  });
}

/** Lobes with their outside out; sheets face the person who drew. */
function faced(lobes: readonly SheetRow[][], closed: boolean): SheetRow[][] {
  return lobes.map((rows) => {
    if (facing(rows, closed) !== -1) return rows;
    return rows.map((row) => ({ ...row, normals: row.normals.map((x) => -x), flipped: true }));
  });
}
