/** What a picture of rays is, and which ray goes through a pixel. */
import { rotate3 } from '../math/tuple.ts';
import type { Vec3 } from '../math/vec.ts';
import { eyeDistance, rayAt } from '../stroke/plane.ts';
import type { View } from '../stroke/stroke.ts';
import type { Ray } from './raycast.ts';

/** What is looked at, and by how many rays. */
export interface RayCamera {
  readonly view: View;
  /** pixels */
  readonly width: number;
  readonly height: number;
  /** where in its pixel each ray goes through, 0–1 to the right and down */
  readonly offset: readonly [x: number, y: number];
}

export interface RayImage {
  readonly width: number;
  readonly height: number;
  /**
   * Four a pixel, rows from the top: the unit outward normal in the model's space, and how many mm the surface lies before the plane of the
   * pivot that faces the camera; NOWHERE and no normal where there is none.
   */
  readonly surface: Float32Array;
  /**
   * Four a pixel: red, green, blue (0–1, linear), and 1 + the place of the body among those that were cast. Where there is none 0.
   */
  readonly colours: Float32Array;
  /** One a pixel: 1 where the ray passed a body by less than half a pixel before it met what is seen, or nothing. Not there: nobody told. */
  readonly passed?: Uint8Array;
}

/** a power of two: the same in float32 */
export const NOWHERE = -1.2676506002282294e30;

/** Through a pixel. */
export function rayOf(camera: RayCamera, x: number, y: number): Ray {
  const { view, offset } = camera;
  const { origin, direction } = rayAt(view, camera, x + offset[0], y + offset[1]);
  const pixel = view.height / camera.height;
  const eye = eyeDistance(view);
  // behind an eye nothing is seen; without one all is
  const seen =
    eye === null ? { nearest: -Infinity, pixel, growth: 0 } : { nearest: 0, pixel: 0, growth: pixel / eye };
  return { from: origin, along: direction, ...seen };
}

export const back = ({ rotation }: View): Vec3 => rotate3(rotation, [0, 0, 1]);
