/**
 * A radius by drawing (thesis A.2.1): the next stroke says how thick tubes are, a line by its length, a circle by its own radius. What it
 * does shows while the pen moves. It is taken flat to the screen, where the tube is.
 */
import { apply, type Command } from '../document/command/index.ts';
import { RADIUS_RANGE } from '../document/document.ts';
import { cross2, distance2, sub2 } from '../math/tuple.ts';
import type { Vec2, Vec3 } from '../math/vec.ts';
import { facingPlane, onPlane, rayAt, toWorld } from '../stroke/plane.ts';
import type { Mark } from './marks.ts';
import { previewed } from './previewed.ts';
import type { State } from './tool.ts';
import { isClosing, LEAST_LENGTH, type Trace, traced, traceFrom } from './trace.ts';
import type { Viewport } from './viewport.ts';

/** of a closed line that encloses less than this part of what its length could, nothing is round */
const ROUND = 0.3;

export interface Sizing {
  /** where the tube is: px are mm there */
  readonly at: Vec3;
  readonly command: (mm: number) => Command;
  readonly back: State;
}

/** Waits for the stroke. */
export function sizing(on: Sizing): State {
  const state: State = {
    name: 'radius.idle',
    still: true,
    down: (pen, { viewport }) => drawing(on, traceFrom(pen, viewport.view)),
    cancel: () => on.back,
  };
  return state;
}

function drawing(on: Sizing, trace: Trace): State {
  const closing = isClosing(trace);
  return {
    name: 'radius.drawing',
    still: true,
    wet: { pens: trace.pens, on: null, closing },
    marked: (bench) => tagOf(on, trace, bench.viewport),
    preview: previewed((bench) => {
      const command = commandOf(on, trace, bench.viewport);
      return command && apply(bench.document, command);
    }),
    move: (more) => drawing(on, traced(trace, more)),
    up(bench) {
      const command = commandOf(on, trace, bench.viewport);
      if (command) bench.commit([command]);
      return command ? on.back : sizing(on);
    },
    cancel: () => on.back,
  };
}

function commandOf(on: Sizing, trace: Trace, { size }: Viewport): Command | null {
  const radius = drawnRadius(on, trace, size);
  return radius === null ? null : on.command(radius);
}

const drawnRadius = (on: Sizing, trace: Trace, size: Viewport['size']): number | null =>
  trace.length < LEAST_LENGTH ? null : radiusOf(pointsOf(on, trace, size), isClosing(trace));

/** mm on the plane through the tube that faces the person. */
function pointsOf({ at }: Sizing, { pens, view }: Trace, size: Viewport['size']): Vec2[] {
  const plane = facingPlane(view, at);
  return pens.flatMap(({ x, y }) => {
    const point = onPlane(rayAt(view, size, x, y), plane);
    return point ? [point] : [];
  });
}

const wayOf = (points: readonly Vec2[]): number =>
  points.slice(1).reduce((sum, point, i) => sum + distance2(points[i]!, point), 0);

/** mm, in tenths, as brushes have them; null: nothing was drawn. `closed`: it came back to its start. */
export function radiusOf(points: readonly Vec2[], closed: boolean): number | null {
  const [start, end] = [points[0], points.at(-1)];
  const way = wayOf(points);
  if (!start || !end || !(way > 0)) return null;
  const gap = distance2(start, end);
  const area = Math.abs(areaOf(points));
  const isCircle = closed && area > (ROUND * way * way) / (4 * Math.PI);
  const radius = isCircle ? Math.sqrt(area / Math.PI) : gap;
  return Math.min(RADIUS_RANGE.max, Math.max(RADIUS_RANGE.min, Math.round(10 * radius) / 10));
}

/** mm², of the polygon from the first point round to it */
function areaOf(points: readonly Vec2[]): number {
  const start = points[0]!;
  return points
    .slice(1)
    .reduce((sum, point, i) => sum + cross2(sub2(points[i]!, start), sub2(point, start)) / 2, 0);
}

/** Beside the pen. */
function tagOf(on: Sizing, trace: Trace, { size }: Viewport): readonly Mark[] {
  const value = drawnRadius(on, trace, size);
  if (value === null) return [];
  const plane = facingPlane(trace.view, on.at);
  const points = pointsOf(on, trace, size);
  const [from, to] = [points[0]!, points.at(-1)!].map((point) => toWorld(plane, point));
  return [{ kind: 'tag', at: to!, from: from!, value, unit: 'mm' }];
}
