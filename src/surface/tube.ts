/**
 * A tube: circles perpendicular to one stroke (thesis 5.2, eq 5.1), C_u(v) = M_u ⟨cos v, sin v, 0⟩.
 * M_u is a rotation minimizing frame (frames.ts); v = 0 lies on the left of the stroke, v = ¼ behind the plane.
 *
 * Departures. The thesis sets the radius by the keyboard and leaves it constant; with `pressure` ours follows
 * the pen: r(u) = radius (0.2 + 1.6 p(u)), that is one fifth to nine fifths, and the radius itself at the 0.5 of pointers
 * without pressure. Ends are round or flat, corners mitred or ball joints (slices.ts); the thesis shows neither.
 *
 * A radius larger than the stroke's own bends makes the surface overlap itself there. It stays closed and finite;
 * its volume then counts the overlap. Only a stroke that turns back by 180° to the last bit puts ring on ring, which
 * welding by position cannot tell apart.
 */
import { add3, length2, scale3 } from '../math/tuple.ts';
import type { Vec2, Vec3 } from '../math/vec.ts';
import { emptyMesh, evenColumns, gridMesh, type Row } from '../mesh/grid.ts';
import type { Mesh } from '../mesh/mesh.ts';
import type { Curve } from '../stroke/curve.ts';
import type { Plane } from '../stroke/stroke.ts';
import { disc, dome, outsideIn, rigid } from './caps.ts';
import { type Circle, closedCircle } from './circle.ts';
import { type Frame, rotationMinimizingFrames } from './frames.ts';
import { quadCount } from './rows.ts';
import type { Sheet, SheetRow } from './sheet.ts';
import { type Slice, slices } from './slices.ts';
import { strokeSpine } from './spine.ts';

export interface TubeOptions {
  /** mm, above 0 */
  readonly radius: number;
  /** lets the pen's pressure change the radius */
  readonly pressure: boolean;
  /** how open ends are closed */
  readonly caps: 'round' | 'flat' | 'none';
  /** quads along the stroke (about, caps not counted) and around, at least 1 and 3 */
  readonly u: number;
  readonly v: number;
}

/** a steeper widening than this (27°) is not continued by a dome: that would be a ball on a spike */
const STEEPEST_DOME = 0.5;
/** the part of the length by which the surface's speed may shrink inside a bend before normals stop following */
export const LEAST_SPEED = 0.1;
/** away from the person who drew, in the plane's coordinates */
const BEHIND: Vec3 = [0, 0, -1];

/**
 * The closed tube round a stroke, outward; open at the ends with caps 'none'. A dot (a stroke without length) is a
 * ball with round caps and otherwise a mesh without triangles. Throws RangeError for a radius that is not above 0 and
 * for u or v that are not finite.
 */
export function tube(curve: Curve, plane: Plane, options: TubeOptions): Mesh {
  const sheet = tubeSheet(curve, options);
  return sheet ? gridMesh(sheet.rows, sheet.columns, plane) : emptyMesh();
}

/** The same before it is a mesh; null for a dot that round caps do not make a ball of. */
export function tubeSheet(curve: Curve, options: TubeOptions): Sheet | null {
  const u = quadCount('u', options.u, 1);
  const v = quadCount('v', options.v, 3);
  const radius = radiusOf(curve, options);
  if (!(curve.length > 0) && (curve.closed || options.caps !== 'round')) return null;
  const circle = closedCircle(v);
  const along = slices(curve, radius, u, v).map(flattenEnds(curve.closed));
  const radials = framesOf(along, curve.closed).map((frame) => radialsOf(frame, circle));
  const rows = along.map((slice, i) => sliceRow(slice, radials[i]!, circle));
  shareCreases(rows, curve.closed);
  return {
    rows: curve.closed ? rows : capped(rows, along, radials, options),
    columns: evenColumns(v),
    spine: strokeSpine(curve),
  };
}

/** The radius at u, mm. Throws RangeError for one that is not above 0. */
export function radiusOf(
  curve: Curve,
  { radius, pressure }: Pick<TubeOptions, 'radius' | 'pressure'>,
): (u: number) => number {
  if (!(radius > 0 && radius < Infinity)) {
    throw new RangeError(`surface: radius must be a length above 0 mm, got ${radius}`);
  }
  if (!pressure) return () => radius;
  return (u) => radius * (0.2 + 1.6 * Math.min(Math.max(curve.pressure(u), 0), 1));
}

function flattenEnds(closed: boolean): (slice: Slice, i: number, all: readonly Slice[]) => Slice {
  return (slice, i, all) => (closed || (i > 0 && i < all.length - 1) ? slice : flattened(slice));
}

/** At open ends the widening is what a dome can continue, so that normals run through. */
export function flattened(slice: Slice): Slice {
  return { ...slice, flare: Math.min(Math.max(slice.flare, -STEEPEST_DOME), STEEPEST_DOME), bend: 0 };
}

/** Frames whose binormal is the left of the stroke. */
function framesOf(along: readonly Slice[], closed: boolean): Frame[] {
  const stations = along.map(({ point, tangent }) => ({ point: lift(point), tangent: lift(tangent) }));
  return rotationMinimizingFrames(stations, BEHIND, closed);
}

/** Unit vectors from the centre to each column. */
function radialsOf({ normal, binormal }: Frame, circle: Circle): Vec3[] {
  return circle.map(([x, y]) => add3(scale3(binormal, x), scale3(normal, y)));
}

/** The normal is across (1 − r κ cos v) e − r′ t: perpendicular to both derivatives of the surface. */
function sliceRow(slice: Slice, radial: readonly Vec3[], circle: Circle): SheetRow {
  const { radius, flare, bend, slide } = slice;
  const centre = lift(slice.point);
  const tangent = lift(slice.tangent);
  const points = new Float64Array(3 * radial.length);
  const normals = new Float64Array(3 * radial.length);
  radial.forEach((e, j) => {
    const left = radius * circle[j]![0];
    const speed = Math.max(1 - bend * left, LEAST_SPEED);
    const length = length2([speed, flare]);
    points.set(add3(add3(centre, scale3(e, radius)), scale3(tangent, slide * left)), 3 * j);
    normals.set(add3(scale3(e, speed / length), scale3(tangent, -flare / length)), 3 * j);
  });
  return { points, normals, joined: slice.joined, at: slice.at };
}

/** Rows in one place get the same points to the last bit. */
function shareCreases(rows: SheetRow[], closed: boolean): void {
  for (let i = 1; i < rows.length; i++) {
    if (!rows[i]!.joined) rows[i] = { ...rows[i]!, points: rows[i - 1]!.points };
  }
  if (closed) rows.push({ ...rows.pop()!, points: rows[0]!.points });
}

function capped(
  rows: readonly SheetRow[],
  along: readonly Slice[],
  radials: readonly (readonly Vec3[])[],
  { caps, v }: TubeOptions,
): SheetRow[] {
  if (caps === 'none') return [...rows];
  const end = (i: number, out: 1 | -1): Row[] => {
    const { point, tangent, radius, flare } = along[i]!;
    const outward = scale3(lift(tangent), out);
    if (caps === 'flat') return disc(rows[i]!, lift(point), outward);
    const quads = Math.max(Math.ceil(v / 4), 2);
    return dome({ centre: lift(point), outward, radius, flare: out * flare }, radials[i]!, quads);
  };
  const { cap, joinsSurface } = outsideIn(end(0, -1));
  const [first, ...others] = rows;
  const last = rows.length - 1;
  return [
    ...rigid(cap, first!.at),
    { ...first!, joined: joinsSurface },
    ...others,
    ...rigid(end(last, 1), rows[last]!.at),
  ];
}

function lift(p: Vec2): Vec3 {
  return [p[0], p[1], 0];
}
