/** A picture of a field's surface itself: a ray a pixel (raycast.ts). Twin of shaders/raycast. */
import { dot3, rotate3, sub3 } from '../math/tuple.ts';
import type { Vec3 } from '../math/vec.ts';
import { eyeDistance, rayAt } from '../stroke/plane.ts';
import type { View } from '../stroke/stroke.ts';
import type { Located } from './polygonize.ts';
import { type Ray, Raycaster } from './raycast.ts';

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
  /** Four a pixel: red, green, blue (0–1, linear), and 1 + the place of the body among those that were cast; 0 where there is none. */
  readonly colours: Float32Array;
}

/** a power of two: the same in float32 */
export const NOWHERE = -1.2676506002282294e30;

/** rows between two looks at the clock */
const BATCH = 1;

/** Casts all rays; yields what share is done. The work is in the tally of what was located. */
export function* raycasting(
  located: Pick<Located, 'whole' | 'tally' | 'bricks'>,
  camera: RayCamera,
): Generator<number, RayImage> {
  const { width, height } = camera;
  const caster = new Raycaster(located);
  const image = {
    width,
    height,
    surface: new Float32Array(4 * width * height),
    colours: new Float32Array(4 * width * height),
  };
  for (let row = 0; row < height; row++) {
    for (let column = 0; column < width; column++) castInto(image, caster, camera, column, row);
    if (row % BATCH === BATCH - 1) yield (row + 1) / height;
  }
  return image;
}

function castInto(
  { surface, colours }: RayImage,
  caster: Raycaster,
  camera: RayCamera,
  x: number,
  y: number,
) {
  const { view, width } = camera;
  const at = 4 * (y * width + x);
  const isHit = caster.cast(rayOf(camera, x, y));
  const { normal, colour, at: place } = caster.hit;
  if (!isHit) {
    surface[at + 3] = NOWHERE;
    return;
  }
  surface.set(normal, at);
  surface[at + 3] = dot3(sub3(place, view.pivot), back(view));
  colours.set(colour, at);
  colours[at + 3] = 1;
}

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
