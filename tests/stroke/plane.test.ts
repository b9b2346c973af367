import { describe, expect, test } from 'vitest';
import { add3, cross3, dot3, length3, rotate3, scale3, sub3 } from '../../src/math/tuple.ts';
import { type Quat, quat, type Vec3 } from '../../src/math/vec.ts';
import { facingPlane, onPlane, project, rayAt, toPlane, toWorld } from '../../src/stroke/plane.ts';
import type { Plane, View } from '../../src/stroke/stroke.ts';
import { normal, random } from '../fixtures/random.ts';

const size = { width: 1024, height: 768 };
const front: View = { pivot: [0, 0, 0], rotation: [0, 0, 0, 1], height: 200, fov: 0 };

function someView(seed: number, fov: number): View {
  const n = normal(seed);
  const rotation = quat.normalize([0, 0, 0, 1], [n(), n(), n(), n()]) as unknown as Quat;
  return { pivot: [20 * n(), 20 * n(), 20 * n()], rotation, height: 50 + 300 * random(seed)(), fov };
}

const near = (a: readonly number[], b: readonly number[], digits = 8) => {
  for (const [i, value] of a.entries()) expect(value).toBeCloseTo(b[i]!, digits);
};

describe.each([0, 20, 45, 90])('opening of %i°', (fov) => {
  for (const seed of [1, 2, 3, 4, 5]) {
    const view = someView(seed, fov);
    const next = random(seed);

    test(`screen → plane → model → screen (seed ${seed})`, () => {
      const plane = facingPlane(view, add3(view.pivot, [3, -2, 5]));
      for (let i = 0; i < 50; i++) {
        const [x, y] = [next() * size.width, next() * size.height];
        const p = onPlane(rayAt(view, size, x, y), plane)!;
        near(project(view, size, toWorld(plane, p))!, [x, y]);
        near(toPlane(plane, toWorld(plane, p)), p);
      }
    });

    test(`model → screen → any plane through the point → model (seed ${seed})`, () => {
      const n = normal(seed);
      for (let i = 0; i < 50; i++) {
        const point = add3(view.pivot, scale3([n(), n(), n()], 0.1 * view.height));
        const turn = quat.normalize([0, 0, 0, 1], [n(), n(), n(), n()]) as unknown as Quat;
        const plane: Plane = {
          origin: point,
          x: rotate3(turn, [1, 0, 0]),
          y: rotate3(turn, [0, 1, 0]),
        };
        const pixel = project(view, size, point);
        if (pixel === null) continue;
        const ray = rayAt(view, size, pixel[0], pixel[1]);
        expect(length3(ray.direction)).toBeCloseTo(1, 12);
        // the ray passes the point
        near(cross3(sub3(point, ray.origin), ray.direction), [0, 0, 0], 7);
        const p = onPlane(ray, plane);
        if (p !== null) near(toWorld(plane, p), point, 5);
      }
    });
  }

  test('the pivot stays in the middle and the visible height there is the height', () => {
    const view = someView(7, fov);
    near(project(view, size, view.pivot)!, [512, 384]);
    const up = rotate3(view.rotation, [0, view.height / 2, 0]);
    near(project(view, size, add3(view.pivot, up))!, [512, 0]);
    near(project(view, size, sub3(view.pivot, up))!, [512, 768]);
  });

  test('a facing plane lies across the line of sight, its axes along the screen, its normal to the eye', () => {
    const view = someView(8, fov);
    const plane = facingPlane(view, view.pivot);
    const ray = rayAt(view, size, 512, 384);
    const normalOfPlane = cross3(plane.x, plane.y);
    near(normalOfPlane, scale3(ray.direction, -1), 9);
    expect(dot3(plane.x, plane.y)).toBeCloseTo(0, 12);
    const centre = project(view, size, view.pivot)!;
    const right = project(view, size, add3(view.pivot, plane.x))!;
    const up = project(view, size, add3(view.pivot, plane.y))!;
    expect(right[0]).toBeGreaterThan(centre[0]);
    expect(right[1]).toBeCloseTo(centre[1], 9);
    expect(up[1]).toBeLessThan(centre[1]);
  });
});

test('y is down on the screen and up in the model; 768 px show 200 mm', () => {
  near(onPlane(rayAt(front, size, 512, 0), facingPlane(front, [0, 0, 0]))!, [0, 100]);
  near(onPlane(rayAt(front, size, 1024, 768), facingPlane(front, [0, 0, 0]))!, [133.333333333, -100]);
});

test('edge-on planes and planes behind give no point', () => {
  const edge: Plane = { origin: [0, 0, 0], x: [1, 0, 0], y: [0, 0, 1] };
  expect(onPlane(rayAt(front, size, 100, 100), edge)).toBeNull();
  const perspective: View = { ...front, fov: 45 };
  const behind = facingPlane(perspective, [0, 0, 1000]);
  expect(onPlane(rayAt(perspective, size, 100, 100), behind)).toBeNull();
  expect(project(perspective, size, [0, 0, 1000] satisfies Vec3)).toBeNull();
  expect(project(front, size, [0, 0, 1000])).not.toBeNull();
});
