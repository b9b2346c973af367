/**
 * Vectors as immutable tuples: each function returns a new one.
 *
 * gl-matrix writes into an `out` and types it as an array of any length; where no hot loop asks for that, these read
 * better. All use + − * / and sqrt only, so they give the same bits everywhere.
 */
import type { Quat, Vec2, Vec3 } from './vec.ts';

export const add2 = (a: Vec2, b: Vec2): Vec2 => [a[0] + b[0], a[1] + b[1]];
export const sub2 = (a: Vec2, b: Vec2): Vec2 => [a[0] - b[0], a[1] - b[1]];
export const scale2 = (a: Vec2, k: number): Vec2 => [a[0] * k, a[1] * k];
/** a at t = 0 and b at t = 1, both exactly. */
export const mix2 = (a: Vec2, b: Vec2, t: number): Vec2 => [
  a[0] * (1 - t) + b[0] * t,
  a[1] * (1 - t) + b[1] * t,
];
export const dot2 = (a: Vec2, b: Vec2): number => a[0] * b[0] + a[1] * b[1];
/** The z of a × b: positive when b lies to the left of a. */
export const cross2 = (a: Vec2, b: Vec2): number => a[0] * b[1] - a[1] * b[0];
export const length2 = (a: Vec2): number => Math.sqrt(a[0] * a[0] + a[1] * a[1]);
export const distance2 = (a: Vec2, b: Vec2): number => length2(sub2(a, b));

export const add3 = (a: Vec3, b: Vec3): Vec3 => [a[0] + b[0], a[1] + b[1], a[2] + b[2]];
export const sub3 = (a: Vec3, b: Vec3): Vec3 => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
export const scale3 = (a: Vec3, k: number): Vec3 => [a[0] * k, a[1] * k, a[2] * k];
export const dot3 = (a: Vec3, b: Vec3): number => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
export const cross3 = (a: Vec3, b: Vec3): Vec3 => [
  a[1] * b[2] - a[2] * b[1],
  a[2] * b[0] - a[0] * b[2],
  a[0] * b[1] - a[1] * b[0],
];
export const length3 = (a: Vec3): number => Math.sqrt(dot3(a, a));

/** `v` turned by the unit quaternion `q`. */
export function rotate3(q: Quat, v: Vec3): Vec3 {
  const axis: Vec3 = [q[0], q[1], q[2]];
  const t = scale3(cross3(axis, v), 2);
  return add3(add3(v, scale3(t, q[3])), cross3(axis, t));
}

/** `v` turned back by the unit quaternion `q`. */
export function unrotate3(q: Quat, v: Vec3): Vec3 {
  return rotate3([-q[0], -q[1], -q[2], q[3]], v);
}
