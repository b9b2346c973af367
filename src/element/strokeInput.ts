/** Strokes as pages write them: a list of points is enough; what a hand would have added is filled in. */
import type { Document } from '../document/document.ts';
import { FRONT_VIEW } from '../document/drawing.ts';
import type { Plane } from '../math/plane.ts';
import type { Stroke } from '../stroke/stroke.ts';

export interface StrokeInput {
  /** mm on the plane: x to the right, y up, and the pen’s pressure, 0–1 */
  readonly points: readonly (readonly [x: number, y: number, pressure?: number])[];
  /** without it the plane of the unfinished form, else the one through the origin that faces the front */
  readonly plane?: Plane;
  /** meant as a loop */
  readonly closed?: boolean;
}

const FRONT_PLANE: Plane = { origin: [0, 0, 0], x: [1, 0, 0], y: [0, 1, 0] };

/** ms from point to point: a pen’s 125 reports a second */
const STEP = 8;

/** A whole stroke. What is no list of points comes back as it is: whoever checks strokes says what is wrong with it. */
export function strokeOf(input: Stroke | StrokeInput, { draft }: Document): unknown {
  if (!input || typeof input !== 'object' || !('points' in input) || !Array.isArray(input.points))
    return input;
  const { points, closed = false } = input;
  const first = draft?.strokes[0];
  return {
    samples: points.map((point, i) => sampleOf(point, i)),
    plane: input.plane ?? first?.plane ?? FRONT_PLANE,
    view: input.plane ? FRONT_VIEW : (first?.view ?? FRONT_VIEW),
    pointer: 'pen',
    closed,
  };
}

function sampleOf(point: StrokeInput['points'][number], i: number): unknown {
  if (!Array.isArray(point)) return point;
  const [x, y, pressure = 0.5] = point as StrokeInput['points'][number];
  return { x, y, pressure, tiltX: 0, tiltY: 0, time: STEP * i };
}
