/**
 * The section of a sheet at one u as tools see it, bends included: its points, and the plane on which it is drawn over
 * (thesis 6.2), x along q_l → q_r and y out of the drawing plane. Between rows points are mixed, as on the mesh's quads.
 */
import type { Plane } from '../math/plane.ts';
import { add3, cross3, dot3, length3, scale3, sub3 } from '../math/tuple.ts';
import type { Vec3 } from '../math/vec.ts';
import type { Sheet, SheetRow } from './sheet.ts';

/** In the space in which the drawing plane lies, mm. */
export interface SectionView {
  readonly u: number;
  /** along v, closed ones end with their first point */
  readonly points: readonly Vec3[];
  /** the section's plane: origin in the chord's middle, x towards q_r, y out of the drawing plane as it was bent */
  readonly plane: Plane;
  /** half the chord, mm */
  readonly half: number;
}

/**
 * `flat`: the same sheet before its bends, which says what is out of the drawing plane; `drawing`: that plane. Null where the
 * section is a point, or the sheet has no rows.
 */
export function sectionAt(sheet: Sheet, flat: Sheet, u: number, drawing: Plane): SectionView | null {
  const points = pointsAt(sheet, u);
  const before = pointsAt(flat, u);
  if (!points || !before) return null;
  const chord = chordOf(sheet, points);
  const half = length3(chord.arm);
  if (!(half > 0)) return null;
  const x = scale3(chord.arm, 1 / half);
  const normal = across(sheet.spine.at(u, sideAt(u)).normal, x);
  if (!normal) return null;
  const out = cross3(x, normal);
  const sense = cross3(chordOf(flat, before).arm, flat.spine.at(u, sideAt(u)).normal)[2] < 0 ? -1 : 1;
  const place = placing(drawing);
  return {
    u,
    points: points.map((p) => add3(drawing.origin, place(p))),
    plane: {
      origin: add3(drawing.origin, place(chord.middle)),
      x: place(x),
      y: place(scale3(out, sense)),
    },
    half,
  };
}

const sideAt = (u: number): -1 | 1 => (u >= 1 ? -1 : 1);

/** Columns of the section, between the two rows around u. */
function pointsAt({ rows }: Sheet, u: number): Vec3[] | null {
  const body = rows.filter(({ at }) => !at.rigid);
  const first = body[0];
  if (!first) return null;
  const next = body.findIndex(({ at }) => at.u >= u);
  const b: SheetRow = next < 0 ? body[body.length - 1]! : body[next]!;
  const a: SheetRow = next > 0 ? body[next - 1]! : b;
  const span = b.at.u - a.at.u;
  const t = span > 0 ? Math.min(Math.max((u - a.at.u) / span, 0), 1) : 1;
  return Array.from({ length: b.points.length / 3 }, (_, j) => {
    const mix = (k: number): number => a.points[3 * j + k]! * (1 - t) + b.points[3 * j + k]! * t;
    return [mix(0), mix(1), mix(2)];
  });
}

/** From the middle to q_r: the last column, or of closed sheets the one half way round. */
function chordOf({ columns }: Sheet, points: readonly Vec3[]): { readonly middle: Vec3; readonly arm: Vec3 } {
  const left = points[0]!;
  const right = isRound(points) ? mixedAt(columns.vs, points, 0.5) : points[points.length - 1]!;
  return { middle: scale3(add3(left, right), 0.5), arm: scale3(sub3(right, left), 0.5) };
}

function isRound(points: readonly Vec3[]): boolean {
  const extent = points.reduce((most, p) => Math.max(most, length3(sub3(p, points[0]!))), 0);
  return length3(sub3(points[points.length - 1]!, points[0]!)) <= 1e-9 * extent;
}

function mixedAt(vs: readonly number[], points: readonly Vec3[], v: number): Vec3 {
  const after = vs.findIndex((x) => x >= v);
  const before = Math.max(after - 1, 0);
  const t = (v - vs[before]!) / (vs[after]! - vs[before]! || 1);
  return add3(scale3(points[before]!, 1 - t), scale3(points[after]!, t));
}

/** The unit vector across x nearest to n. */
function across(n: Vec3, x: Vec3): Vec3 | null {
  const rest = sub3(n, scale3(x, dot3(n, x)));
  const size = length3(rest);
  return size > 1e-9 ? scale3(rest, 1 / size) : null;
}

function placing({ x, y }: Plane): (v: Vec3) => Vec3 {
  const z = cross3(x, y);
  return (v) => add3(add3(scale3(x, v[0]), scale3(y, v[1])), scale3(z, v[2]));
}
