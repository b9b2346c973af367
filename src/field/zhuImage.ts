/**
 * Zhu et al.'s rays (zhuMarch.ts) and ours (raycast.ts) onto the same bodies: the picture that theirs show, what each cost, and what one finds
 * and the other does not. A hit is missed where there is none, or it lies more than `APART` pixels behind the other's.
 */
import type { Placement } from '../math/placement.ts';
import { add3, dot3, length3, rotate3, scale3, sub3 } from '../math/tuple.ts';
import type { Quat, Vec3 } from '../math/vec.ts';
import { FieldError } from '../skeleton/skeleton.ts';
import type { FieldNode, SkelsNode } from './node.ts';
import { edgesOf, imageThrough, OFFSETS } from './rayEdges.ts';
import { back, NOWHERE, type RayCamera, type RayImage, rayOf } from './rayImage.ts';
import { emptyImage, SceneCaster, type Standing, viewFrom } from './rayScene.ts';
import { ZhuMarch } from './zhuMarch.ts';

/** pixels */
const APART = 2;

/** What one way of casting did. */
export interface RayCount {
  /** values of one skel at one point, without what was made ready before */
  readonly evaluationsPerPixel: number;
  /** that the other found, or found nearer */
  readonly missed: number;
}

export interface Comparison {
  /** pixels in which either found something */
  readonly hits: number;
  readonly zhu: RayCount;
  /** ours */
  readonly bricks: RayCount;
}

export interface Compared {
  readonly comparison: Comparison;
  /** through the middle of the pixels, and through other places of them where there are edges */
  readonly images: readonly RayImage[];
}

/** The bodies of Zhu et al.: FieldError for all others. */
export function zhuSum(node: FieldNode): SkelsNode {
  const expected = 'Zhu’s rays are for sums of skels without cross sections';
  if (node.type !== 'skels') throw new FieldError(`${expected}, found '${node.type}'`);
  const odd = node.skels.findIndex(({ warp }) => warp);
  if (odd >= 0) throw new FieldError(`skels[${odd}]: ${expected}`);
  return node;
}

/** Ours where they are located, theirs in the same order. Yields what share is done. */
export function* comparing(
  located: readonly Standing[],
  bodies: readonly ZhuBody[],
  camera: RayCamera,
): Generator<number, Compared> {
  const { width, height } = camera;
  const pixels = width * height;
  const before = workOf(located);
  const ours = emptyImage(camera);
  const caster = new SceneCaster(located, camera);
  for (let y = 0; y < height; y++) {
    caster.row(ours, y);
    yield (0.1 * (y + 1)) / height;
  }
  const oursWork = workOf(located) - before;
  const zhu = emptyImage(camera);
  const start = bodies.reduce((sum, { work }) => sum + work, 0);
  for (let y = 0; y < height; y++) {
    for (let x = 0; x < width; x++) castInto(zhu, y * width + x, bodies, camera, x, y);
    yield 0.1 + (0.8 * (y + 1)) / height;
  }
  const zhuWork = bodies.reduce((sum, { work }) => sum + work, 0) - start;
  const { hits, missed } = compared(zhu, ours, (APART * camera.view.height) / height);
  const comparison = {
    hits,
    zhu: { evaluationsPerPixel: zhuWork / pixels, missed: missed.zhu },
    bricks: { evaluationsPerPixel: oursWork / pixels, missed: missed.ours },
  };
  return { comparison, images: yield* smoothed(zhu, bodies, camera) };
}

/** Each pixel of two images of the same bodies; `apart`: mm. */
export function compared(zhu: RayImage, ours: RayImage, apart: number) {
  const missed = { zhu: 0, ours: 0 };
  let hits = 0;
  for (let at = 3; at < zhu.surface.length; at += 4) {
    const [theirs, own] = [zhu.surface[at]!, ours.surface[at]!];
    if (theirs === NOWHERE && own === NOWHERE) continue;
    hits++;
    if (own > theirs + apart) missed.zhu++;
    if (theirs > own + apart) missed.ours++;
  }
  return { hits, missed };
}

function* smoothed(
  base: RayImage,
  bodies: readonly ZhuBody[],
  camera: RayCamera,
): Generator<number, readonly RayImage[]> {
  const edges = edgesOf(base, camera);
  const images = [base];
  for (const offset of OFFSETS) {
    const again = emptyImage({ width: edges.length, height: 1 });
    const through = { ...camera, offset };
    for (const [i, at] of edges.entries()) {
      castInto(again, i, bodies, through, at % camera.width, Math.floor(at / camera.width));
      if (i % 64 === 0) yield 0.9;
    }
    images.push(imageThrough(base, camera, edges, { offset, ...again }));
  }
  return images;
}

const workOf = (bodies: readonly Standing[]): number =>
  [...new Set(bodies.map(({ located }) => located.tally))].reduce((sum, { work }) => sum + work, 0);

function castInto(
  { surface, colours }: RayImage,
  slot: number,
  bodies: readonly ZhuBody[],
  camera: RayCamera,
  x: number,
  y: number,
): void {
  for (const [i, body] of bodies.entries()) {
    const hit = body.cast(camera, x, y);
    if (!hit || hit.before <= surface[4 * slot + 3]!) continue;
    surface.set([...hit.normal, hit.before], 4 * slot);
    colours.set([...hit.colour, i + 1], 4 * slot);
  }
}

interface ZhuHit {
  /** unit, outward, in the model */
  readonly normal: Vec3;
  /** mm before the plane of the pivot */
  readonly before: number;
  readonly colour: Float64Array;
}

/** One body in the model. */
export class ZhuBody {
  readonly #march: ZhuMarch;
  readonly #placement: Placement;
  /** around all that may be inside */
  readonly #middle: Vec3;
  readonly #radius: number;
  readonly #value = new Float64Array(4);
  readonly #colour = new Float64Array(3);
  /** of the last camera */
  #camera: RayCamera | null = null;
  #seen: RayCamera | null = null;

  constructor(node: FieldNode, placement: Placement) {
    this.#march = new ZhuMarch(zhuSum(node));
    this.#placement = placement;
    const { box } = this.#march.field;
    const [min, max] = box ? [box.min, box.max] : [[0, 0, 0] as const, [0, 0, 0] as const];
    this.#middle = scale3(add3(min, max), 0.5);
    this.#radius = box ? 0.5 * length3(sub3(max, min)) : 0;
  }

  /** in values of one skel at one point */
  get work(): number {
    return this.#march.work;
  }

  cast(camera: RayCamera, x: number, y: number): ZhuHit | null {
    const seen = this.#from(camera);
    const { from, along, nearest } = rayOf(seen, x, y);
    const to = sub3(this.#middle, from);
    const middle = dot3(to, along);
    if (dot3(to, to) - middle * middle > this.#radius * this.#radius) return null;
    const t = this.#march.cast(from, along, nearest);
    return t === null ? null : this.#hit(add3(from, scale3(along, t)), seen, this.#placement.rotation);
  }

  #hit(at: Vec3, { view }: RayCamera, rotation: Quat): ZhuHit {
    const { field } = this.#march;
    const value = this.#value;
    field.evaluate(...at, value);
    field.colour(...at, this.#colour);
    const slope: Vec3 = [value[1]!, value[2]!, value[3]!];
    const length = length3(slope);
    return {
      normal: rotate3(rotation, length > 0 ? scale3(slope, -1 / length) : [0, 0, 0]),
      before: dot3(sub3(at, view.pivot), back(view)),
      colour: this.#colour,
    };
  }

  /** As seen from the body, which stays where it was made. */
  #from(camera: RayCamera): RayCamera {
    if (camera !== this.#camera || !this.#seen) {
      this.#camera = camera;
      this.#seen = { ...camera, view: viewFrom(this.#placement, camera.view) };
    }
    return this.#seen;
  }
}
