/** Meshes of 256 cells and rays show the same: they differ within a pixel of silhouettes only, in place and colour. */
import { describe, expect, test } from 'vitest';
import { bindField } from '../../src/field/bind.ts';
import type { FieldMesh } from '../../src/field/brickMesh.ts';
import type { FieldNode } from '../../src/field/node.ts';
import { type Located, locating, meshing } from '../../src/field/polygonize.ts';
import { back, NOWHERE, type RayCamera, rayOf } from '../../src/field/rayImage.ts';
import { type OwnImage, raycasting } from '../../src/field/rayScene.ts';
import { dot3, length3, rotate3, scale3, sub3 } from '../../src/math/tuple.ts';
import type { Quat, Vec3 } from '../../src/math/vec.ts';
import { eyeDistance } from '../../src/stroke/plane.ts';
import { sceneNode } from '../bench/scenes/index.ts';
import { carvedTree } from '../bench/scenes/trees.ts';
import { finished } from './finished.ts';
import { set, shape } from './meshes.ts';
import { type Raster, rasterized } from './rasterized.ts';
import { body, placed } from './trees.ts';

const CELLS = 256;
const PIXELS = 96;
/** pixels: how far a neighbour lies from the plane that touches the surface, seen from either, where one hides the other */
const HIDDEN = 3;
/** pixels across the surface; chords of a cell, about half a pixel, are nearer by far */
const OFF = 0.1;
const UNLIKE = 0.03;
/** of pixels that are compared: where colours change within less than a cell */
const SPOTS = 0.01;

const VIEWS: readonly (readonly [Quat, number])[] = [
  [[0.1, 0.2, 0, 0.9746794], 30],
  [[0.3, -0.5, 0.1, 0.8062258], 0],
  [[-0.5, 0.5, 0.5, 0.5], 45],
];

const bone = (x: number, colour: Vec3) => ({
  skel: { type: 'segment', a: [x, -4, 0], b: [2 * x, 5, 1], weights: [2, 1] } as const,
  colour,
});

const SCENES: readonly (readonly [string, FieldNode])[] = [
  ['64 segments', sceneNode('tree64')],
  ['carved', carvedTree()],
  ['two bones in two colours', body([bone(1.5, [1, 0, 0]), bone(-1.5, [0, 0, 1])])],
  ['bones and a plate', body()],
  [
    'a box less a ball',
    set(
      'subtraction',
      'hard',
      { type: 'shape', shape: { type: 'box', half: [6, 5, 4] }, colour: [0.8, 0.2, 0.1] },
      placed({ type: 'shape', shape: { type: 'sphere', radius: 4 }, colour: [0.1, 0.2, 0.8] }, 5, 4, 3),
    ),
  ],
  [
    'a ring and a capsule, smooth',
    set('union', 'smooth', shape({ type: 'torus', ring: 8, tube: 2 }), {
      ...shape({ type: 'capsule', radius: 3, half: 7 }),
    }),
  ],
];

interface Seen {
  readonly image: OwnImage;
  readonly raster: Raster;
  readonly camera: RayCamera;
}

function seen(located: Located, mesh: FieldMesh, [rotation, fov]: readonly [Quat, number]): Seen {
  const { min, max } = located.box;
  const camera: RayCamera = {
    view: {
      pivot: scale3([min[0] + max[0], min[1] + max[1], min[2] + max[2]], 0.5),
      rotation: scaled(rotation),
      height: 0.8 * length3(sub3(max, min)),
      fov,
    },
    width: PIXELS,
    height: PIXELS,
    offset: [0.5, 0.5],
  };
  return { image: finished(raycasting(located, camera)), raster: rasterized(mesh, camera), camera };
}

function scaled([x, y, z, w]: Quat): Quat {
  const size = Math.hypot(x, y, z, w);
  return [x / size, y / size, z / size, w / size];
}

/** What the picture says of a pixel: its place, its normal, the ray through it. */
class Pixels {
  readonly #seen: Seen;
  constructor(seen: Seen) {
    this.#seen = seen;
  }

  depth(at: number): number {
    return this.#seen.image.surface[4 * at + 3]!;
  }

  facing(at: number): number {
    return -dot3(this.#normal(at), this.#ray(at));
  }

  /** mm before the pivot at which the ray of `other` meets the plane of `at`. */
  plane(at: number, other: number): number {
    const { camera } = this.#seen;
    const normal = this.#normal(at);
    const { view } = camera;
    const through = (pixel: number, depth: number): Vec3 => {
      const ray = rayOf(camera, pixel % PIXELS, Math.floor(pixel / PIXELS));
      const front = back(view);
      const t = (depth - dot3(sub3(ray.from, view.pivot), front)) / dot3(ray.along, front);
      return [0, 1, 2].map((axis) => ray.from[axis]! + t * ray.along[axis]!) as unknown as Vec3;
    };
    const here = through(at, this.depth(at));
    const beside = through(other, this.depth(at));
    const ray = this.#ray(other);
    const t = dot3(normal, sub3(here, beside)) / dot3(normal, ray);
    return this.depth(at) + t * dot3(ray, back(view));
  }

  #normal(at: number): Vec3 {
    const { surface } = this.#seen.image;
    return [surface[4 * at]!, surface[4 * at + 1]!, surface[4 * at + 2]!];
  }

  #ray(at: number): Vec3 {
    const { camera } = this.#seen;
    if (eyeDistance(camera.view) === null) return rotate3(camera.view.rotation, [0, 0, -1]);
    return rayOf(camera, at % PIXELS, Math.floor(at / PIXELS)).along;
  }
}

/** Pixels with a silhouette in them or beside. */
function silhouettes(pixels: Pixels, pixel: number): Uint8Array {
  const found = new Uint8Array(PIXELS * PIXELS);
  const isApart = (a: number, b: number) => {
    const isHit = pixels.depth(a) !== NOWHERE;
    if (isHit !== (pixels.depth(b) !== NOWHERE)) return true;
    if (!isHit) return false;
    const offs = [pixels.plane(a, b) - pixels.depth(b), pixels.plane(b, a) - pixels.depth(a)];
    return Math.min(...offs.map(Math.abs)) > HIDDEN * pixel;
  };
  const mark = (a: number, b: number) => {
    if (isApart(a, b)) for (const at of [a, b]) found[at] = 1;
  };
  for (let y = 0; y < PIXELS; y++) {
    for (let x = 0; x < PIXELS; x++) {
      const at = y * PIXELS + x;
      if (x + 1 < PIXELS) mark(at, at + 1);
      if (y + 1 < PIXELS) mark(at, at + PIXELS);
      if (x + 1 < PIXELS && y + 1 < PIXELS) mark(at, at + PIXELS + 1);
      if (x > 0 && y + 1 < PIXELS) mark(at, at + PIXELS - 1);
    }
  }
  return found;
}

describe.each(SCENES)('%s', (_, node) => {
  const located = finished(locating(bindField(node), CELLS));
  const { mesh } = finished(meshing(located));

  test.each(VIEWS)(
    'seen from %j, opening %d°',
    (...view) => {
      const both = seen(located, mesh, view);
      const pixel = both.camera.view.height / PIXELS;
      const pixels = new Pixels(both);
      const silhouette = silhouettes(pixels, pixel);
      const { depth, colours } = both.raster;
      let [compared, unlike] = [0, 0];
      for (let at = 0; at < PIXELS * PIXELS; at++) {
        if (silhouette[at] === 1) continue;
        const place = `pixel ${at % PIXELS}, ${Math.floor(at / PIXELS)}`;
        expect(depth[at] !== NOWHERE, place).toBe(pixels.depth(at) !== NOWHERE);
        if (depth[at] === NOWHERE) continue;
        compared++;
        expect((Math.abs(depth[at]! - pixels.depth(at)) * pixels.facing(at)) / pixel, place).toBeLessThan(
          OFF,
        );
        const apart = [0, 1, 2].map((c) => Math.abs(colours[3 * at + c]! - both.image.colours[4 * at + c]!));
        if (Math.max(...apart) > UNLIKE) unlike++;
      }
      // else nothing has been compared
      expect(compared).toBeGreaterThan(300);
      expect(unlike).toBeLessThanOrEqual(SPOTS * compared);
    },
    60_000,
  );
});
