/**
 * Move: parts and groups of solids follow the pen in the view plane, along an axis, or over the surface that lies under them; they turn
 * about the line of sight and about the screen's other two axes (thesis fig. A.6), and grow.
 *
 * Over a surface: the foot is the point of the other parts nearest to the middle of the moved ones when it can be
 * seen, else what is seen behind that middle. The foot goes where the pen takes it, and the parts turn by the
 * shortest way from the surface's normal at the start to the one now, so that an eye slides over a face and keeps
 * looking out. Beside all surfaces the foot goes on in the view plane through where it last lay.
 */
import { apply, type Command } from '../document/command/index.ts';
import type { Document } from '../document/document.ts';
import { middleOfParts, seenParts } from '../document/extent.ts';
import { type Placement, shortestTurn, turnAbout, UNMOVED } from '../math/placement.ts';
import { atan2, cos, PI, sin } from '../math/trig.ts';
import { add3, cross2, dot2, dot3, length2, rotate3, scale3, sub3 } from '../math/tuple.ts';
import type { Vec2, Vec3 } from '../math/vec.ts';
import { facingPlane, onPlane, project, rayAt, toWorld } from '../stroke/plane.ts';
import { type Foot, footOf } from './foot.ts';
import type { Bench, Carried, Pen, ScreenAxis, State } from './tool.ts';
import type { Viewport } from './viewport.ts';

/** What the parts are taken by. */
export type Handle = 'view' | 'x' | 'y' | 'z' | 'surface' | 'turn' | 'turnX' | 'turnY' | 'scale';

const SCREEN: Partial<Record<Handle, ScreenAxis>> = { turnX: 'x', turnY: 'y' };

export const AXIS: Readonly<Record<'x' | 'y' | 'z', Vec3>> = { x: [1, 0, 0], y: [0, 1, 0], z: [0, 0, 1] };

/** Sine squared of the angle between an axis and the line of sight below which a pixel would be millimetres without end. */
const END_ON = 0.02;

/** Where the parts are taken; each report of the pen gives the next one. */
interface Way extends Pick<Carried, 'by' | 'degrees' | 'about' | 'factor'> {
  to(pen: Pen, viewport: Viewport): Way;
}

/** A handle that is about to be taken: the pen comes down on it next. `back` is the state after it. */
export function grip(handle: Handle, back: State): State {
  return {
    name: 'move.grip',
    still: true,
    down(pen, bench) {
      const parts = seenParts(bench.document, bench.selection);
      const middle = middleOfParts(parts);
      return middle
        ? carry(
            handle,
            parts.map(({ id }) => id),
            middle,
            pen,
            bench,
            back,
          )
        : back;
    },
    cancel: () => back,
  };
}

/** Carries these parts from where the pen is; `point` is the one that stays under it. */
export function carry(
  handle: Handle,
  ids: readonly string[],
  point: Vec3,
  pen: Pen,
  bench: Bench,
  back: State,
): State {
  const way = wayOf(handle, ids, point, pen, bench);
  return { ...carrying(ids, point, way, back), ...resting(ids, point, way, pen, back) };
}

/** px: a tap on a handle is no drag, however little a hand is still */
const STILL = 3;

/** Until the pen has left where it came down. */
function resting(
  ids: readonly string[],
  about: Vec3,
  way: Way,
  start: Pen,
  back: State,
): Pick<State, 'move' | 'up'> {
  return {
    move(pens, bench) {
      const last = pens.at(-1);
      const isStill = !last || Math.max(Math.abs(last.x - start.x), Math.abs(last.y - start.y)) < STILL;
      return isStill ? undefined : carrying(ids, about, way, back).move?.(pens, bench);
    },
    up: () => back,
  };
}

function carrying(ids: readonly string[], about: Vec3, way: Way, back: State): State {
  const { by, degrees, about: axis, factor = 1 } = way;
  const command: Command =
    factor === 1 ? { type: 'moveParts', ids, by } : { type: 'scaleParts', ids, factor, about };
  let shown: Document | null = null;
  return {
    name: 'move.carrying',
    still: true,
    carried: {
      ids,
      by,
      ...(degrees !== undefined && { degrees }),
      ...(axis && { about: axis }),
      ...(way.factor && { factor }),
    },
    preview: (bench) => (shown ??= apply(bench.document, command)),
    move(pens, bench) {
      const pen = pens.at(-1);
      return pen && carrying(ids, about, way.to(pen, bench.viewport), back);
    },
    up(bench) {
      if (by !== UNMOVED || factor !== 1) bench.commit([command]);
      return back;
    },
    cancel: () => back,
  };
}

function wayOf(handle: Handle, ids: readonly string[], point: Vec3, pen: Pen, bench: Bench): Way {
  const foot = handle === 'surface' ? footOf(bench, ids, point) : null;
  if (foot) return overSurface(foot, pen, bench.viewport, ids);
  if (handle === 'turn') return turning(point, pen, bench.viewport);
  const axis = SCREEN[handle];
  if (axis) return tilting(axis, point, pen);
  if (handle === 'scale') return growing(point, pen, bench.viewport);
  return handle === 'x' || handle === 'y' || handle === 'z'
    ? alongAxis(AXIS[handle], point, pen, bench.viewport)
    : inView(point, pen, bench.viewport);
}

/** A way that depends on where the pen is now, and not on how it came there. */
function straight(shift: (pen: Pen, viewport: Viewport) => Vec3 | null): Way {
  const at = (by: Placement): Way => ({
    by,
    to(pen, viewport) {
      const translation = shift(pen, viewport);
      return at(translation ? { ...UNMOVED, translation } : by);
    },
  });
  return at(UNMOVED);
}

function inView(point: Vec3, start: Pen, viewport: Viewport): Way {
  const from = underPen(viewport, point, start);
  return straight((pen, now) => {
    const to = underPen(now, point, pen);
    return from && to && sub3(to, from);
  });
}

/** On the plane through a point that faces the person who looks. */
function underPen({ view, size }: Viewport, point: Vec3, { x, y }: Pick<Pen, 'x' | 'y'>): Vec3 | null {
  const plane = facingPlane(view, point);
  const p = onPlane(rayAt(view, size, x, y), plane);
  return p && toWorld(plane, p);
}

function alongAxis(axis: Vec3, point: Vec3, start: Pen, viewport: Viewport): Way {
  const from = nearestOnAxis(viewport, axis, point, start);
  return straight((pen, now) => {
    const to = nearestOnAxis(now, axis, point, pen);
    return from === null || to === null ? null : scale3(axis, to - from);
  });
}

/** mm along the axis from the point to where it comes nearest to the ray through the pen; null when seen end-on. */
function nearestOnAxis({ view, size }: Viewport, axis: Vec3, point: Vec3, { x, y }: Pen): number | null {
  const { origin, direction } = rayAt(view, size, x, y);
  const along = dot3(axis, direction);
  const slope = 1 - along * along;
  if (slope < END_ON) return null;
  return dot3(sub3(origin, point), sub3(axis, scale3(direction, along))) / slope;
}

function overSurface(foot: Foot, start: Pen, viewport: Viewport, ids: readonly string[]): Way {
  const shown = project(viewport.view, viewport.size, foot.point) ?? [start.x, start.y];
  // The handle lies beside the foot: what counts is how far the pen has gone.
  const offset: Vec2 = [shown[0] - start.x, shown[1] - start.y];
  const at = (last: Foot, by: Placement): Way => ({
    by,
    to(pen, now) {
      const [x, y] = [pen.x + offset[0], pen.y + offset[1]];
      const hit = now.pick(x, y, ids);
      if (hit) return at(hit, footTo(foot, hit.point, hit.normal));
      const point = underPen(now, last.point, { x, y });
      return point ? at(last, footTo(foot, point, last.normal)) : at(last, by);
    },
  });
  return at(foot, UNMOVED);
}

/** Degrees that a turn snaps to with Shift, and steps of a factor. */
const SNAP = { turn: 15, scale: 0.1 } as const;
const FACTORS = { min: 0.05, max: 20 } as const;

/** Right and up of where a point is seen, px; null where it is not. */
function beside({ view, size }: Viewport, point: Vec3, { x, y }: Pick<Pen, 'x' | 'y'>): Vec2 | null {
  const at = project(view, size, point);
  return at && [x - at[0], at[1] - y];
}

/** About the line of sight through the point, as far as the pen goes around it. */
function turning(point: Vec3, start: Pen, viewport: Viewport): Way {
  const from = beside(viewport, point, start);
  const at = (by: Placement, degrees: number): Way => ({
    by,
    degrees,
    to(pen, now) {
      const to = beside(now, point, pen);
      if (!from || !to) return at(by, degrees);
      const turned = (atan2(cross2(from, to), dot2(from, to)) * 180) / PI;
      const whole = pen.adds ? SNAP.turn * Math.round(turned / SNAP.turn) : turned;
      return at(turnedBy(whole, [0, 0, 1], point, now), whole);
    },
  });
  return at(UNMOVED, 0);
}

/** About an axis of the screen through a point, degrees. */
function turnedBy(degrees: number, axis: Vec3, point: Vec3, { view }: Viewport): Placement {
  if (degrees === 0) return UNMOVED;
  const half = (degrees * PI) / 360;
  const [x, y, z] = scale3(rotate3(view.rotation, axis), sin(half));
  return turnAbout(point, [x, y, z, cos(half)]);
}

/** degrees for a px of the pen's way: 180° are a hand's breadth */
export const TILT = 0.5;

/** About the screen's x or y through the point: what is near goes with the pen, up and down or to the sides. */
function tilting(axis: ScreenAxis, point: Vec3, start: Pen): Way {
  const at = (by: Placement, degrees: number): Way => ({
    by,
    degrees,
    about: axis,
    to(pen, now) {
      const turned = TILT * (axis === 'x' ? pen.y - start.y : pen.x - start.x);
      const whole = pen.adds ? SNAP.turn * Math.round(turned / SNAP.turn) : turned;
      return at(turnedBy(whole, AXIS[axis], point, now), whole);
    },
  });
  return at(UNMOVED, 0);
}

/** As much as the pen comes away from the point. */
function growing(point: Vec3, start: Pen, viewport: Viewport): Way {
  const from = beside(viewport, point, start);
  const at = (factor: number): Way => ({
    by: UNMOVED,
    factor,
    to(pen, now) {
      const to = beside(now, point, pen);
      if (!from || !to || length2(from) === 0) return at(factor);
      const grown = length2(to) / length2(from);
      const whole = pen.adds ? Math.round(grown / SNAP.scale) * SNAP.scale : grown;
      return at(Math.min(FACTORS.max, Math.max(FACTORS.min, whole)));
    },
  });
  return at(1);
}

/** The foot comes to a point, and the surface's normal there to another. */
function footTo(foot: Foot, point: Vec3, normal: Vec3): Placement {
  return turnAbout(foot.point, shortestTurn(foot.normal, normal), sub3(point, foot.point));
}

/** The pen where it shows a point that is so many mm to the right and up of another, for keys; of turns degrees, of factors percent. */
export function penBeside(
  viewport: Viewport,
  handle: Handle,
  point: Vec3,
  right: number,
  up: number,
): Vec2 | null {
  const { view, size } = viewport;
  if (handle === 'turn' || handle === 'scale') return penAround(viewport, handle, point, right, up);
  const axis = SCREEN[handle];
  if (axis)
    return penBy(viewport, point, axis === 'x' ? [0, -(right + up) / TILT] : [(right + up) / TILT, 0]);
  const plane = facingPlane(view, point);
  const to =
    handle === 'x' || handle === 'y' || handle === 'z'
      ? add3(point, scale3(AXIS[handle], right + up))
      : toWorld(plane, [right, up]);
  return project(view, size, to);
}

function penBy({ view, size }: Viewport, point: Vec3, [x, y]: Vec2): Vec2 | null {
  const at = project(view, size, point);
  return at && [at[0] + x, at[1] + y];
}

/** px: any distance does */
const AWAY = 100;

function penAround(
  { view, size }: Viewport,
  handle: 'turn' | 'scale',
  point: Vec3,
  right: number,
  up: number,
): Vec2 | null {
  const at = project(view, size, point);
  const angle = handle === 'turn' ? ((up - right) * PI) / 180 : 0;
  const away = AWAY * (handle === 'scale' ? Math.max(1 + (right + up) / 100, FACTORS.min) : 1);
  return at && [at[0] + away * cos(angle), at[1] - away * sin(angle)];
}
