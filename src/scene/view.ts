/**
 * The arithmetic of looking, without a renderer: easing between views, framing a box, limits of zoom and pan.
 * Everything in mm and radians; screen offsets as fractions are named so.
 */

import { FRONT_VIEW } from '../document/drawing.ts';
import { type Quat, quat, type Vec3, vec3 } from '../math/vec.ts';
import type { Box } from '../mesh/mesh.ts';
import type { View } from '../stroke/stroke.ts';

/** An axis the form may be faced along; named for the side that is seen. */
export type Face = 'front' | 'back' | 'left' | 'right' | 'top' | 'bottom';

const HALF = Math.SQRT1_2;
/** camera to world */
export const FACE_ROTATION: Readonly<Record<Face, Quat>> = {
  front: [0, 0, 0, 1],
  back: [0, 1, 0, 0],
  right: [0, HALF, 0, HALF],
  left: [0, -HALF, 0, HALF],
  top: [-HALF, 0, 0, HALF],
  bottom: [HALF, 0, 0, HALF],
};

export { FRONT_VIEW };

/** Parts of the picture, 0–1, that are kept free at its sides. */
export interface Margins {
  readonly left: number;
  readonly top: number;
  readonly right: number;
  readonly bottom: number;
}

/** Air around a form that is fitted. */
export const AIR: Margins = { left: 0.1, top: 0.1, right: 0.1, bottom: 0.1 };
/** mm; a box that appears smaller is a point, and gets the default height */
const LEAST_FIT = 1e-6;

/** A sphere, mm. */
export interface Ball {
  readonly centre: Vec3;
  readonly radius: number;
}

/** Right, up and backward of the camera in the world. */
export function axes(rotation: Quat): readonly [right: Vec3, up: Vec3, back: Vec3] {
  return [turned([1, 0, 0], rotation), turned([0, 1, 0], rotation), turned([0, 0, 1], rotation)];
}

export function turned(vector: Vec3, rotation: Quat): Vec3 {
  return vec3.transformQuat([0, 0, 0], vector, rotation) as unknown as Vec3;
}

/** Part of the way from one view to another; 0 and 1 give the views themselves, to the bit. */
export function between(from: View, to: View, part: number): View {
  if (part <= 0) return from;
  if (part >= 1) return to;
  return {
    pivot: vec3.lerp([0, 0, 0], from.pivot, to.pivot, part) as unknown as Vec3,
    rotation: quat.slerp([0, 0, 0, 1], from.rotation, to.rotation, part) as unknown as Quat,
    // even in the logarithm: zooming in and out look alike
    height: from.height * (to.height / from.height) ** part,
    fov: to.fov,
  };
}

/** cubic-bezier(.6, 0, .2, 1), the interface's curve for the camera. */
export function ease(time: number): number {
  if (time <= 0) return 0;
  if (time >= 1) return 1;
  const bezier = (a: number, b: number, t: number) =>
    3 * (1 - t) * (1 - t) * t * a + 3 * (1 - t) * t * t * b + t * t * t;
  let low = 0;
  let high = 1;
  // x(t) grows steadily; 24 halvings are 6e-8 of the way
  for (let i = 0; i < 24; i++) {
    const middle = (low + high) / 2;
    if (bezier(0.6, 0.2, middle) < time) low = middle;
    else high = middle;
  }
  return bezier(0, 1, (low + high) / 2);
}

/** The view in the same direction that shows the whole box; `aspect` = width / height of the screen. */
export function fitted(view: View, box: Box, aspect: number, margins = AIR): View {
  const [right, up, back] = axes(view.rotation);
  const middle = vec3.lerp([0, 0, 0], box.min, box.max, 0.5) as unknown as Vec3;
  const { left, top, right: rightMargin, bottom } = margins;
  const wide = 1 - left - rightMargin;
  const high = 1 - top - bottom;
  // tangent of half the opening; 0 is orthographic
  const slope = Math.tan((view.fov * Math.PI) / 360);
  // Seen edge-on a box still gets room for a tenth of its size, so that no corner comes to lie in the eye.
  const least = vec3.distance(box.min, box.max) / 10;
  let height = 0;
  for (const corner of corners(box)) {
    const from = vec3.subtract([0, 0, 0], corner, middle) as unknown as Vec3;
    const size = (2 * Math.abs(vec3.dot(from, up))) / high;
    const across = (2 * Math.abs(vec3.dot(from, right))) / (wide * aspect);
    // A corner nearer than the pivot appears larger by what the opening spans over that distance.
    height = Math.max(height, Math.max(size, across, least / high) + 2 * slope * vec3.dot(from, back));
  }
  if (height <= LEAST_FIT) return { ...view, pivot: middle, height: FRONT_VIEW.height };
  const pivot = vec3.scaleAndAdd([0, 0, 0], middle, right, (height * aspect * (rightMargin - left)) / 2);
  vec3.scaleAndAdd(pivot, pivot, up, (height * (top - bottom)) / 2);
  return { ...view, pivot: pivot as unknown as Vec3, height };
}

/** Whether all points, three numbers each, are in the picture between the margins. */
export function holds(view: View, points: ArrayLike<number>, aspect: number, margins: Margins): boolean {
  const [right, up, back] = axes(view.rotation);
  const slope = Math.tan((view.fov * Math.PI) / 360);
  const from: [number, number, number] = [0, 0, 0];
  for (let i = 0; i < points.length; i += 3) {
    vec3.set(
      from,
      points[i]! - view.pivot[0],
      points[i + 1]! - view.pivot[1],
      points[i + 2]! - view.pivot[2],
    );
    // mm that the picture is high where the point is
    const height = view.height - 2 * slope * vec3.dot(from, back);
    const [x, y] = [0.5 + vec3.dot(from, right) / height / aspect, 0.5 - vec3.dot(from, up) / height];
    const isHeld = x > margins.left && x < 1 - margins.right && y > margins.top && y < 1 - margins.bottom;
    if (height <= 0 || !isHeld) return false;
  }
  return true;
}

function* corners({ min, max }: Box): Iterable<Vec3> {
  for (const x of [min[0], max[0]])
    for (const y of [min[1], max[1]]) for (const z of [min[2], max[2]]) yield [x, y, z];
}

/** Visible height may go from a fiftieth of the form to forty times it, and always includes a page's default. */
export function heightLimits(ball: Ball | null): readonly [least: number, most: number] {
  if (!ball || ball.radius === 0) return [2, 4 * FRONT_VIEW.height];
  return [
    Math.min(ball.radius / 25, FRONT_VIEW.height / 4),
    Math.max(80 * ball.radius, 4 * FRONT_VIEW.height),
  ];
}

/** The view, moved so that a part of the sphere stays on the screen, and its height within limits. */
export function kept(view: View, ball: Ball | null, aspect: number): View {
  const [least, most] = heightLimits(ball);
  const height = Math.min(most, Math.max(least, view.height));
  if (!ball || ball.radius === 0) return { ...view, height };
  const [right, up] = axes(view.rotation);
  const away = vec3.subtract([0, 0, 0], view.pivot, ball.centre) as unknown as Vec3;
  const pivot = vec3.clone(view.pivot as [number, number, number]);
  for (const [axis, half] of [
    [right, (height / 2) * aspect],
    [up, height / 2],
  ] as const) {
    // at least half of the sphere, or a quarter of a screen that is smaller than it
    const most = half + ball.radius - Math.min(ball.radius, half / 2);
    const along = vec3.dot(away, axis);
    vec3.scaleAndAdd(pivot, pivot, axis, Math.min(most, Math.max(-most, along)) - along);
  }
  return { ...view, pivot: pivot as unknown as Vec3, height };
}
