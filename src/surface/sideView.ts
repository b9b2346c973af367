/** A side view as coordinates: x and y on its plane, z along V = x × y. */
import type { Plane } from '../math/plane.ts';
import { add3, cross3, dot3, scale3, sub3 } from '../math/tuple.ts';
import type { Vec2, Vec3 } from '../math/vec.ts';

export interface Side2 {
  /** where its coordinates begin, and their directions */
  readonly axes: { readonly origin: Vec3; readonly x: Vec3; readonly y: Vec3; readonly z: Vec3 };
  /** of a place, mm */
  point(p: Vec3): Vec2;
  /** of a direction, along the plane alone */
  flat(v: Vec3): Vec2;
  /** of a direction, with its part along V */
  into(v: Vec3): Vec3;
  /** back */
  out(v: Vec3): Vec3;
}

export function sideView({ origin, x, y }: Plane): Side2 {
  const z = cross3(x, y);
  const flat = (v: Vec3): Vec2 => [dot3(v, x), dot3(v, y)];
  return {
    axes: { origin, x, y, z },
    point: (p) => flat(sub3(p, origin)),
    flat,
    into: (v) => [dot3(v, x), dot3(v, y), dot3(v, z)],
    out: (v) => add3(add3(scale3(x, v[0]), scale3(y, v[1])), scale3(z, v[2])),
  };
}

/** `plane` in the coordinates of the drawing plane `drawing`: what bends of sheets take. */
export function within(plane: Plane, drawing: Plane): Plane {
  const z = cross3(drawing.x, drawing.y);
  const turn = (v: Vec3): Vec3 => [dot3(v, drawing.x), dot3(v, drawing.y), dot3(v, z)];
  return { origin: turn(sub3(plane.origin, drawing.origin)), x: turn(plane.x), y: turn(plane.y) };
}
