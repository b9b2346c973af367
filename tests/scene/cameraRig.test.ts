import fc from 'fast-check';
import { beforeAll, beforeEach, describe, expect, it, vi } from 'vitest';
import { type Quat, quat, vec3 } from '../../src/math/vec.ts';
import { CameraRig } from '../../src/scene/cameraRig.ts';
import { axes, FRONT_VIEW } from '../../src/scene/view.ts';
import type { View } from '../../src/stroke/stroke.ts';

let rig: CameraRig;

// camera-controls keeps rectangles of the page it is never connected to.
beforeAll(() => vi.stubGlobal('DOMRect', class {}));

beforeEach(() => {
  rig = new CameraRig();
  rig.resize(800, 600);
  rig.setBounds({ centre: [0, 0, 0], radius: 80 });
});

const angle = fc.double({ min: -180, max: 180, noNaN: true });
const aRotation = fc
  .tuple(angle, angle, angle)
  .map(([x, y, z]) => quat.fromEuler([0, 0, 0, 1], x, y, z) as unknown as Quat);

/** Largest difference of two views: mm, and 1 − |cos| of half the angle. */
function difference(a: View, b: View): number {
  return Math.max(
    vec3.distance(a.pivot, b.pivot),
    Math.abs(a.height - b.height),
    1 - Math.abs(quat.dot(a.rotation, b.rotation)),
  );
}

describe('the camera rig', () => {
  it('starts at the front, 200 mm high, orthographic', () => {
    expect(rig.view()).toEqual(FRONT_VIEW);
  });

  it('comes back to any view that is set, also upside down and straight from above', () => {
    const poles: Quat[] = [
      [-Math.SQRT1_2, 0, 0, Math.SQRT1_2],
      [0, 0, 1, 0],
    ];
    fc.assert(
      fc.property(fc.oneof(aRotation, fc.constantFrom(...poles)), fc.constantFrom(0, 30), (rotation, fov) => {
        const view: View = { pivot: [3, -4, 5], rotation, height: 120, fov };
        rig.setView(view, false);
        expect(difference(rig.view(), view)).toBeLessThan(1e-12);
        // a hand that does not move anything must not turn the camera either
        rig.orbit(0, 0);
        expect(difference(rig.view(), view)).toBeLessThan(1e-5);
      }),
    );
  });

  it('ends a move exactly where it was told, whatever the frames', () => {
    const to: View = {
      pivot: [1, 2, 3],
      rotation: quat.fromEuler([0, 0, 0, 1], 20, 130, 40) as unknown as Quat,
      height: 90,
      fov: 0,
    };
    for (const step of [1 / 120, 1 / 60, 0.05, 1]) {
      rig.setView(FRONT_VIEW, false);
      rig.setView(to, true);
      let frames = 0;
      while (rig.update(step)) frames++;
      expect(frames).toBeLessThanOrEqual(Math.ceil(0.36 / step));
      expect(difference(rig.view(), to)).toBeLessThan(1e-12);
    }
    expect(rig.update(1)).toBe(false);
  });

  it('cuts when motion is reduced', () => {
    rig.reducedMotion = true;
    rig.face('left', true);
    expect(rig.moving).toBe(false);
    expect(axes(rig.view().rotation)[2][0]).toBeCloseTo(-1, 12);
  });

  it('turns the form to the right when dragged to the right', () => {
    rig.orbit(75, 0);
    // an eighth of the height = an eighth of a turn; the camera goes to the left
    const [, , back] = axes(rig.view().rotation);
    expect(back[0]).toBeCloseTo(-Math.SQRT1_2, 6);
    expect(back[2]).toBeCloseTo(Math.SQRT1_2, 6);
  });

  it('pans with the finger, pixel by pixel', () => {
    rig.pan(60, 30);
    const { pivot } = rig.view();
    expect(vec3.distance(pivot, [-20, 10, 0])).toBeLessThan(1e-9);
  });

  it('zooms towards the pointer', () => {
    // 300 px right of the middle lies x = 100 mm
    rig.zoom(2, 700, 300);
    const { pivot, height } = rig.view();
    expect(height).toBeCloseTo(100, 9);
    // still under the pointer: 300 px are 50 mm now
    expect(pivot[0]).toBeCloseTo(50, 9);
  });

  it('rolls the picture about its middle and then turns about the new up', () => {
    rig.roll(Math.PI / 6);
    const [right, , back] = axes(rig.view().rotation);
    expect(back[2]).toBeCloseTo(1, 9);
    // The picture turns counter-clockwise, so the camera's right points down in the world.
    expect(right[0]).toBeCloseTo(Math.cos(Math.PI / 6), 9);
    expect(right[1]).toBeCloseTo(-0.5, 9);
    rig.roll(-Math.PI / 6);
    expect(difference(rig.view(), FRONT_VIEW)).toBeLessThan(1e-9);
  });

  it('keeps the framing when the projection changes', () => {
    rig.orbit(40, 20);
    const before = rig.view();
    rig.setPerspective(true);
    expect(rig.view().fov).toBe(30);
    expect(difference(rig.view(), before)).toBeLessThan(1e-9);
    rig.setPerspective(false);
    expect(rig.view().fov).toBe(0);
    expect(difference(rig.view(), before)).toBeLessThan(1e-9);
  });

  it('never loses the form, however it is panned and zoomed', () => {
    const hand = fc.record({
      dx: fc.integer({ min: -3000, max: 3000 }),
      dy: fc.integer({ min: -3000, max: 3000 }),
      factor: fc.double({ min: 0.001, max: 1000, noNaN: true }),
    });
    fc.assert(
      fc.property(fc.array(hand, { maxLength: 6 }), (hands) => {
        rig.reset(false);
        for (const { dx, dy, factor } of hands) {
          rig.pan(dx, dy);
          rig.zoom(factor, 100, 500);
          rig.orbit(dx, dy);
        }
        const { pivot, height, rotation } = rig.view();
        const [right, up] = axes(rotation);
        expect(Math.abs(vec3.dot(pivot, right))).toBeLessThan((height * 4) / 6 + 80);
        expect(Math.abs(vec3.dot(pivot, up))).toBeLessThan(height / 2 + 80);
        expect(height).toBeLessThanOrEqual(6400);
      }),
    );
  });

  it('clips nothing: near and far enclose the form and the pivot', () => {
    rig.setBounds({ centre: [0, 0, 50], radius: 400 });
    for (const perspective of [false, true]) {
      rig.setPerspective(perspective);
      const { camera } = rig;
      const distance = 50 - camera.position.z;
      expect(camera.far).toBeGreaterThanOrEqual(-distance + 400);
      if (!perspective) expect(camera.near).toBeLessThanOrEqual(-distance - 400);
      else expect(camera.near).toBeGreaterThan(0);
    }
  });

  it('fits a box and goes in steps of 15°', () => {
    rig.fit({ min: [10, 10, -5], max: [50, 30, 5] }, false);
    expect(rig.view().pivot).toEqual([30, 20, 0]);
    // 40 mm wide on a screen of 4 : 3, filling 80 %
    expect(rig.view().height).toBeCloseTo(40 / (4 / 3) / 0.8, 9);
    rig.orbitStep(1, 0, true);
    rig.orbitStep(1, 0, true);
    while (rig.update(1 / 60));
    const [, , back] = axes(rig.view().rotation);
    expect(Math.atan2(back[0], back[2])).toBeCloseTo(-Math.PI / 6, 6);
  });
});
