/**
 * Rigid motions: turned by a unit quaternion about the origin, then moved. Only + − × ÷ and square roots, so that a
 * moved part has the same bits everywhere.
 */
import { add3, cross3, dot3, length3, rotate3, scale3, sub3 } from './tuple.ts';
import type { Quat, Vec3 } from './vec.ts';

export interface Placement {
  /** unit quaternion, scalar last */
  readonly rotation: Quat;
  /** mm */
  readonly translation: Vec3;
}

export const UNMOVED: Placement = { rotation: [0, 0, 0, 1], translation: [0, 0, 0] };

/** Leaves everything where it is. */
export function isUnmoved({ rotation, translation }: Placement): boolean {
  const [x, y, z, w] = rotation;
  return Math.abs(w) === 1 && [x, y, z, ...translation].every((value) => value === 0);
}

export function place3({ rotation, translation }: Placement, p: Vec3): Vec3 {
  return add3(rotate3(rotation, p), translation);
}

/** First `inner`, then `outer`. */
export function compose(outer: Placement, inner: Placement): Placement {
  return {
    rotation: normalized(multiply(outer.rotation, inner.rotation)),
    translation: place3(outer, inner.translation),
  };
}

/** The motion that takes it back. */
export function unplaced({ rotation: [x, y, z, w], translation }: Placement): Placement {
  const back: Quat = [0 - x, 0 - y, 0 - z, w];
  return { rotation: back, translation: scale3(rotate3(back, translation), -1) };
}

/** The motion that turns about `pivot` and then moves by `by`, mm. */
export function turnAbout(pivot: Vec3, rotation: Quat, by: Vec3 = [0, 0, 0]): Placement {
  return { rotation, translation: add3(sub3(pivot, rotate3(rotation, pivot)), by) };
}

/** The shortest turn that brings one unit vector onto another; opposite ones turn about any axis across. */
export function shortestTurn(from: Vec3, to: Vec3): Quat {
  const cosine = dot3(from, to);
  if (cosine < -1 + 1e-12) {
    const across = cross3(from, Math.abs(from[0]) < 0.6 ? [1, 0, 0] : [0, 1, 0]);
    const axis = scale3(across, 1 / length3(across));
    return [axis[0], axis[1], axis[2], 0];
  }
  const [x, y, z] = cross3(from, to);
  return normalized([x, y, z, 1 + cosine]);
}

/** The turn that brings the axes x and y of the world onto these orthonormal ones; from the largest component, which loses no digits. */
export function turnOnto(x: Vec3, y: Vec3): Quat {
  const z = cross3(x, y);
  const trace = x[0] + y[1] + z[2];
  if (trace > 0) return normalized([y[2] - z[1], z[0] - x[2], x[1] - y[0], 1 + trace]);
  if (x[0] >= y[1] && x[0] >= z[2])
    return normalized([1 + x[0] - y[1] - z[2], y[0] + x[1], z[0] + x[2], y[2] - z[1]]);
  if (y[1] >= z[2]) return normalized([y[0] + x[1], 1 + y[1] - x[0] - z[2], z[1] + y[2], z[0] - x[2]]);
  return normalized([z[0] + x[2], z[1] + y[2], 1 + z[2] - x[0] - y[1], x[1] - y[0]]);
}

function multiply(a: Quat, b: Quat): Quat {
  return [
    a[3] * b[0] + a[0] * b[3] + a[1] * b[2] - a[2] * b[1],
    a[3] * b[1] - a[0] * b[2] + a[1] * b[3] + a[2] * b[0],
    a[3] * b[2] + a[0] * b[1] - a[1] * b[0] + a[2] * b[3],
    a[3] * b[3] - a[0] * b[0] - a[1] * b[1] - a[2] * b[2],
  ];
}

function normalized([x, y, z, w]: Quat): Quat {
  const length = Math.sqrt(x * x + y * y + z * z + w * w);
  return [x / length, y / length, z / length, w / length];
}
