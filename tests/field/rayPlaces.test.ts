/** Pictures from odd places: an eye in a body, bodies behind it, nothing at all, bodies far apart, and rays that all run the same way. */
import { expect, test } from 'vitest';
import { bindField } from '../../src/field/bind.ts';
import type { FieldNode } from '../../src/field/node.ts';
import { locating } from '../../src/field/polygonize.ts';
import { NOWHERE, type RayCamera } from '../../src/field/rayImage.ts';
import { emptyImage, type OwnImage, SceneCaster, type Standing } from '../../src/field/rayScene.ts';
import { UNMOVED } from '../../src/math/placement.ts';
import type { Vec3 } from '../../src/math/vec.ts';
import { rayAt } from '../../src/stroke/plane.ts';
import { finished } from './finished.ts';
import { body, sphere } from './trees.ts';

const SIZE = 48;
const HALF = SIZE / 2;

const camera = (fov: number, height: number, pivot: Vec3 = [0, 0, 0]): RayCamera => ({
  view: { pivot, rotation: [0, 0, 0, 1], height, fov },
  width: SIZE,
  height: SIZE,
  offset: [0.5, 0.5],
});

const standing = (node: FieldNode, translation: Vec3 = [0, 0, 0]): Standing => ({
  located: finished(locating(bindField(node), 32)),
  placement: { ...UNMOVED, translation },
});

function cast(bodies: readonly Standing[], through: RayCamera): OwnImage {
  const image = emptyImage(through);
  const caster = new SceneCaster(bodies, through);
  for (let y = 0; y < through.height; y++) caster.row(image, y);
  return image;
}

const depthAt = ({ surface }: OwnImage, x: number, y: number): number => surface[4 * (y * SIZE + x) + 3]!;
const hits = ({ surface }: OwnImage): number =>
  surface.filter((value, i) => i % 4 === 3 && value !== NOWHERE).length;

test('an eye in a ball sees its inside in every pixel, with outward normals', () => {
  const through = camera(60, 4);
  const image = cast([standing(sphere(10))], through);
  for (let at = 0; at < SIZE * SIZE; at++) {
    const { origin, direction } = rayAt(
      through.view,
      through,
      (at % SIZE) + 0.5,
      Math.floor(at / SIZE) + 0.5,
    );
    const along = origin[0] * direction[0] + origin[1] * direction[1] + origin[2] * direction[2];
    const beside = origin[0] ** 2 + origin[1] ** 2 + origin[2] ** 2 - 100;
    const t = -along + Math.sqrt(along * along - beside);
    expect(image.surface[4 * at + 3]).toBeCloseTo(origin[2] + t * direction[2], 4);
    for (let axis = 0; axis < 3; axis++) {
      expect(image.surface[4 * at + axis]).toBeCloseTo((origin[axis]! + t * direction[axis]!) / 10, 4);
    }
  }
});

test('an eye in a convolution body sees the field change its sign', () => {
  const node = body([{ skel: { type: 'segment', a: [-8, 0, 0], b: [8, 0, 0], weights: [3, 3] } }]);
  const field = bindField(node);
  const through = camera(50, 0.5);
  const image = cast([standing(node)], through);
  expect(hits(image)).toBe(SIZE * SIZE);
  for (let at = 0; at < SIZE * SIZE; at += 7) {
    const { origin, direction } = rayAt(
      through.view,
      through,
      (at % SIZE) + 0.5,
      Math.floor(at / SIZE) + 0.5,
    );
    const t = (image.surface[4 * at + 3]! - origin[2]) / direction[2];
    const valueAt = (by: number) =>
      field.value(...(direction.map((d, axis) => origin[axis]! + by * d) as unknown as Vec3));
    expect(valueAt(0.999 * t)).toBeGreaterThan(0);
    expect(valueAt(1.001 * t)).toBeLessThan(0);
  }
});

test('what is behind the eye is not seen with an opening, and is without one', () => {
  const behind = [standing(sphere(10), [0, 0, 200])];
  expect(hits(cast(behind, camera(40, 60)))).toBe(0);
  const image = cast(behind, camera(0, 60));
  expect(hits(image)).toBeGreaterThan(0);
  expect(depthAt(image, HALF, HALF)).toBeCloseTo(200 + Math.sqrt(100 - 2 * (0.5 * (60 / SIZE)) ** 2), 3);
});

test('rays that all run the same way are as far apart in front as behind', () => {
  const near = cast([standing(sphere(10), [0, 0, 300])], camera(0, 60));
  const far = cast([standing(sphere(10), [0, 0, -300])], camera(0, 60));
  const pixels = Math.PI * (10 / (60 / SIZE)) ** 2;
  expect(Math.abs(hits(near) - pixels)).toBeLessThan(0.05 * pixels);
  expect(hits(far)).toBe(hits(near));
  for (let at = 0; at < SIZE * SIZE; at++) {
    if (near.surface[4 * at + 3] === NOWHERE) continue;
    expect(near.surface[4 * at + 3]! - far.surface[4 * at + 3]!).toBeCloseTo(600, 3);
  }
});

test('no bodies, and bodies that are nowhere, leave the picture empty', () => {
  expect(hits(cast([], camera(40, 60)))).toBe(0);
  const nothing = body([{ skel: { type: 'point', at: [0, 0, 0], weight: 1e-6 } }]);
  for (const fov of [0, 40]) expect(hits(cast([standing(nothing)], camera(fov, 60)))).toBe(0);
});

test('bodies a million millimetres apart stand where they were put, each as sharp as alone', () => {
  const far = 1e6;
  const bodies = [
    standing(sphere(10)),
    standing(sphere(10), [far, 0, 0]),
    standing(sphere(1e5), [0, 0, -far]),
  ];
  const alone = cast([bodies[0]!], camera(0, 60));
  const there = cast(bodies, camera(0, 60, [far, 0, 0]));
  expect(hits(there)).toBe(hits(alone));
  for (let at = 0; at < SIZE * SIZE; at++) {
    const [one, other] = [alone.surface[4 * at + 3]!, there.surface[4 * at + 3]!];
    expect(other === NOWHERE).toBe(one === NOWHERE);
    if (one !== NOWHERE) expect(other).toBeCloseTo(one, 3);
  }
  // all of them, from afar: the large one fills the middle, the small ones are less than a pixel
  const all = cast(bodies, camera(0, 3e6));
  expect(hits(all)).toBeGreaterThan(4);
  expect(depthAt(all, HALF + 1, HALF)).toBeCloseTo(
    -far + Math.sqrt(1e10 - (62500 * 1.5) ** 2 - 31250 ** 2),
    -2,
  );
});
