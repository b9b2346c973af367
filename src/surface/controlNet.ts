/** What a patch is controlled by, to be shown (thesis figs 3.7, 5.16) and counted (its subdivision editor, A.4). */
import type { Vec3 } from '../math/vec.ts';
import type { SectionSource } from './crossSection.ts';
import { columnsOf, entriesOf, gathered } from './entries.ts';
import type { KnotPiece } from './knots.ts';
import type { Net } from './net.ts';
import { type PatchOptions, patchWeave } from './patch.ts';
import type { Sheet, SheetRow } from './sheet.ts';
import type { PlacedOutline } from './weave.ts';
import { controlNets } from './woven.ts';

/** Control points as the rows of a sheet, so that bends take them along; pieces do not join. Normals mean nothing. */
export function controlNet(
  input: SectionSource,
  sections: readonly PlacedOutline[],
  options: PatchOptions,
): Sheet {
  const weave = patchWeave(input, sections, options);
  const { source, alike, along, across } = weave;
  const round = alike.seamless ? 1 : 0;
  const vs = across.map((piece) => places(piece, alike.seamless));
  // its first control again after the last
  const entries = entriesOf(
    vs.map((all) => ({ vs: [...all, ...all.slice(0, round).map((v) => v + 1)] })),
    false,
  ).map((entry) => ({ ...entry, column: entry.column % (vs[entry.piece]!.length || 1) }));
  const rows = controlNets(weave).flatMap((nets, i) =>
    places(along[i]!, false).map((u, k): SheetRow => {
      const points = gathered(
        entries,
        nets.map((net) => rowOf(net, k)),
        false,
        false,
      );
      const normals = points.map((_, n) => (n % 3 === 2 ? 1 : 0));
      return { points, normals, joined: k > 0, at: { u, side: u === along[i]!.to ? -1 : 1 } };
    }),
  );
  return { rows, columns: columnsOf(entries), spine: source.spine };
}

/** The lines of a net along its rows and its columns, in the coordinates of its sheet. */
export function netLines({ rows, columns }: Pick<Sheet, 'rows' | 'columns'>): Vec3[][] {
  const at = (row: SheetRow, j: number): Vec3 => [
    row.points[3 * j]!,
    row.points[3 * j + 1]!,
    row.points[3 * j + 2]!,
  ];
  const across = rows.flatMap((row) => split(columns.vs, columns.joined, (_, j) => at(row, j)));
  const joined = rows.map((row) => row.joined);
  const along = columns.vs.flatMap((_, j) => split(rows, joined, (row) => at(row, j)));
  return [...across, ...along];
}

export interface PatchCounts {
  /** control spans along and across */
  readonly rows: number;
  readonly columns: number;
  readonly controls: number;
  /** of the patch without what shuts its ends */
  readonly triangles: number;
}

/** Throws as patchSheet does. */
export function patchCounts(
  input: SectionSource,
  sections: readonly PlacedOutline[],
  options: PatchOptions,
): PatchCounts {
  const { source, alike, along, across } = patchWeave(input, sections, options);
  const sum = (pieces: readonly KnotPiece[]): number => pieces.reduce((all, { spans }) => all + spans, 0);
  const [rows, columns] = [sum(along), sum(across)];
  const { u, v } = options.subdivisions;
  // quads at a tip are triangles, on both of its sides
  const tips = source.stops.reduce(
    (all, { u: at, pole }) => all + (pole ? (at > 0 && at < 1 ? 2 : 1) : 0),
    0,
  );
  const clamped = alike.seamless ? 0 : 3 * across.length;
  return {
    rows,
    columns,
    controls: (rows + 3 * along.length) * (columns + clamped),
    triangles: (columns << v) * (2 * (rows << u) - tips),
  };
}

/** Where on the parameter each control point has most to say: the mean of its knots (Greville). */
function places({ from, to, spans, map }: KnotPiece, seamless: boolean): number[] {
  if (seamless) return Array.from({ length: spans }, (_, k) => map.at(k));
  const ts = Array.from({ length: spans - 1 }, (_, k) => k + 1);
  // beside the ends three knots of four are in one place
  return [from, map.at(1 / 3), ...ts.map((t) => map.at(t)), map.at(spans - 1 / 3), to];
}

function rowOf({ columns, points }: Net, row: number): Float64Array {
  return points.subarray(3 * columns * row, 3 * columns * (row + 1));
}

/** Runs of neighbours that are joined. */
function split<T>(
  items: readonly T[],
  joined: readonly boolean[],
  point: (item: T, i: number) => Vec3,
): Vec3[][] {
  const lines: Vec3[][] = [];
  items.forEach((item, i) => {
    if (i === 0 || !joined[i]) lines.push([]);
    lines[lines.length - 1]!.push(point(item, i));
  });
  return lines;
}
