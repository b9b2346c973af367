/**
 * How a section's outline stands at one u of a surface, whatever it is made of:
 *     S(u, v) = c − x(v) h + y(v) ρ n,
 * with h = (q_l − q_r)/2, n the drawing plane's normal and (x, y) the outline (thesis 5.4.2, Q = (x(v), u, z(v))).
 * Between two strokes ρ = |h|. On one stroke h is its left at the radius; at a mitred corner h leans and ρ stays.
 *
 * Normals: S_u × S_v, with ρ divided out of S_v so that tips have theirs (ring.ts has the same for circles).
 */
import { dot2 } from '../math/tuple.ts';
import type { Vec2, Vec3 } from '../math/vec.ts';
import type { Ring } from './ring.ts';

/** As circles stand (ring.ts); derivatives are by u or by any other measure of the way. */
export interface Stand extends Ring {
  /** on one stroke: inside of tight bends the speed of points is held at this part of the centre's, so that normals stay outward */
  readonly leastSpeed?: number;
}

/** The point (x, y) of an outline, mm in the drawing plane's coordinates; (−1, 0) and (1, 0) are q_l and q_r to the last bit. */
export function place({ left, right, radius }: Stand, [x, y]: Vec2): Vec3 {
  const l = (1 - x) / 2;
  const r = (1 + x) / 2;
  return [l * left[0] + r * right[0], l * left[1] + r * right[1], y * radius];
}

/** All points of an outline, x y z each. */
export function placed(stand: Stand, points: readonly Vec2[]): Float64Array {
  const out = new Float64Array(3 * points.length);
  points.forEach((p, j) => {
    out.set(place(stand, p), 3 * j);
  });
  return out;
}

/** Unit S_u × S_v where the outline passes (x, y) with the derivative (dx, dy). */
export function normalAt(stand: Stand, point: Vec2, rate: Vec2): Vec3 {
  const [x, y, z] = normalsAt(stand, [point], [rate]);
  return [x!, y!, z!];
}

/** The same at all points of an outline, with its derivatives there. */
export function normalsAt(stand: Stand, points: readonly Vec2[], rates: readonly Vec2[]): Float64Array {
  const { axis, dCentre, dHalf } = stand;
  // along u: the section's own normal, to the right of c → q_l
  const along: Vec2 = [axis[1], -axis[0]];
  const speed = dot2(dCentre, along);
  const least = stand.leastSpeed === undefined ? -Infinity : stand.leastSpeed * speed;
  const [ca, ha, hf] = [dot2(dCentre, axis), dot2(dHalf, axis), dot2(dHalf, along)];
  const out = new Float64Array(3 * points.length);
  points.forEach(([x, y], j) => {
    const [dx, dy] = rates[j]!;
    const forward = Math.max(speed - x * hf, least);
    const aside = ca - x * ha;
    const up = y * ha;
    const size = (Math.abs(forward) + Math.abs(aside) + Math.abs(up)) * (Math.abs(dx) + Math.abs(dy));
    // (axis, along, n) is left-handed: axis × along = −n
    let [a, b, c] = [-forward * dy, aside * dy + up * dx, -forward * dx];
    let length = Math.sqrt(a * a + b * b + c * c);
    // where the surface stands still, across the outline is as good as any direction
    if (!(length > 1e-9 * size)) {
      [a, b, c] = [-dy, 0, -dx];
      length = Math.sqrt(a * a + c * c);
    }
    if (!(length > 0)) [c, length] = [1, 1];
    out[3 * j] = (a * axis[0] + b * along[0]) / length;
    out[3 * j + 1] = (a * axis[1] + b * along[1]) / length;
    out[3 * j + 2] = c / length;
  });
  return out;
}
