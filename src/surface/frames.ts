/**
 * Frames that move along a curve without turning about it: double reflection, W. Wang, B. Jüttler, D. Zheng,
 * Y. Liu, "Computation of rotation minimizing frames", ACM TOG 27(1), 2008 (global error of fourth order).
 * Frenet frames, the textbook choice, spin at inflections and do not exist on straight pieces.
 *
 * Departures: at a corner (two stations in one place) the frame takes the shortest turn from one tangent to the
 * next. On closed curves the angle by which the last frame misses the first is distributed over the length, so
 * that there is no seam twist.
 */
import { atan2, cos, sin } from '../math/trig.ts';
import { add3, cross3, dot3, length3, scale3, sub3 } from '../math/tuple.ts';
import type { Vec3 } from '../math/vec.ts';

/** A right-handed orthonormal frame: binormal = tangent × normal. */
export interface Frame {
  readonly tangent: Vec3;
  readonly normal: Vec3;
  readonly binormal: Vec3;
}

/** A place on the curve with its unit tangent. */
export interface Station {
  readonly point: Vec3;
  readonly tangent: Vec3;
}

/**
 * One frame a station. `start` is the wished normal of the first; it is made perpendicular to the tangent (any
 * perpendicular when it is parallel). `closed`: the last station is followed by the first, not repeated.
 */
export function rotationMinimizingFrames(
  stations: readonly Station[],
  start: Vec3,
  closed: boolean,
): Frame[] {
  const first = stations[0];
  if (!first) return [];
  const normals: Vec3[] = [perpendicular(start, first.tangent)];
  for (let i = 1; i < stations.length; i++) {
    normals.push(carry(normals[i - 1]!, stations[i - 1]!, stations[i]!));
  }
  if (closed) untwist(normals, stations);
  return stations.map(({ tangent }, i) => frame(tangent, normals[i]!));
}

/** The normal brought from one station to the next by two reflections: across the chord, then onto the tangent. */
function carry(normal: Vec3, from: Station, to: Station): Vec3 {
  const step = sub3(to.point, from.point);
  // in one place: the chord of the arc that would round the corner
  const chord = dot3(step, step) > 0 ? step : add3(from.tangent, to.tangent);
  const rest = sub3(to.tangent, reflect(from.tangent, chord));
  return perpendicular(reflect(reflect(normal, chord), rest), to.tangent);
}

/** Mirrored in the plane perpendicular to `axis`; unchanged when there is no axis (a full reversal). */
function reflect(v: Vec3, axis: Vec3): Vec3 {
  const squared = dot3(axis, axis);
  return squared === 0 ? v : sub3(v, scale3(axis, (2 * dot3(v, axis)) / squared));
}

/** Turns the frames back by the angle that is missing at the seam, in proportion to the length walked. */
function untwist(normals: Vec3[], stations: readonly Station[]): void {
  const first = stations[0]!;
  const arrived = carry(normals[normals.length - 1]!, stations[stations.length - 1]!, first);
  const { normal, binormal } = frame(first.tangent, arrived);
  const missing = atan2(dot3(normals[0]!, binormal), dot3(normals[0]!, normal));
  const walked = [0];
  stations.forEach(({ point }, i) => {
    const following = stations[(i + 1) % stations.length]!.point;
    walked.push(walked[i]! + length3(sub3(following, point)));
  });
  const whole = walked[stations.length]!;
  if (missing === 0 || whole === 0) return;
  stations.forEach(({ tangent }, i) => {
    normals[i] = turn(frame(tangent, normals[i]!), (missing * walked[i]!) / whole);
  });
}

/** The frame's normal turned about its tangent, radians from normal to binormal. */
function turn({ normal, binormal }: Frame, angle: number): Vec3 {
  return add3(scale3(normal, cos(angle)), scale3(binormal, sin(angle)));
}

function frame(tangent: Vec3, normal: Vec3): Frame {
  return { tangent, normal, binormal: cross3(tangent, normal) };
}

/** The unit vector perpendicular to `tangent` nearest to `wished`. */
function perpendicular(wished: Vec3, tangent: Vec3): Vec3 {
  const rest = sub3(wished, scale3(tangent, dot3(wished, tangent)));
  const out = length3(rest) > 1e-10 ? rest : cross3(tangent, leastAxis(tangent));
  return scale3(out, 1 / length3(out));
}

/** The coordinate axis farthest from `v`. */
function leastAxis(v: Vec3): Vec3 {
  const [x, y, z] = [Math.abs(v[0]), Math.abs(v[1]), Math.abs(v[2])];
  if (x <= y && x <= z) return [1, 0, 0];
  return y <= z ? [0, 1, 0] : [0, 0, 1];
}
