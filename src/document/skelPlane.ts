/** Skels that were made in the plane z = 0, where the plane lies. */
import type { AnySkel } from '../field/expand.ts';
import type { Plane } from '../math/plane.ts';
import { add3, cross3, scale3 } from '../math/tuple.ts';
import type { Vec3 } from '../math/vec.ts';

/** The same skel in the model's space; planes move nothing nearer or farther, so that weights and radii stay. */
export function onPlane(skel: AnySkel, plane: Plane): AnySkel {
  const normal = cross3(plane.x, plane.y);
  const way = (p: Vec3): Vec3 =>
    add3(add3(scale3(plane.x, p[0]), scale3(plane.y, p[1])), scale3(normal, p[2]));
  const place = (p: Vec3): Vec3 => add3(plane.origin, way(p));
  switch (skel.type) {
    case 'point':
      return { ...skel, at: place(skel.at) };
    case 'segment':
      return { ...skel, a: place(skel.a), b: place(skel.b) };
    case 'polygon':
      return { ...skel, origin: place(skel.origin), u: way(skel.u), v: way(skel.v) };
    case 'arc':
      return { ...skel, centre: place(skel.centre), start: place(skel.start), axis: way(skel.axis) };
    default:
      return { ...skel, points: skel.points.map(place) };
  }
}
