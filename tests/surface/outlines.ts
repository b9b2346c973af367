/** Sections known in closed form, shared by the tests of this folder. */
import type { Vec2 } from '../../src/math/vec.ts';
import { functionCurve, polylineCurve } from '../../src/stroke/arcLength.ts';
import { type Outline, outlineOf } from '../../src/surface/outline.ts';

const AS_DRAWN = { reversed: false, across: false } as const;

/** A polyline in the section's own plane, y out of the drawing plane; snapped at its ends. */
export function bent(...points: Vec2[]): Outline {
  return outlineOf(polylineCurve(points, false), AS_DRAWN);
}

/** A smooth function of t in [0, 1] in the section's own plane. */
export function smooth(f: (t: number) => Vec2): Outline {
  return outlineOf(functionCurve(f, false), AS_DRAWN);
}

/** y times k */
export function raisedBy(outline: Outline, k: number): Outline {
  const up = ([x, y]: Vec2): Vec2 => [x, k * y];
  return {
    ...outline,
    point: (v) => up(outline.point(v)),
    derivative: (v, side) => up(outline.derivative(v, side)),
  };
}

export const wave = (height: number, waves: number): Outline =>
  smooth((t) => [2 * t - 1, height * Math.sin(waves * Math.PI * t)]);

/** wider than its chord */
export const mushroom: Outline = smooth((t) => {
  const angle = 1.6 * Math.PI * (t - 0.5);
  return [Math.sin(angle), Math.cos(angle)];
});

export const roof: Outline = bent([-1, 0], [0, 1], [1, 0]);
/** not seen whole from its middle when mirrored */
export const comb: Outline = bent(
  [-1, 0],
  [-1, 1],
  [-0.6, 1],
  [-0.6, 0.1],
  [0.2, 0.1],
  [0.2, 1],
  [1, 1],
  [1, 0],
);
