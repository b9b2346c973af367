/** What can be shown of a surface that is selected: one of its sections lit, or its control mesh with its strokes (thesis figs 3.7, 5.16). */
import { controlsOfStroke } from '../document/curves.ts';
import type { SurfacePart } from '../document/document.ts';
import { controlLinesOf, sheetOf } from '../document/sheets.ts';
import { place3 } from '../math/placement.ts';
import { cross3 } from '../math/tuple.ts';
import type { Vec2, Vec3 } from '../math/vec.ts';
import { toWorld } from '../stroke/plane.ts';
import type { Stroke } from '../stroke/stroke.ts';
import type { Sheet, SheetRow } from '../surface/sheet.ts';
import type { Mark } from './marks.ts';

/** The section at u, on the form as it is. */
export function sectionMarks(part: SurfacePart, u: number): readonly Mark[] {
  const sheet = sheetOf(part.kind, part, part.brush);
  const points = sheet && loopAt(sheet, u)?.map((p) => inWorld(part, p));
  if (!points || points.length < 2) return [];
  return [{ kind: 'line', style: 'lit', points }];
}

/** Points across the surface at u, between the rows beside it. */
function loopAt({ rows, spine }: Sheet, u: number): readonly Vec3[] | null {
  const own = rows.filter(({ at }) => !at.rigid);
  const next = own.findIndex(({ at }) => at.u >= u);
  const [before, after] = [own[Math.max(0, next - 1)], own[next < 0 ? own.length - 1 : next]];
  if (!before || !after || spine.stops.length === 0) return null;
  const span = after.at.u - before.at.u;
  const t = span > 0 ? (u - before.at.u) / span : 1;
  const at = ({ points }: SheetRow, k: number): number => points[Math.min(k, points.length - 3 + (k % 3))]!;
  const count = Math.max(before.points.length, after.points.length) / 3;
  return Array.from({ length: count }, (_, j): Vec3 => {
    const mix = (k: number) => (1 - t) * at(before, 3 * j + k) + t * at(after, 3 * j + k);
    return [mix(0), mix(1), mix(2)];
  });
}

/** Its control mesh, where it has one, its strokes as they are, and their control points. */
export function controlMarks(part: SurfacePart): readonly Mark[] {
  const lines = controlLinesOf(part.kind, part, part.brush);
  return [
    ...lines.map(
      (points): Mark => ({ kind: 'line', style: 'control', points: points.map((p) => inWorld(part, p)) }),
    ),
    ...part.strokes.flatMap((stroke) => strokeMarks(part, stroke)),
  ];
}

/** A stroke as it was filtered: the polygon of its control points, and those. */
function strokeMarks({ placement, brush }: SurfacePart, stroke: Stroke): readonly Mark[] {
  const onPlane = (p: Vec2): Vec3 => place3(placement, toWorld(stroke.plane, p));
  const pieces = controlsOfStroke(stroke, brush).map((piece) => piece.map(onPlane));
  const drawn = stroke.samples.map(({ x, y }) => onPlane([x, y]));
  return [
    { kind: 'line', style: 'full', points: drawn, ...(stroke.closed && { closed: true as const }) },
    ...pieces.map((points): Mark => ({ kind: 'line', style: 'flat', points })),
    ...pieces.flat().map((at): Mark => ({ kind: 'knot', at })),
  ];
}

function inWorld({ strokes, placement }: SurfacePart, [x, y, z]: Vec3): Vec3 {
  const { plane } = strokes[0]!;
  const [ax, ay, az] = toWorld(plane, [x, y]);
  const [nx, ny, nz] = cross3(plane.x, plane.y);
  return place3(placement, [ax + z * nx, ay + z * ny, az + z * nz]);
}
