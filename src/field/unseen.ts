/**
 * What passes between the corners of a lattice: in bricks of which no corner is inside, edges along which the values would rise above 0
 * before the next corner, as those behind say, and do not. Only there the field is asked, along its gradient: what is inside and, a
 * cell farther, outside again was missed. Gaps in bricks of which no corner is outside likewise, with all signs the other way round.
 */
import { add3, length3, scale3 } from '../math/tuple.ts';
import type { Vec3 } from '../math/vec.ts';
import type { Brick } from './bricks.ts';
import { CORNERS, SIDE } from './hermite.ts';
import { BRICK, type Lattice } from './lattice.ts';
import type { Near } from './near.ts';
import { type Crossed, surfacePoint } from './surfacePoint.ts';
import { THIN, type ThinSpot, wallBetween } from './thinWalls.ts';

/** Fields of thin skels rise the more the nearer they are. */
const STEEPER = 1.5;
/** of a cell: how far beyond the surface, as the gradient has it, the inside is looked for */
const BEYOND = [0.005, 0.04, 0.15, 0.4] as const;

/** cells: where the gradient of a corner tells nothing any more */
const FARTHEST = 2;

const AXES = [1, SIDE, SIDE * SIDE] as const;

const value = new Float64Array(4);

/** A place in a brick, all of whose corners are on one side, with these values; null where nothing was missed. `whole`: the field by all skels. */
export function unseenIn(brick: Brick, values: Float64Array, lattice: Lattice, whole: Near): ThinSpot | null {
  const isGap = values[0]! > 0;
  const corner = suspect(values, isGap ? -1 : 1);
  if (corner < 0) return null;
  const near = isGap ? turned(brick.near) : brick.near;
  const spot = missed(corner, brick, near, isGap ? turned(whole) : whole, lattice);
  return spot && { ...spot, isGap };
}

/** Its inside is the other's outside. */
export const turned = (field: Crossed): Crossed => ({
  value: (x, y, z) => -field.value(x, y, z),
  evaluate: (x, y, z, out) => {
    field.evaluate(x, y, z, out);
    for (let i = 0; i < out.length; i++) out[i] = -out[i]!;
  },
});

function missed(
  corner: number,
  { i, j, k }: Brick,
  near: Crossed,
  whole: Crossed,
  { origin, step }: Lattice,
): ThinSpot | null {
  const from: Vec3 = [
    origin[0] + (BRICK * i + (corner % SIDE)) * step,
    origin[1] + (BRICK * j + (Math.floor(corner / SIDE) % SIDE)) * step,
    origin[2] + (BRICK * k + Math.floor(corner / (SIDE * SIDE))) * step,
  ];
  near.evaluate(...from, value);
  const [first, ...rest] = value;
  const gradient = rest as unknown as Vec3;
  const slope = length3(gradient);
  const along = (distance: number) => add3(from, scale3(gradient, distance / slope));
  const reach = -first! / slope;
  if (!(reach < FARTHEST * step)) return null;
  const beyond = along(reach + THIN * step);
  const low = near.value(...beyond);
  if (low > 0) return null;
  const inside = BEYOND.map((by) => along(reach + by * step)).find((at) => near.value(...at) > 0);
  // beyond the brick its list says less
  if (!inside || !(whole.value(...inside) > 0)) return null;
  const high = near.value(...inside);
  const p = surfacePoint(near, from, inside, first!, high);
  const q = surfacePoint(near, inside, beyond, high, low);
  if (!p.normal || !q.normal) return null;
  return wallBetween({ positions: [...p.at, ...q.at], normals: [...p.normal, ...q.normal] });
}

/** The corner from which the surface should be nearest, though it is not there; −1: none. Of all bricks that the surface does not enter: in few words. */
function suspect(values: Float64Array, sign: 1 | -1): number {
  let found = -1;
  let least = 1;
  for (const stride of AXES) {
    for (let c = stride; c < CORNERS - stride; c++) {
      const here = sign * values[c]!;
      const before = sign * values[c - stride]!;
      const after = sign * values[c + stride]!;
      const rise = STEEPER * (here - Math.min(before, after));
      if (!(here + rise > 0)) continue;
      const at = Math.floor(c / stride) % SIDE;
      if (at === 0 || at === SIDE - 1 || Math.max(before, after) > 0) continue;
      const reach = -here / rise;
      if (reach < least) {
        found = c;
        least = reach;
      }
    }
  }
  return found;
}
