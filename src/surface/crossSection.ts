/**
 * Cross-sectional blending (thesis 5.4): one outline carried along all u, turned and scaled with the chord (stand.ts). A half circle
 * as front and back is the rotational surface. On a single stroke, which the thesis leaves to tubes, it is a tube with that section.
 *
 * Each lobe between tips is turned outward as a whole (facing.ts), however strokes and sections were drawn; fronts without a back face
 * the person. Corners of strokes are creases across, corners of the outline creases along.
 */
import { atan2, cos, PI, sin } from '../math/trig.ts';
import { cross2 } from '../math/tuple.ts';
import type { Vec2, Vec3 } from '../math/vec.ts';
import type { Row } from '../mesh/grid.ts';
import { outsideIn, rigid } from './caps.ts';
import { columnsOf, type OutlineColumns } from './columns.ts';
import { facing } from './facing.ts';
import { lidOf, lidRows } from './lid.ts';
import { isBackless, type Outline, restricted } from './outline.ts';
import { quadCount } from './rows.ts';
import type { Sheet, SheetRow } from './sheet.ts';
import { type SourceInput, type StandRow, sourceOf, standLobes } from './source.ts';
import { normalsAt, place, placed, type Stand } from './stand.ts';

export interface SectionSource extends SourceInput {
  /** how open ends of closed outlines are shut; between two strokes 'round' is flat too */
  readonly caps: 'round' | 'flat' | 'none';
}

export interface SectionOptions {
  /** quads along the strokes (about), at least 1 */
  readonly u: number;
  /** quads across (about), at least 1, of closed outlines 3 */
  readonly v: number;
}

/** Null when it has no extent: strokes on each other or without length. Throws RangeError as sourceOf does, and for u, v that are no numbers. */
export function crossSectionSheet(
  input: SectionSource,
  outline: Outline,
  options: SectionOptions,
): Sheet | null {
  const u = quadCount('u', options.u, 1);
  const columns = columnsOf(outline, quadCount('v', options.v, outline.closed ? 3 : 1));
  if (isBackless(outline)) {
    // a back on its front leaves the front alone
    return crossSectionSheet(input, restricted(outline, 0, 0.5), options);
  }
  const source = sourceOf(input);
  const isBall = !source.paired && !source.closed && outline.closed && input.caps === 'round';
  if (!(source.length > 0) && !isBall) return null;
  const lobes = standLobes(source, u, options.v).map((stands) => ({
    stands,
    rows: placedRows(stands, columns),
  }));
  const ends = outline.closed && !source.closed && input.caps !== 'none';
  const shape = source.paired ? 'flat' : input.caps;
  const cap = (row: StandRow, rim: SheetRow, out: 1 | -1): Row[] => {
    if (!ends || rim.pole) return [];
    return shape === 'round'
      ? domeRows(row.stand, columns, out, options.v)
      : flatRows(row.stand, columns, rim, out);
  };
  const capped = lobes.map(({ stands, rows }, i) => {
    const last = rows.length - 1;
    const whole = [...rows];
    if (i === lobes.length - 1) whole.push(...rigid(cap(stands[last]!, rows[last]!, 1), rows[last]!.at));
    if (i > 0) return whole;
    const head = outsideIn(cap(stands[0]!, rows[0]!, -1));
    return [...rigid(head.cap, rows[0]!.at), { ...whole[0]!, joined: head.joinsSurface }, ...whole.slice(1)];
  });
  const senses = capped.map((rows) => facing(rows, outline.closed));
  if (senses.every((sense) => sense === 0)) return null;
  const rows = capped.flatMap((lobe, i) => (senses[i]! < 0 ? lobe.map(flipped) : lobe));
  return { rows: source.closed ? closedUp(rows) : rows, columns, spine: source.spine };
}

function placedRows(stands: readonly StandRow[], { points, rates }: OutlineColumns): SheetRow[] {
  const rows: SheetRow[] = [];
  for (const { stand, at, joined } of stands) {
    const before = rows[rows.length - 1];
    rows.push({
      // rows in one place get the same points to the last bit
      points: before && !joined ? before.points : placed(stand, points),
      normals: normalsAt(stand, points, rates),
      pole: stand.radius === 0,
      joined,
      at,
    });
  }
  return rows;
}

/** A flat lid over an end, from its rim outward. */
export function flatRows(stand: Stand, { points }: OutlineColumns, rim: Row, out: 1 | -1): Row[] {
  return lidRows(lidOf(points), rim, (p) => place(stand, p), endNormal(stand, points, out));
}

/** The outside of an end as unflipped quads see it: against the way along where front and back go round clockwise, as they should. */
function endNormal({ axis: [x, y] }: Stand, points: readonly Vec2[], out: 1 | -1): Vec3 {
  const side = out * (turns(points) < 0 ? -1 : 1);
  return [side * y, -side * x, 0];
}

/** Twice the area of the outline, positive when counter-clockwise. */
function turns(points: readonly Vec2[]): number {
  return points.reduce((sum, p, j) => sum + cross2(points[j - 1] ?? p, p), 0);
}

/** The section shrunk along a quarter of a circle that goes on from the end as domes of tubes do (caps.ts). */
export function domeRows(
  stand: Stand,
  { points, rates }: OutlineColumns,
  out: 1 | -1,
  around: number,
): Row[] {
  const { centre, axis, radius, dHalf } = stand;
  const quads = Math.max(Math.ceil(around / 4), 2);
  const flare = out * (dHalf[0] * axis[0] + dHalf[1] * axis[1]);
  const from = atan2(-flare, 1);
  const size = Math.sqrt(1 + flare * flare);
  const outward: Vec2 = [out * axis[1], -out * axis[0]];
  const tip = endNormal(stand, points, out);
  return Array.from({ length: quads }, (_, i) => {
    const pole = i === quads - 1;
    const angle = from + ((PI / 2 - from) * (i + 1)) / quads;
    const [wide, far] = [pole ? 0 : size * cos(angle), flare + size * sin(angle)];
    const middle: Vec2 = [centre[0] + far * radius * outward[0], centre[1] + far * radius * outward[1]];
    const half: Vec2 = [wide * radius * axis[0], wide * radius * axis[1]];
    const shrunk: Stand = {
      left: [middle[0] + half[0], middle[1] + half[1]],
      right: [middle[0] - half[0], middle[1] - half[1]],
      centre: middle,
      axis,
      radius: wide * radius,
      dCentre: [out * cos(angle) * outward[0], out * cos(angle) * outward[1]],
      dHalf: [-out * sin(angle) * axis[0], -out * sin(angle) * axis[1]],
    };
    return {
      points: placed(shrunk, points),
      normals: pole ? repeated(tip, points.length) : normalsAt(shrunk, points, rates),
      pole,
      joined: true,
    };
  });
}

export function flipped(row: SheetRow): SheetRow {
  const normals = new Float64Array(row.normals.length);
  for (let k = 0; k < normals.length; k++) normals[k] = -row.normals[k]!;
  return { ...row, normals, flipped: true };
}

/** A closed pair, or stroke, ends in the points of its first row. */
export function closedUp(rows: readonly SheetRow[]): SheetRow[] {
  return [...rows.slice(0, -1), { ...rows[rows.length - 1]!, points: rows[0]!.points }];
}

function repeated(vector: Vec3, count: number): Float64Array {
  return Float64Array.from({ length: 3 * count }, (_, k) => vector[k % 3]!);
}
