import type { Vec3 } from './vec.ts';

/** A plane with axes. x and y are orthonormal; of a drawing plane x × y points to the person who drew. */
export interface Plane {
  readonly origin: Vec3;
  readonly x: Vec3;
  readonly y: Vec3;
}
