/**
 * What closes an open end: a disc with a crease around it, or a dome that continues the surface smoothly.
 * Rows are given from the end outward, after the end's own row; `outsideIn` turns them round for a start.
 */
import { atan2, cos, PI, sin } from '../math/trig.ts';
import { add3, scale3 } from '../math/tuple.ts';
import type { Vec3 } from '../math/vec.ts';
import type { Row } from '../mesh/grid.ts';
import type { RowAt, SheetRow } from './sheet.ts';

/** The rim once more with the disc's unit normal, then the disc's centre. */
export function disc(rim: Row, centre: Vec3, normal: Vec3): Row[] {
  const normals = fill(rim.points.length, () => normal);
  const points = fill(rim.points.length, () => centre);
  return [
    { points: rim.points, normals, joined: false },
    { points, normals, pole: true, joined: true },
  ];
}

/** An end of a tube: where it is, how wide it is, and where it points. */
export interface End {
  readonly centre: Vec3;
  /** unit, out of the tube */
  readonly outward: Vec3;
  /** mm */
  readonly radius: number;
  /** widening per mm outward */
  readonly flare: number;
}

/**
 * The part of a sphere that touches the tube along its end: the hemisphere round the stroke's end where the radius
 * is constant; where it widens by f per mm, centred f r further, with √(1 + f²) times the radius. `radial` holds the
 * unit vectors from the centre to the columns; `quads` rows from rim to tip.
 */
export function dome(end: End, radial: readonly Vec3[], quads: number): Row[] {
  const { outward, radius, flare } = end;
  const from = atan2(-flare, 1);
  const size = radius * Math.sqrt(1 + flare * flare);
  const middle = add3(end.centre, scale3(outward, flare * radius));
  return Array.from({ length: quads }, (_, i) => {
    const pole = i === quads - 1;
    const angle = from + ((PI / 2 - from) * (i + 1)) / quads;
    const normal = (j: number): Vec3 =>
      pole ? outward : add3(scale3(radial[j]!, cos(angle)), scale3(outward, sin(angle)));
    return {
      points: fill(3 * radial.length, (j) => add3(middle, scale3(normal(j), size))),
      normals: fill(3 * radial.length, normal),
      pole,
      joined: true,
    };
  });
}

/** Rows of a cap as they come before the surface's first row: joined the other way round. */
export function outsideIn(rows: readonly Row[]): { cap: Row[]; joinsSurface: boolean } {
  const cap = rows.map((row, i) => ({ ...row, joined: rows[i + 1]?.joined ?? false })).reverse();
  return { cap, joinsSurface: rows[0]?.joined ?? false };
}

/** Rows of a cap as part of a sheet: bends move them stiffly with their end. */
export function rigid(rows: readonly Row[], { u, side }: RowAt): SheetRow[] {
  return rows.map((row) => ({ ...row, at: { u, side, rigid: true } }));
}

function fill(length: number, vector: (column: number) => Vec3): Float64Array {
  const out = new Float64Array(length);
  for (let j = 0; j < length / 3; j++) out.set(vector(j), 3 * j);
  return out;
}
