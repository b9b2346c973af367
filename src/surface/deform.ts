/**
 * Orthogonal deformation (thesis 6.1): sections of a sheet are carried from its axis l(u), as a side view shows it, to a
 * stroke d drawn there; how is in bendMap.ts. Rows are moved, not meshes, so bends stack on every surface.
 *
 * d = l leaves the sheet as it is (to 1e-9 of its size). At a corner of d a crease is put in where no row is, and rows in one
 * place stay in one place to the last bit: where the two legs disagree, half way between.
 */
import type { Plane } from '../math/plane.ts';
import type { Curve } from '../stroke/curve.ts';
import type { Axis } from './axis.ts';
import { bendAxis } from './bendAxis.ts';
import { type Bending, moveAt } from './bendMap.ts';
import { type BendPath, bendPath } from './bendPath.ts';
import { bentRow } from './bentRow.ts';
import { creased, SAME } from './creased.ts';
import { kept } from './keptSpine.ts';
import { mitres } from './mitres.ts';
import { moveStation } from './movedStation.ts';
import type { RowAt, Sheet, SheetRow, Spine } from './sheet.ts';
import { sideView } from './sideView.ts';

export interface BendInput {
  /** d, mm on `plane` */
  readonly curve: Curve;
  /** the side view's, facing the person who looks, in the coordinates of the sheet (`within` of sideView.ts) */
  readonly plane: Plane;
  /** walk d millimetre by millimetre; else d is stretched over the whole axis */
  readonly keepsLength: boolean;
}

/** Whether a bend drawn in this side view does anything: not when the axis is seen end-on. */
export function isBendable(spine: Spine, plane: Plane): boolean {
  return bendAxis(spine, plane) !== null;
}

/** The sheet bent; as it is when the axis is seen end-on or d is a dot. Bends of a list are applied one after the other. */
export function deform(sheet: Sheet, { curve, plane, keepsLength }: BendInput): Sheet {
  const axis = bendAxis(sheet.spine, plane, curve.closed);
  const path = axis && bendPath(axis, curve, keepsLength);
  if (!axis || !path) return sheet;
  const corners = cornersAlong(axis, path, sheet.rows, sheet.spine.closed);
  const rows = creased(
    sheet.rows,
    corners.filter((u) => u > 0 && u < 1),
  );
  const view = sideView(plane);
  const smooth = { view, axis, path, breaks: merged(axis.breaks, corners) };
  const bending: Bending = { ...smooth, slide: mitres(smooth, corners, rows, sheet.spine.closed) };
  const spine = kept(sheet.spine);
  const moved = rows.map((row) => bent(row, spine, bending));
  return { ...sheet, rows: together(moved, rows), spine: bentSpine(spine, bending) };
}

function bent(row: SheetRow, spine: Spine, bending: Bending): SheetRow {
  const { u, rigid } = row.at;
  const inward = insideOf(spine, row.at);
  return bentRow(row, moveAt(bending, u, inward), bending.view, rigid ? null : spine.at(u, inward));
}

/** At the ends of the spine there is but one side. */
function insideOf({ stops }: Spine, { u, side }: RowAt): -1 | 1 {
  if (u <= stops[0]!) return 1;
  return u >= stops[stops.length - 1]! ? -1 : side;
}

function bentSpine(spine: Spine, bending: Bending): Spine {
  const first = spine.stops[0]!;
  const last = spine.stops[spine.stops.length - 1]!;
  const at: Spine['at'] = (u, side) => {
    const inward = u <= first ? 1 : u >= last ? -1 : side;
    return moveStation(moveAt(bending, u, inward), bending.view, spine.at(u, inward));
  };
  return kept({ closed: spine.closed, stops: bending.breaks, at });
}

/** Rows whose points were the same stay so: half way between the first and the last of them. */
function together(bent: readonly SheetRow[], before: readonly SheetRow[]): SheetRow[] {
  const runs: number[][] = [];
  before.forEach((row, i) => {
    if (i > 0 && inOnePlace(before[i - 1]!, row)) runs[runs.length - 1]!.push(i);
    else runs.push([i]);
  });
  // a closed sheet ends where it begins
  if (runs.length > 1 && inOnePlace(before[0]!, before[before.length - 1]!)) runs[0]!.unshift(...runs.pop()!);
  const out = [...bent];
  for (const run of runs) {
    if (run.length === 1) continue;
    const [a, b] = [bent[run[0]!]!.points, bent[run[run.length - 1]!]!.points];
    const points = a.map((x, k) => (x === b[k] ? x : 0.5 * (x + b[k]!)));
    for (const i of run) out[i] = { ...bent[i]!, points };
  }
  return out;
}

function inOnePlace({ points: a }: SheetRow, { points: b }: SheetRow): boolean {
  if (a === b) return true;
  if (a.length !== b.length) return false;
  for (let k = 0; k < a.length; k++) if (a[k] !== b[k]) return false;
  return true;
}

/** Ascending u at which the way meets a corner of d, more than one for each where it turns back. */
function cornersAlong(axis: Axis, path: BendPath, rows: readonly SheetRow[], isClosed: boolean): number[] {
  if (path.corners.length === 0) return [];
  const walked = (u: number): number => axis.at(u, 1).walked();
  const ends = [0, 1].filter((u) => path.corners.some((c) => Math.abs(walked(u) - c) <= SAME * axis.length));
  const found = path.corners.flatMap((corner) =>
    probesBetween(axis.breaks).flatMap((to, i, all) => {
      const from = all[i - 1] ?? to;
      return crossing((u) => walked(u) - corner, from, to);
    }),
  );
  const known = [...axis.breaks, ...rows.map(({ at }) => at.u)];
  const snapped = [...ends, ...found].map((u) => known.find((other) => Math.abs(other - u) <= SAME) ?? u);
  // on a closed spine the end is the start
  const seam = isClosed && snapped.some((u) => u <= SAME || u >= 1 - SAME) ? [0, 1] : [];
  return [...new Set([...snapped.filter((u) => u > SAME && u < 1 - SAME), ...seam])].sort((a, b) => a - b);
}

const PROBES = 64;

function probesBetween(breaks: readonly number[]): number[] {
  const inner = breaks.slice(1).flatMap((to, i) => {
    const from = breaks[i]!;
    const count = Math.max(Math.ceil(PROBES * (to - from)), 4);
    return Array.from({ length: count }, (_, k) => (k === 0 ? from : from + ((to - from) * k) / count));
  });
  return [...inner, breaks[breaks.length - 1]!];
}

/** The zero of f between two u of unlike sign, by halving. */
function crossing(f: (u: number) => number, from: number, to: number): number[] {
  const rising = f(to) > 0;
  if (from === to || f(from) > 0 === rising) return [];
  let [low, high] = [from, to];
  for (let i = 0; i < 52; i++) {
    const middle = 0.5 * (low + high);
    if (f(middle) > 0 === rising) high = middle;
    else low = middle;
  }
  return [high];
}

function merged(breaks: readonly number[], corners: readonly number[]): number[] {
  const rest = corners.filter((u) => breaks.every((other) => Math.abs(other - u) > SAME));
  return [...breaks, ...rest].sort((a, b) => a - b);
}
