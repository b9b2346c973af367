/**
 * Between the screen and the drawing plane: rays through pixels, points on planes, and back.
 *
 * Screen points are CSS pixels, x to the right, y down, (0, 0) the upper left corner of the canvas. The view keeps
 * its pivot in the middle of the screen; in perspective the camera stands so far back that `view.height` mm are visible
 * at the pivot, so switching between orthographic and perspective leaves the pivot's plane as it is on the screen.
 */

import { cos, PI, sin } from '../math/trig.ts';
import { add3, cross3, dot3, rotate3, scale3, sub3, unrotate3 } from '../math/tuple.ts';
import type { Vec2, Vec3 } from '../math/vec.ts';
import type { Plane, View } from './stroke.ts';

export interface Ray {
  /** mm */
  readonly origin: Vec3;
  /** unit length, away from the person who looks */
  readonly direction: Vec3;
}

/** CSS pixels. */
export interface ScreenSize {
  readonly width: number;
  readonly height: number;
}

/** A plane seen more edge-on than this (sine of the angle, 0.06°) gives no point: it would lie kilometres away. */
const EDGE_ON = 1e-3;

/** The ray through a pixel. Orthographic rays start far enough back that the model lies before them. */
export function rayAt(view: View, size: ScreenSize, x: number, y: number): Ray {
  const scale = view.height / size.height;
  const sx = (x - size.width / 2) * scale;
  const sy = (size.height / 2 - y) * scale;
  const distance = eyeDistance(view);
  const local: Vec3 = distance === null ? [0, 0, -1] : unit([sx, sy, -distance]);
  const start: Vec3 = distance === null ? [sx, sy, standBack(view)] : [0, 0, distance];
  return {
    origin: add3(view.pivot, rotate3(view.rotation, start)),
    direction: rotate3(view.rotation, local),
  };
}

/** Where the ray meets the plane, in the plane's own mm; null when the plane is edge-on or behind the ray. */
export function onPlane(ray: Ray, plane: Plane): Vec2 | null {
  const normal = cross3(plane.x, plane.y);
  const slope = dot3(ray.direction, normal);
  if (!(Math.abs(slope) >= EDGE_ON)) return null;
  const t = dot3(sub3(plane.origin, ray.origin), normal) / slope;
  if (!(t > 0)) return null;
  const offset = sub3(add3(ray.origin, scale3(ray.direction, t)), plane.origin);
  return [dot3(offset, plane.x), dot3(offset, plane.y)];
}

/** A point of the plane in model space, mm. */
export function toWorld(plane: Plane, p: Vec2): Vec3 {
  return add3(plane.origin, add3(scale3(plane.x, p[0]), scale3(plane.y, p[1])));
}

/** The nearest point of the plane to `p`, in the plane's own mm: the inverse of toWorld. */
export function toPlane(plane: Plane, p: Vec3): Vec2 {
  const offset = sub3(p, plane.origin);
  return [dot3(offset, plane.x), dot3(offset, plane.y)];
}

/** The pixel that shows `p` (mm), or null when it lies behind the camera. */
export function project(view: View, size: ScreenSize, p: Vec3): Vec2 | null {
  const local = unrotate3(view.rotation, sub3(p, view.pivot));
  const distance = eyeDistance(view);
  if (distance !== null && local[2] >= distance) return null;
  const shrink = distance === null ? 1 : distance / (distance - local[2]);
  const scale = (shrink * size.height) / view.height;
  return [size.width / 2 + local[0] * scale, size.height / 2 - local[1] * scale];
}

/** The plane through a point that faces the person who looks: x to the right of the screen, y up. */
export function facingPlane(view: View, through: Vec3): Plane {
  return { origin: through, x: rotate3(view.rotation, [1, 0, 0]), y: rotate3(view.rotation, [0, 1, 0]) };
}

/** From the camera to the pivot, mm; null when orthographic. */
export function eyeDistance(view: View): number | null {
  if (view.fov <= 0) return null;
  const half = (view.fov * PI) / 360;
  return (0.5 * view.height * cos(half)) / sin(half);
}

/** mm: before any model we show (10 m), and still exact to 1e-11 mm in float64 */
function standBack(view: View): number {
  return Math.max(1e4, 100 * view.height);
}

function unit(v: Vec3): Vec3 {
  return scale3(v, 1 / Math.sqrt(dot3(v, v)));
}
