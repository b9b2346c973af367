/** Creases across a sheet where none were: rows are doubled, or put in between two others, on the quads that are there. */
import { length3 } from '../math/tuple.ts';
import type { SheetRow } from './sheet.ts';

/** u this close are one */
export const SAME = 1e-8;

/** The rows with an unjoined pair at each of `us` (ascending), sides −1 and 1. */
export function creased(rows: readonly SheetRow[], us: readonly number[]): SheetRow[] {
  return us.reduce<readonly SheetRow[]>(withCrease, rows) as SheetRow[];
}

function withCrease(rows: readonly SheetRow[], u: number): readonly SheetRow[] {
  const on = rows.flatMap((row, i) => (!row.at.rigid && Math.abs(row.at.u - u) <= SAME ? [i] : []));
  // several rows there are a crease already
  if (on.length > 1) return rows;
  if (on.length === 1) return split(rows, on[0]!, rows[on[0]!]!);
  const after = rows.findIndex(
    ({ at, joined }, i) =>
      i > 0 && joined && !at.rigid && at.u > u && !rows[i - 1]!.at.rigid && rows[i - 1]!.at.u < u,
  );
  if (after < 0) return rows;
  const between = mixed(rows[after - 1]!, rows[after]!, u);
  return split([...rows.slice(0, after), between, ...rows.slice(after)], after, between);
}

function split(rows: readonly SheetRow[], i: number, row: SheetRow): SheetRow[] {
  const before: SheetRow = { ...row, at: { ...row.at, side: -1 } };
  const after: SheetRow = { ...row, at: { ...row.at, side: 1 }, joined: false };
  return [...rows.slice(0, i), before, after, ...rows.slice(i + 1)];
}

/** A row on the quads between two others. */
function mixed(a: SheetRow, b: SheetRow, u: number): SheetRow {
  const t = (u - a.at.u) / (b.at.u - a.at.u);
  const mix = (x: Float64Array, y: Float64Array): Float64Array =>
    x.map((value, k) => value * (1 - t) + y[k]! * t);
  const normals = mix(a.normals, b.normals);
  for (let k = 0; k < normals.length; k += 3) {
    const size = length3([normals[k]!, normals[k + 1]!, normals[k + 2]!]);
    // opposite normals cancel: then the nearer row's
    const from = size > 1e-6 ? normals : t < 0.5 ? a.normals : b.normals;
    for (let i = 0; i < 3; i++) normals[k + i] = from[k + i]! / (size > 1e-6 ? size : 1);
  }
  return { ...b, points: mix(a.points, b.points), normals, pole: false, joined: true, at: { u, side: 1 } };
}
