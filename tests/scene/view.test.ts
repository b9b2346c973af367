import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { type Quat, quat, type Vec3, vec3 } from '../../src/math/vec.ts';
import { distances } from '../../src/scene/grid.ts';
import {
  axes,
  between,
  ease,
  FACE_ROTATION,
  type Face,
  FRONT_VIEW,
  fitted,
  heightLimits,
  holds,
  kept,
} from '../../src/scene/view.ts';
import type { View } from '../../src/stroke/stroke.ts';

const coordinate = fc.double({ min: -500, max: 500, noNaN: true });
const point = fc.tuple(coordinate, coordinate, coordinate);
const rotation = fc
  .tuple(coordinate, coordinate, coordinate)
  .map(([x, y, z]) => quat.fromEuler([0, 0, 0, 1], x, y, z) as unknown as Quat);
const aView = fc.record({
  pivot: point,
  rotation,
  height: fc.double({ min: 1, max: 2000, noNaN: true }),
  fov: fc.constantFrom(0, 30),
});

/** Place on the screen: −1 to 1 is visible. */
function screen(view: View, aspect: number, at: Vec3): readonly [number, number] {
  const [right, up, back] = axes(view.rotation);
  const away = vec3.subtract([0, 0, 0], at, view.pivot) as unknown as Vec3;
  const slope = Math.tan((view.fov * Math.PI) / 360);
  const half = view.height / 2 - slope * vec3.dot(away, back);
  return [vec3.dot(away, right) / (half * aspect), vec3.dot(away, up) / half];
}

describe('faces', () => {
  const seen: Record<Face, Vec3> = {
    front: [0, 0, 1],
    back: [0, 0, -1],
    right: [1, 0, 0],
    left: [-1, 0, 0],
    top: [0, 1, 0],
    bottom: [0, -1, 0],
  };
  it.each(Object.entries(seen))('%s looks from there', (face, from) => {
    const [right, , back] = axes(FACE_ROTATION[face as Face]);
    expect(vec3.distance(back, from)).toBeLessThan(1e-12);
    expect(right[1]).toBeCloseTo(0, 12);
  });
});

describe('ease', () => {
  it('goes from 0 to 1, slowly at both ends, and never back', () => {
    expect(ease(0)).toBe(0);
    expect(ease(1)).toBe(1);
    expect(ease(0.05)).toBeLessThan(0.01);
    expect(ease(0.95)).toBeGreaterThan(0.99);
    // x(t) = ½ at t = .640, where y(t) = 3 (1 − t) t² + t³
    expect(ease(0.5)).toBeCloseTo(0.7047, 3);
    for (let t = 0; t < 1; t += 0.01) expect(ease(t + 0.01)).toBeGreaterThanOrEqual(ease(t));
  });
});

describe('between', () => {
  it('gives its ends to the bit', () => {
    fc.assert(
      fc.property(aView, aView, (from, to) => {
        expect(between(from, to, 0)).toBe(from);
        expect(between(from, to, 1)).toBe(to);
      }),
    );
  });
});

describe('fitted', () => {
  it('shows the whole box and wastes no space', () => {
    fc.assert(
      fc.property(aView, point, point, fc.constantFrom(0.5, 1, 1.6), (view, a, b, aspect) => {
        const min = vec3.min([0, 0, 0], a, b) as unknown as Vec3;
        const max = vec3.max([0, 0, 0], a, b) as unknown as Vec3;
        fc.pre(vec3.distance(min, max) > 1e-3);
        const shown = fitted(view, { min, max }, aspect);
        let most = 0;
        for (const x of [min[0], max[0]])
          for (const y of [min[1], max[1]])
            for (const z of [min[2], max[2]])
              most = Math.max(most, ...screen(shown, aspect, [x, y, z]).map(Math.abs));
        expect(most).toBeLessThanOrEqual(0.801);
        // A corner touches the margin, unless the box is seen edge-on.
        if (slimness(view, min, max, aspect) > 0.1) expect(most).toBeGreaterThan(0.79);
      }),
    );
  });
});

describe('holds', () => {
  const box = { min: [-20, -10, -5], max: [40, 30, 8] } as const;
  const corners = [0, 1, 2, 3, 4, 5, 6, 7].flatMap((i) =>
    [0, 1, 2].map((k) => ((i >> k) & 1 ? box.max : box.min)[k]!),
  );
  const margins = { left: 0.05, top: 0.12, right: 0.3, bottom: 0.14 };
  const wider = { left: 0.04, top: 0.11, right: 0.29, bottom: 0.13 };

  it('what was fitted, and nothing larger than that', () => {
    fc.assert(
      fc.property(aView, fc.constantFrom(0.5, 1, 1.6), (view, aspect) => {
        // in perspective unequal margins are kept at the pivot's depth only
        const shown = fitted({ ...view, fov: 0 }, box, aspect, margins);
        expect(holds(shown, corners, aspect, wider)).toBe(true);
        expect(holds({ ...shown, height: shown.height / 3 }, corners, aspect, margins)).toBe(false);
      }),
    );
  });

  it('nothing behind the eye', () => {
    const view = { pivot: [0, 0, 0], rotation: [0, 0, 0, 1], height: 10, fov: 30 } as const;
    const air = { left: 0, top: 0, right: 0, bottom: 0 };
    expect(holds(view, [0, 0, 10], 1, air)).toBe(true);
    expect(holds(view, [0, 0, 30], 1, air)).toBe(false);
  });
});

/** The lesser extent of a box on the screen, in parts of its diagonal. */
function slimness(view: View, min: Vec3, max: Vec3, aspect: number): number {
  const [right, up] = axes(view.rotation);
  const size = vec3.subtract([0, 0, 0], max, min);
  const extent = (axis: Vec3) => axis.reduce((sum, value, i) => sum + Math.abs(value * (size[i] ?? 0)), 0);
  return Math.min(extent(right) / aspect, extent(up)) / vec3.length(size);
}

describe('kept', () => {
  it('leaves a part of the sphere on the screen, and the height within limits', () => {
    const ball = fc.record({ centre: point, radius: fc.double({ min: 0.1, max: 300, noNaN: true }) });
    fc.assert(
      fc.property(aView, ball, fc.constantFrom(0.5, 1.6), (view, form, aspect) => {
        const view1 = kept(view, form, aspect);
        const [least, most] = heightLimits(form);
        expect(view1.height).toBeGreaterThanOrEqual(least);
        expect(view1.height).toBeLessThanOrEqual(most);
        const [right, up] = axes(view1.rotation);
        const away = vec3.subtract([0, 0, 0], form.centre, view1.pivot) as unknown as Vec3;
        expect(Math.abs(vec3.dot(away, right))).toBeLessThan((view1.height / 2) * aspect + form.radius);
        expect(Math.abs(vec3.dot(away, up))).toBeLessThan(view1.height / 2 + form.radius);
      }),
    );
  });

  it('changes nothing about an ordinary view', () => {
    expect(kept(FRONT_VIEW, { centre: [0, 0, 0], radius: 60 }, 1.5)).toEqual(FRONT_VIEW);
    expect(kept(FRONT_VIEW, null, 1.5)).toEqual(FRONT_VIEW);
  });
});

describe('grid', () => {
  it('takes the nearest of 1, 5, 10, 50, … above the least distance', () => {
    expect(distances(0.7)).toEqual([1, 5]);
    expect(distances(1.2)).toEqual([5, 10]);
    expect(distances(5)).toEqual([5, 10]);
    expect(distances(7)).toEqual([10, 50]);
    expect(distances(24)).toEqual([50, 100]);
  });
});
