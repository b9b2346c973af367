/**
 * Several bodies, each where it was put, in one image of rays: in each pixel the nearest. A body is only asked where it may be seen: in the
 * part of the picture that its lattice covers, and before what is already there.
 */
import { type Placement, UNMOVED } from '../math/placement.ts';
import { dot3, rotate3, sub3, unrotate3 } from '../math/tuple.ts';
import type { Quat, Vec3 } from '../math/vec.ts';
import { project } from '../stroke/plane.ts';
import type { View } from '../stroke/stroke.ts';
import type { Lattice } from './lattice.ts';
import type { Located } from './polygonize.ts';
import { type Ray, Raycaster } from './raycast.ts';
import { back, NOWHERE, type RayCamera, type RayImage, rayOf } from './rayImage.ts';

/** A body in the model. */
export interface Standing {
  readonly located: Pick<Located, 'whole' | 'tally' | 'bricks'>;
  readonly placement: Placement;
}

/** Pixels, from … to below …. */
export interface Frame {
  readonly left: number;
  readonly right: number;
  readonly top: number;
  readonly bottom: number;
}

/** Whose arrays may be handed over. */
export interface OwnImage extends RayImage {
  readonly surface: Float32Array<ArrayBuffer>;
  readonly colours: Float32Array<ArrayBuffer>;
  readonly passed: Uint8Array<ArrayBuffer>;
}

/** Nothing anywhere. */
export function emptyImage({ width, height }: Pick<RayCamera, 'width' | 'height'>): OwnImage {
  const surface = new Float32Array(4 * width * height);
  for (let at = 3; at < surface.length; at += 4) surface[at] = NOWHERE;
  const colours = new Float32Array(4 * width * height);
  return { width, height, surface, colours, passed: new Uint8Array(width * height) };
}

/** Casts for one camera. The last of a pixel's colours is 1 + the place of the body in the list. */
export class SceneCaster {
  readonly #bodies: readonly BodyCaster[];

  constructor(bodies: readonly Standing[], camera: RayCamera) {
    this.#bodies = bodies.map((body, i) => new BodyCaster(body, camera, i + 1));
  }

  /** The rows in which there may be anything: from … to below …. */
  get rows(): readonly [from: number, to: number] {
    const frames = this.#bodies.map(({ frame }) => frame).filter(({ left, right }) => left < right);
    if (frames.length === 0) return [0, 0];
    return [Math.min(...frames.map(({ top }) => top)), Math.max(...frames.map(({ bottom }) => bottom))];
  }

  /** The pixels of row `y`, written into that row of `image`, or into row `at`, where nothing is yet. */
  row(image: RayImage, y: number, at = y): void {
    for (const body of this.#bodies) {
      const { left, right, top, bottom } = body.frame;
      if (y < top || y >= bottom) continue;
      for (let x = left; x < right; x++) body.cast(image, 4 * (at * image.width + x), x, y);
    }
  }

  /** One pixel, written into the place `slot` of an image. */
  pixel(image: RayImage, slot: number, x: number, y: number): void {
    for (const body of this.#bodies) {
      const { left, right, top, bottom } = body.frame;
      if (x >= left && x < right && y >= top && y < bottom) body.cast(image, 4 * slot, x, y);
    }
  }
}

/** One body where it was made, with all rays; yields what share is done. The work is in the tally of what was located. Twin of shaders/raycast. */
export function* raycasting(located: Standing['located'], camera: RayCamera): Generator<number, OwnImage> {
  const image = emptyImage(camera);
  const caster = new SceneCaster([{ located, placement: UNMOVED }], camera);
  for (let y = 0; y < camera.height; y++) {
    caster.row(image, y);
    yield (y + 1) / camera.height;
  }
  return image;
}

class BodyCaster {
  readonly frame: Frame;
  readonly #caster: Raycaster;
  /** as seen from the body, which stays where it was made */
  readonly #camera: RayCamera;
  readonly #rotation: Quat;
  readonly #back: Vec3;
  readonly #number: number;

  constructor({ located, placement }: Standing, camera: RayCamera, number: number) {
    this.#caster = new Raycaster(located);
    this.#camera = { ...camera, view: viewFrom(placement, camera.view) };
    this.#rotation = placement.rotation;
    this.#back = back(this.#camera.view);
    this.#number = number;
    this.frame = frameOf(located.bricks.lattice, this.#camera);
  }

  /** Writes what is nearer than what is there. */
  cast({ surface, colours, passed }: RayImage, at: number, x: number, y: number): void {
    const ray = rayOf(this.#camera, x, y);
    const caster = this.#caster;
    const isHit = caster.cast(ray, this.#reach(ray, surface[at + 3]!));
    if (passed && caster.passed) passed[at / 4] = 1;
    if (!isHit) return;
    const { normal, colour, at: place } = caster.hit;
    const before = dot3(sub3(place, this.#camera.view.pivot), this.#back);
    if (before <= surface[at + 3]!) return;
    surface.set(rotate3(this.#rotation, normal), at);
    surface[at + 3] = before;
    colours.set(colour, at);
    colours[at + 3] = this.#number;
  }

  /** How far along the ray it is to `before` mm before the plane of the pivot. */
  #reach({ from, along }: Ray, before: number): number {
    if (before === NOWHERE) return Infinity;
    return (before - dot3(sub3(from, this.#camera.view.pivot), this.#back)) / dot3(along, this.#back);
  }
}

/** How a body that was put somewhere is seen, from where it was made. */
export function viewFrom({ rotation, translation }: Placement, view: View): View {
  const [x, y, z, w] = rotation;
  return {
    ...view,
    pivot: unrotate3(rotation, sub3(view.pivot, translation)),
    rotation: times([-x, -y, -z, w], view.rotation),
  };
}

const times = ([ax, ay, az, aw]: Quat, [bx, by, bz, bw]: Quat): Quat => [
  aw * bx + ax * bw + ay * bz - az * by,
  aw * by - ax * bz + ay * bw + az * bx,
  aw * bz + ax * by - ay * bx + az * bw,
  aw * bw - ax * bx - ay * by - az * bz,
];

/** Where a lattice may be seen: all of the picture where a corner of it is behind the eye. */
export function frameOf({ origin, counts, step }: Lattice, camera: RayCamera): Frame {
  const { width, height } = camera;
  const corners = [0, 1, 2, 3, 4, 5, 6, 7].map((corner): Vec3 => {
    const side = (axis: 0 | 1 | 2) => origin[axis] + ((corner >> axis) & 1) * (counts[axis] - 1) * step;
    return [side(0), side(1), side(2)];
  });
  const seen = corners.map((corner) => project(camera.view, camera, corner));
  if (seen.some((place) => place === null)) return { left: 0, right: width, top: 0, bottom: height };
  const places = seen.filter((place) => place !== null);
  const [xs, ys] = [places.map(([x]) => x), places.map(([, y]) => y)];
  const within = (value: number, most: number) => Math.min(Math.max(value, 0), most);
  return {
    left: within(Math.floor(Math.min(...xs)), width),
    right: within(Math.ceil(Math.max(...xs)), width),
    top: within(Math.floor(Math.min(...ys)), height),
    bottom: within(Math.ceil(Math.max(...ys)), height),
  };
}
