/**
 * How a section's outline stands at one u of a surface, whatever it is made of:
 *     S(u, v) = c − x(v) h + y(v) ρ n,
 * with h = (q_l − q_r)/2, n the drawing plane's normal and (x, y) the outline (thesis 5.4.2, Q = (x(v), u, z(v))).
 * Between two strokes ρ = |h|. On one stroke h is its left at the radius; at a mitred corner h leans and ρ stays.
 *
 * Normals: S_u × S_v, with ρ divided out of S_v so that tips have theirs (ring.ts has the same for circles).
 */
import { dot2, length3 } from '../math/tuple.ts';
import type { Vec2, Vec3 } from '../math/vec.ts';

export interface Stand {
  /** q_l, q_r and c, mm; at a tip all three are one point */
  readonly left: Vec2;
  readonly right: Vec2;
  readonly centre: Vec2;
  /** unit, from c to q_l, in the section's plane; at tips its limit */
  readonly axis: Vec2;
  /** ρ ≥ 0, mm; 0 at tips */
  readonly radius: number;
  /** c′ and h′, by u or by any other measure of the way */
  readonly dCentre: Vec2;
  readonly dHalf: Vec2;
  /** on one stroke: inside of tight bends the speed of points is held at this part of the centre's, so that normals stay outward */
  readonly leastSpeed?: number;
}

/** The point (x, y) of an outline, mm in the drawing plane's coordinates; (−1, 0) and (1, 0) are q_l and q_r to the last bit. */
export function place({ left, right, radius }: Stand, [x, y]: Vec2): Vec3 {
  const l = (1 - x) / 2;
  const r = (1 + x) / 2;
  return [l * left[0] + r * right[0], l * left[1] + r * right[1], y * radius];
}

/** Unit S_u × S_v where the outline passes (x, y) with the derivative (dx, dy). */
export function normalAt(stand: Stand, [x, y]: Vec2, [dx, dy]: Vec2): Vec3 {
  const { axis, dCentre, dHalf } = stand;
  // along u: the section's own normal, to the right of c → q_l
  const along: Vec2 = [axis[1], -axis[0]];
  const speed = dot2(dCentre, along);
  const least = stand.leastSpeed === undefined ? -Infinity : stand.leastSpeed * speed;
  const forward = Math.max(speed - x * dot2(dHalf, along), least);
  const aside = dot2(dCentre, axis) - x * dot2(dHalf, axis);
  const up = y * dot2(dHalf, axis);
  // (axis, along, n) is left-handed: axis × along = −n
  const size = Math.abs(forward) + Math.abs(aside) + Math.abs(up);
  const normal = inPlane(axis, along, [-forward * dy, aside * dy + up * dx, -forward * dx]);
  const length = length3(normal);
  if (length > 1e-9 * size * (Math.abs(dx) + Math.abs(dy))) return scaled(normal, 1 / length);
  // the surface stands still here: across the outline is as good as any direction
  const flat = inPlane(axis, along, [-dy, 0, -dx]);
  const rest = length3(flat);
  return rest > 0 ? scaled(flat, 1 / rest) : [0, 0, 1];
}

function inPlane(axis: Vec2, along: Vec2, [a, b, c]: Vec3): Vec3 {
  return [a * axis[0] + b * along[0], a * axis[1] + b * along[1], c];
}

function scaled([x, y, z]: Vec3, k: number): Vec3 {
  return [x * k, y * k, z * k];
}
