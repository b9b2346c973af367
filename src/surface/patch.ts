/**
 * B-spline patches (thesis 3.4, 5.5): two or more sections, each at its own u, blended by one tensor-product cubic spline
 * whose rows follow the construction curves (fig. 5.15).
 *
 * Departures: the patch passes through its rows instead of being pulled towards them (through.ts), so that it keeps to the strokes
 * that were drawn; corners of strokes and of sections stay creases, where the thesis' patch smooths them away: the patch
 * ends there and another begins in the same points, which is what a control point repeated three times does in one.
 */
import type { Row } from '../mesh/grid.ts';
import type { Between } from './between.ts';
import { outsideIn, rigid } from './caps.ts';
import type { OutlineColumns } from './columns.ts';
import {
  closedUp,
  crossSectionSheet,
  domeRows,
  flatRows,
  flipped,
  type SectionSource,
} from './crossSection.ts';
import { columnsOf, entriesOf } from './entries.ts';
import { facing } from './facing.ts';
import { isBackless, restricted } from './outline.ts';
import { isTip, type PieceRows, pieceRows } from './patchRows.ts';
import { quadCount } from './rows.ts';
import type { Sheet, SheetRow } from './sheet.ts';
import { type Source, sourceOf } from './source.ts';
import { normalsAt, placed } from './stand.ts';
import { type PlacedOutline, type Weave, weaveOf } from './weave.ts';
import { splined, type Times, unsplined } from './woven.ts';

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

/**
 * The patch with its ends closed as `input` says. Null when strokes lie on each other or have no length. Throws RangeError as
 * sourceOf does, for numbers that are none, and when open and closed sections are mixed.
 */
export function patchSheet(
  input: SectionSource,
  sections: readonly PlacedOutline[],
  options: PatchOptions,
): Sheet | null {
  const weave = patchWeave(input, sections, options);
  const { source } = weave;
  const { closed } = weave.alike;
  const around = options.columns << options.subdivisions.v;
  // a dot is a ball, if anything
  if (!(source.length > 0)) return crossSectionSheet(input, sections[0]!.outline, { u: 1, v: around });
  const woven =
    options.between === 'plain'
      ? unsplined(weave, options.subdivisions)
      : splined(weave, options.subdivisions);
  const entries = entriesOf(woven[0]!, closed);
  const pieces = woven.map((across) => pieceRows(source, across, entries, closed));
  const lobes = capped(joinedUp(source, pieces, around), pieces, source, input.caps, around);
  const senses = lobes.map((rows) => facing(rows, closed));
  if (senses.every((sense) => sense === 0)) return null;
  const rows = lobes.flatMap((lobe, i) => (senses[i]! < 0 ? lobe.map(flipped) : lobe));
  return { rows: source.closed ? closedUp(rows) : rows, columns: columnsOf(entries), spine: source.spine };
}

/** What the patch is cut from. Throws as patchSheet does. */
export function patchWeave(
  input: SectionSource,
  sections: readonly PlacedOutline[],
  { between, rows, columns }: PatchOptions,
): Weave {
  const spans = {
    rows: rows === null ? null : quadCount('rows', rows, 1),
    columns: quadCount('columns', columns, 1),
  };
  return weaveOf(sourceOf(input), substantial(sections), between, spans);
}

/** Backs that lie on their fronts, on all sections, leave the fronts alone. */
function substantial(sections: readonly PlacedOutline[]): readonly PlacedOutline[] {
  const isEmpty = sections.every(({ outline }) => isBackless(outline));
  return isEmpty ? sections.map(({ u, outline }) => ({ u, outline: restricted(outline, 0, 0.5) })) : sections;
}

/** Rows from tip to tip. */
function joinedUp(source: Source, pieces: readonly PieceRows[], around: number): SheetRow[][] {
  const lobes: SheetRow[][] = [[]];
  let turned = false;
  for (const { rows, form } of pieces) {
    const [start, ...others] = rows as [SheetRow, ...SheetRow[]];
    let lobe = lobes[lobes.length - 1]!;
    const before = lobe[lobe.length - 1];
    if (before && isTip(source, start.at.u)) {
      lobe = [];
      lobes.push(lobe);
    }
    const stop = source.stops.findIndex(({ u }) => u === start.at.u);
    const isOne = before && stop < 0 && agree(before.normals, start.normals);
    if (turned) lobe.push({ ...start, joined: true });
    // rows in one place share their coordinates to the last bit
    else if (!isOne) lobe.push(before ? { ...start, points: before.points } : start);
    const joint = jointRows(source, others[others.length - 1]!.at.u, around, () => form('last'));
    turned = joint.length > 0;
    lobe.push(...others, ...joint);
  }
  const seam = lobes[0]![0];
  if (turned && source.closed && seam) lobes[lobes.length - 1]!.push({ ...seam, joined: true });
  return lobes;
}

function agree(a: Float64Array, b: Float64Array): boolean {
  return a.every((x, k) => Math.abs(x - b[k]!) < ONE_NORMAL);
}

/** Where one stroke turns too sharply for a mitre the section turns about the corner. */
function jointRows(source: Source, u: number, around: number, form: () => OutlineColumns): SheetRow[] {
  const stop = source.stops.findIndex((other) => other.u === u);
  const joint = stop < 0 ? [] : source.joint(stop, around);
  if (joint.length === 0) return [];
  const { points, rates } = form();
  return joint.map(({ stand, at, joined }) => ({
    points: placed(stand, points),
    normals: normalsAt(stand, points, rates),
    joined,
    at,
  }));
}

/** Open ends of closed outlines shut: flat, on one stroke by domes. */
function capped(
  lobes: readonly SheetRow[][],
  pieces: readonly PieceRows[],
  source: Source,
  caps: SectionSource['caps'],
  around: number,
): SheetRow[][] {
  const isRound = caps === 'round' && !source.paired;
  const cap = (rim: SheetRow, form: OutlineColumns, out: 1 | -1): Row[] => {
    if (!form.closed || source.closed || caps === 'none' || rim.pole) return [];
    const stand = source.stand(rim.at.u, rim.at.side);
    return isRound ? domeRows(stand, form, out, around) : flatRows(stand, form, rim, out);
  };
  return lobes.map((rows, i) => {
    const whole = [...rows];
    const end = rows[rows.length - 1]!;
    if (i === lobes.length - 1)
      whole.push(...rigid(cap(end, pieces[pieces.length - 1]!.form('last'), 1), end.at));
    if (i > 0) return whole;
    const start = rows[0]!;
    const head = outsideIn(cap(start, pieces[0]!.form('first'), -1));
    return [...rigid(head.cap, start.at), { ...start, joined: head.joinsSurface }, ...whole.slice(1)];
  });
}
