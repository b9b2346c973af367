/**
 * How far points of sections slide along d near its corners, so that sections of the inner side get out of each other's
 * way and both legs meet in the bisecting plane: ∓ tan(turn/2) at the corner, fading over twice the mitre (slices.ts).
 */
import { atan2, cos, PI, sin } from '../math/trig.ts';
import { cross2, dot2, sub2 } from '../math/tuple.ts';
import { type Bending, moveAt, type Slide } from './bendMap.ts';
import type { SheetRow } from './sheet.ts';

/** sharper turns (100°) are mitred as this one: beyond, a mitre becomes a spike */
const SHARPEST = (50 * PI) / 180;
/** points slide over this many times the length of the mitre */
const SLIDE_OVER = 2;

/** One side of a corner: `slope` at the corner, fading to 0 over `over` of u. */
interface Ramp {
  readonly u: number;
  /** −1 before the corner, 1 after it */
  readonly side: -1 | 1;
  readonly slope: number;
  readonly over: number;
}

/** `corners`: u at which d has corners; `rows`: how wide the sheet is there. */
export function mitres(
  bending: Omit<Bending, 'slide'>,
  corners: readonly number[],
  rows: readonly SheetRow[],
  isClosed: boolean,
): Slide {
  if (corners.length === 0) return () => [0, 0];
  const plain: Bending = { ...bending, slide: () => [0, 0] };
  const ramps = corners.flatMap((u, i) => {
    const slope = slopeAt(plain, u, isClosed);
    if (!(Math.abs(slope) > 1e-9)) return [];
    // at a closed spine's end there is one side, at its start the other
    const sides = ([-1, 1] as const).filter((side) => (side === -1 ? u > 0 : u < 1));
    return sides.map((side): Ramp => {
      const room = side === -1 ? u - (corners[i - 1] ?? -u) : (corners[i + 1] ?? 2 - u) - u;
      const pace = Math.abs(bending.axis.at(u, side).speed()) * bending.path.stretch;
      const mitre = SLIDE_OVER * Math.abs(slope) * reachAt(plain, rows, u, side);
      return { u, side, slope: side * slope, over: Math.min(pace > 0 ? mitre / pace : room, room / 2) };
    });
  });
  return (u, side) => {
    let [slide, rate] = [0, 0];
    for (const ramp of ramps) {
      const away = (u - ramp.u) * ramp.side;
      if (away < 0 || (away === 0 && side !== ramp.side) || !(away < ramp.over)) continue;
      slide += ramp.slope * (1 - away / ramp.over);
      rate -= (ramp.side * ramp.slope) / ramp.over;
    }
    return [slide, rate];
  };
}

/** tan of half the turn of d at u, to the left positive. */
function slopeAt(bending: Bending, u: number, isClosed: boolean): number {
  const seam = isClosed && (u === 0 || u === 1);
  const before = headingAt(bending, seam ? 1 : u, -1);
  const after = headingAt(bending, seam ? 0 : u, 1);
  const half = 0.5 * atan2(cross2(before, after), dot2(before, after));
  const kept = Math.min(Math.max(half, -SHARPEST), SHARPEST);
  return sin(kept) / cos(kept);
}

/** T_d, which is where the motion takes T_l. */
function headingAt(bending: Bending, u: number, side: -1 | 1): readonly [number, number] {
  const along = bending.axis.at(u, side).direction();
  const [x, y] = moveAt(bending, u, side).turn();
  return [dot2(x, along), dot2(y, along)];
}

/** mm from the axis to the farthest point of the row at u, across the axis. */
function reachAt(bending: Bending, rows: readonly SheetRow[], u: number, side: -1 | 1): number {
  const here = bending.axis.at(u, side);
  const row = rows.reduce((best, row) => (Math.abs(row.at.u - u) < Math.abs(best.at.u - u) ? row : best));
  const along = here.direction();
  let most = 0;
  for (let k = 0; k < row.points.length; k += 3) {
    const p = bending.view.point([row.points[k]!, row.points[k + 1]!, row.points[k + 2]!]);
    most = Math.max(most, Math.abs(cross2(along, sub2(p, here.point()))));
  }
  return most;
}
