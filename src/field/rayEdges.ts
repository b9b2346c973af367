/**
 * More than one ray a pixel, where one is not enough: at edges. Everywhere else the surface is so even across a pixel that what another ray
 * through it meets is told by the plane that touches it (Whitted 1980 and Akenine-Möller et al. call it adaptive supersampling).
 */
import { rotate3 } from '../math/tuple.ts';
import type { Vec3 } from '../math/vec.ts';
import { eyeDistance } from '../stroke/plane.ts';
import { back, NOWHERE, type RayCamera, type RayImage } from './rayImage.ts';

/** Where in the pixel rays go through, after the first in its middle: the four places of hardware multisampling, which triangles get. */
export const OFFSETS: readonly (readonly [x: number, y: number])[] = [
  [-2, -6],
  [6, -2],
  [-6, 2],
  [2, 6],
].map(([x = 0, y = 0]) => [0.5 + x / 16, 0.5 + y / 16]);

/** cosine between normals of neighbours that are one even surface */
const EVEN = 0.9;
/** sine of the angle to the ray below which depth changes too fast */
const GRAZING = 0.1;
/** of a pixel: how far a neighbour may lie from the plane */
const FLAT = 0.5;
/** of colours, 0–1 */
const ALIKE = 0.02;

const BESIDE = [
  [1, 0],
  [-1, 0],
  [0, 1],
  [0, -1],
] as const;

/** The pixels at edges: of surfaces against others or against nothing, of colours, where they are seen edge-on, and what one ray has only just passed. Ascending. */
export function edgesOf(
  { width, height, surface, colours, passed }: RayImage,
  camera: RayCamera,
): Uint32Array<ArrayBuffer> {
  const found: number[] = [];
  const plane = new Planes(camera);
  for (let y = 0; y < height; y++) {
    for (let x = 0; x < width; x++) {
      const at = y * width + x;
      if (isEdge(x, y, at)) found.push(at);
    }
  }
  return Uint32Array.from(found);

  function isEdge(x: number, y: number, at: number): boolean {
    const here = surface[4 * at + 3]! !== NOWHERE;
    if (passed?.[at] === 1 || (here && plane.facing(surface, at) < GRAZING)) return true;
    for (const [dx, dy] of BESIDE) {
      const [nx, ny] = [x + dx, y + dy];
      if (nx < 0 || ny < 0 || nx >= width || ny >= height) continue;
      const other = ny * width + nx;
      if ((surface[4 * other + 3]! !== NOWHERE) !== here) return true;
      if (here && differ(at, other, dx, dy)) return true;
    }
    return false;
  }

  function differ(at: number, other: number, dx: number, dy: number): boolean {
    const [a, b] = [4 * at, 4 * other];
    if (colours[a + 3] !== colours[b + 3]) return true;
    const cosine =
      surface[a]! * surface[b]! + surface[a + 1]! * surface[b + 1]! + surface[a + 2]! * surface[b + 2]!;
    if (cosine < EVEN) return true;
    for (let channel = 0; channel < 3; channel++)
      if (Math.abs(colours[a + channel]! - colours[b + channel]!) > ALIKE) return true;
    const off = Math.abs(plane.depth(surface, at, dx, dy) - surface[b + 3]!);
    return off * plane.facing(surface, at) > FLAT * plane.pixel;
  }
}

/** What was cast again, pixel by pixel. */
export interface Recast {
  readonly offset: readonly [x: number, y: number];
  /** four a place, as in RayImage */
  readonly surface: Float32Array;
  readonly colours: Float32Array;
}

/** The image that rays through another place of the pixels give, from that through their middle and what was cast again at `edges`. */
export function imageThrough(
  base: RayImage,
  camera: RayCamera,
  edges: Uint32Array,
  { offset, surface, colours }: Recast,
): RayImage {
  const image = { ...base, surface: base.surface.slice(), colours: base.colours.slice() };
  const plane = new Planes(camera);
  const [dx, dy] = [offset[0] - camera.offset[0], offset[1] - camera.offset[1]];
  for (let at = 0; at < base.width * base.height; at++)
    if (base.surface[4 * at + 3]! !== NOWHERE)
      image.surface[4 * at + 3] = plane.depth(base.surface, at, dx, dy);
  for (const [i, at] of edges.entries()) {
    image.surface.set(surface.subarray(4 * i, 4 * i + 4), 4 * at);
    image.colours.set(colours.subarray(4 * i, 4 * i + 4), 4 * at);
  }
  return image;
}

/** The planes that touch the surface in pixels. In the camera's axes: the pivot is the origin, z points to the eye. Makes no objects: it is asked for every pixel. */
class Planes {
  /** mm at the pivot */
  readonly pixel: number;
  readonly #camera: RayCamera;
  readonly #right: Vec3;
  readonly #up: Vec3;
  readonly #back: Vec3;
  /** one over how far the eye is from the pivot; 0 without an eye */
  readonly #bent: number;

  constructor(camera: RayCamera) {
    const { rotation } = camera.view;
    const eye = eyeDistance(camera.view);
    this.#camera = camera;
    this.pixel = camera.view.height / camera.height;
    this.#right = rotate3(rotation, [1, 0, 0]);
    this.#up = rotate3(rotation, [0, 1, 0]);
    this.#back = back(camera.view);
    this.#bent = eye === null ? 0 : 1 / eye;
  }

  /** Sine of the angle between plane and ray. */
  facing(surface: Float32Array, at: number): number {
    const [x, y] = [this.#aside(at, 0), this.#above(at, 0)];
    return this.#against(surface, at, x, y) / Math.sqrt(1 + x * x + y * y);
  }

  /** How many mm the plane of a pixel lies before the pivot's, dx pixels to the right and dy down. */
  depth(surface: Float32Array, at: number, dx: number, dy: number): number {
    const before = surface[4 * at + 3]!;
    const size = this.pixel * (1 - before * this.#bent);
    const off = size * (dx * dotAt(surface, at, this.#right) - dy * dotAt(surface, at, this.#up));
    const slope = this.#against(surface, at, this.#aside(at, dx), this.#above(at, dy));
    return slope === 0 ? before : before - off / slope;
  }

  /** Of the normal along a ray that goes x to the right and y up for each mm away from the eye. */
  #against(surface: Float32Array, at: number, x: number, y: number): number {
    const straight = dotAt(surface, at, this.#back);
    if (this.#bent === 0) return straight;
    return straight - x * dotAt(surface, at, this.#right) - y * dotAt(surface, at, this.#up);
  }

  #aside(at: number, dx: number): number {
    const { width, offset } = this.#camera;
    return ((at % width) + dx + offset[0] - width / 2) * this.pixel * this.#bent;
  }

  #above(at: number, dy: number): number {
    const { width, height, offset } = this.#camera;
    return (height / 2 - Math.floor(at / width) - dy - offset[1]) * this.pixel * this.#bent;
  }
}

/** Of a pixel's normal. */
const dotAt = (surface: Float32Array, at: number, [x, y, z]: Vec3): number =>
  surface[4 * at]! * x + surface[4 * at + 1]! * y + surface[4 * at + 2]! * z;
