/** Bodies in one image: each as if it were alone, the nearer before the farther, where they were put. */
import { describe, expect, it } from 'vitest';
import { bindField } from '../../src/field/bind.ts';
import type { FieldNode } from '../../src/field/node.ts';
import { locating } from '../../src/field/polygonize.ts';
import { NOWHERE, type RayCamera, type RayImage } from '../../src/field/rayImage.ts';
import { emptyImage, SceneCaster, type Standing } from '../../src/field/rayScene.ts';
import type { Placement } from '../../src/math/placement.ts';
import { length3, sub3 } from '../../src/math/tuple.ts';
import type { Vec3 } from '../../src/math/vec.ts';
import { rayAt } from '../../src/stroke/plane.ts';
import { finished } from './finished.ts';

const RADIUS = 10;
const BALL: FieldNode = { type: 'shape', shape: { type: 'sphere', radius: RADIUS }, colour: [1, 0, 0] };
const located = finished(locating(bindField(BALL), 24));
const put = (translation: Vec3): Placement => ({
  rotation: [0.5, 0.5, 0.5, 0.5],
  translation,
});

const CENTRES: readonly Vec3[] = [
  [-6, 0, -8],
  [6, 3, 12],
];
const BODIES: readonly Standing[] = CENTRES.map((centre) => ({ located, placement: put(centre) }));

const camera = (fov: number): RayCamera => ({
  view: { pivot: [1, 2, 3], rotation: [0, Math.sin(0.2), 0, Math.cos(0.2)], height: 60, fov },
  width: 80,
  height: 60,
  offset: [0.5, 0.5],
});

function cast(bodies: readonly Standing[], through: RayCamera): RayImage {
  const image = emptyImage(through);
  const caster = new SceneCaster(bodies, through);
  for (let y = 0; y < through.height; y++) caster.row(image, y);
  return image;
}

/** Of the ray from `from` along a unit vector, mm to the ball; Infinity where it passes. */
function toBall(from: Vec3, along: Vec3, centre: Vec3): number {
  const to = sub3(centre, from);
  const middle = to[0] * along[0] + to[1] * along[1] + to[2] * along[2];
  const off = RADIUS ** 2 - (length3(to) ** 2 - middle ** 2);
  return off > 0 ? middle - Math.sqrt(off) : Infinity;
}

describe.each([0, 35])('opening %d°', (fov) => {
  const through = camera(fov);
  const image = cast(BODIES, through);

  it('shows the nearer of two balls, where they are, with the normals they have', () => {
    let seen = 0;
    for (let y = 0; y < 60; y++) {
      for (let x = 0; x < 80; x++) {
        const { origin, direction } = rayAt(through.view, through, x + 0.5, y + 0.5);
        const ways = CENTRES.map((centre) => toBall(origin, direction, centre));
        const nearest = Math.min(...ways);
        const at = 4 * (y * 80 + x);
        if (nearest === Infinity) {
          expect(image.surface[at + 3]).toBe(NOWHERE);
          expect(image.colours[at + 3]).toBe(0);
          continue;
        }
        const which = ways.indexOf(nearest);
        const place = direction.map((d, axis) => origin[axis]! + nearest * d) as unknown as Vec3;
        const normal = sub3(place, CENTRES[which]!).map((value) => value / RADIUS);
        const back = [Math.sin(0.4), 0, Math.cos(0.4)];
        const before = sub3(place, through.view.pivot).reduce(
          (sum, value, axis) => sum + value * back[axis]!,
          0,
        );
        expect(image.colours[at + 3]).toBe(which + 1);
        expect(image.surface[at + 3]).toBeCloseTo(before, 2);
        for (let axis = 0; axis < 3; axis++) expect(image.surface[at + axis]).toBeCloseTo(normal[axis]!, 2);
        seen++;
      }
    }
    expect(seen).toBeGreaterThan(200);
  });

  it('gives the same for rows, for single pixels and in another order', () => {
    const other = cast([...BODIES].reverse(), through);
    expect(other.surface).toEqual(image.surface);
    const caster = new SceneCaster(BODIES, through);
    const one = emptyImage({ width: 80 * 60, height: 1 });
    for (let at = 0; at < 80 * 60; at++) caster.pixel(one, at, at % 80, Math.floor(at / 80));
    expect(one.surface).toEqual(image.surface);
  });

  it('has rows for all that is seen', () => {
    const [from, to] = new SceneCaster(BODIES, through).rows;
    for (let at = 0; at < 80 * 60; at++) {
      if (image.surface[4 * at + 3] === NOWHERE) continue;
      expect(Math.floor(at / 80)).toBeGreaterThanOrEqual(from);
      expect(Math.floor(at / 80)).toBeLessThan(to);
    }
  });
});

it('has no rows where nothing is in the picture', () => {
  const away = { ...camera(0), view: { ...camera(0).view, pivot: [0, 500, 0] as const } };
  const [from, to] = new SceneCaster(BODIES, away).rows;
  expect(from).toBe(to);
});
