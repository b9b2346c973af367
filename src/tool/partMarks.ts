/** What can be shown of a surface that is selected: one of its sections lit, or its control mesh with its strokes (thesis figs 3.7, 5.16). */
import { controlsOfStroke } from '../document/curves.ts';
import type { SurfacePart } from '../document/document.ts';
import { controlLinesOf, sheetOf } from '../document/sheets.ts';
import { place3 } from '../math/placement.ts';
import { cross3 } from '../math/tuple.ts';
import type { Vec2, Vec3 } from '../math/vec.ts';
import { toWorld } from '../stroke/plane.ts';
import type { Stroke } from '../stroke/stroke.ts';
import { sectionAt } from '../surface/sectionAt.ts';
import type { Mark } from './marks.ts';

/** The section at u, on the form as it is. */
export function sectionMarks(part: SurfacePart, u: number): readonly Mark[] {
  const sheet = sheetOf(part.kind, part, part.brush);
  const points = sheet && sectionAt(sheet, u)?.map((p) => inWorld(part, p));
  if (!points || points.length < 2) return [];
  return [{ kind: 'line', style: 'lit', points }];
}

/** Its control mesh, where it has one, its strokes as they are, and their control points. */
export function controlMarks(part: SurfacePart): readonly Mark[] {
  const lines = controlLinesOf(part.kind, part, part.brush);
  const isBent = part.bends.some(({ isOff }) => !isOff);
  return [
    ...lines.map(
      (points): Mark => ({ kind: 'line', style: 'control', points: points.map((p) => inWorld(part, p)) }),
    ),
    ...part.strokes.flatMap((stroke) => (isBent ? faintMarks : strokeMarks)(part, stroke)),
  ];
}

/** Of a bent form the strokes lie where it was before: they step back, and their control points are left out. */
const faintMarks = ({ placement }: SurfacePart, { samples, plane, closed }: Stroke): readonly Mark[] => {
  const points = samples.map(({ x, y }) => place3(placement, toWorld(plane, [x, y])));
  return [{ kind: 'line', style: 'control', points, ...(closed && { closed: true as const }) }];
};

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
