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
import type { Bench, Pen, State } from './tool.ts';
import type { Viewport } from './viewport.ts';

/** px: less is a tap, which says nothing */
const MINIMUM = 8;
/** a stroke that comes back to within this part of its length is a circle */
const CLOSED = 0.15;
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
    down: (pen) => drawing(on, [pen], null),
    cancel: () => on.back,
  };
  return state;
}

function drawing(on: Sizing, pens: readonly Pen[], bench: Bench | null): State {
  const points = bench ? pointsOf(pens, on.at, bench.viewport) : [];
  const isTap = !bench || wayOf(pens.map(({ x, y }): Vec2 => [x, y])) < MINIMUM;
  const radius = isTap ? null : radiusOf(points);
  const command = radius === null ? null : on.command(radius);
  return {
    name: 'radius.drawing',
    still: true,
    wet: { pens: [...pens], on: null, closing: false },
    ...(radius !== null && bench && { marks: tagOf(on, points, radius, bench.viewport) }),
    preview: ({ document }) => command && apply(document, command),
    move: (more, now) => drawing(on, [...pens, ...more], now),
    up(now) {
      if (command) now.commit([command]);
      return command ? on.back : sizing(on);
    },
    cancel: () => on.back,
  };
}

/** mm on the plane through the tube that faces the person. */
function pointsOf(pens: readonly Pen[], at: Vec3, { view, size }: Viewport): Vec2[] {
  const plane = facingPlane(view, at);
  return pens.flatMap(({ x, y }) => {
    const point = onPlane(rayAt(view, size, x, y), plane);
    return point ? [point] : [];
  });
}

const wayOf = (points: readonly Vec2[]): number =>
  points.slice(1).reduce((sum, point, i) => sum + distance2(points[i]!, point), 0);

/** mm, in tenths, as brushes have them; null: nothing was drawn. */
export function radiusOf(points: readonly Vec2[]): number | null {
  const [start, end] = [points[0], points.at(-1)];
  const way = wayOf(points);
  if (!start || !end || !(way > 0)) return null;
  const gap = distance2(start, end);
  const area = Math.abs(areaOf(points));
  const isCircle = gap < CLOSED * way && area > (ROUND * way * way) / (4 * Math.PI);
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
function tagOf({ at }: Sizing, points: readonly Vec2[], mm: number, { view }: Viewport): readonly Mark[] {
  const plane = facingPlane(view, at);
  const [from, to] = [points[0]!, points.at(-1)!].map((point) => toWorld(plane, point));
  return [{ kind: 'tag', at: to!, from: from!, value: mm, unit: 'mm' }];
}
