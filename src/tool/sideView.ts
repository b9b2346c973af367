/**
 * From where a part is bent (thesis 6.1): along its sections, so that the line of sight lies in the drawing plane, across the part's
 * mean axis. The camera comes there by the shortest way, and rolls so that an axis that is about upright, or level, is so.
 */
import { compose, type Placement, shortestTurn, turnOnto } from '../math/placement.ts';
import { atan2, cos, PI, sin } from '../math/trig.ts';
import { add3, cross3, dot3, length3, rotate3, scale3, sub3 } from '../math/tuple.ts';
import type { Quat, Vec3 } from '../math/vec.ts';
import type { Box } from '../mesh/mesh.ts';
import type { Plane, View } from '../stroke/stroke.ts';
import type { Viewport } from './viewport.ts';

/** radians: an axis that leans less than this is meant to be upright, or level */
const LEANS = PI / 6;
/** the height of the picture in radii of the part, at least and at most */
const ROOM = { least: 3.2, most: 7 } as const;

/** `line`: the centre line, `plane`: on which it was drawn, `box`: around the part; all in the world. */
export function sideView(
  line: readonly Vec3[],
  plane: Plane,
  box: Box,
  { view, size }: Pick<Viewport, 'view' | 'size'>,
): View {
  const axis = meanAxis(line, plane);
  const back = sightOf(axis, plane, view.rotation);
  const turn = shortestTurn(rotate3(view.rotation, [0, 0, 1]), back);
  const turned = turnedBy(turn, view.rotation);
  const rotation = turnedBy(about(back, rollOf(axis, turned)), turned);
  return around(box, rotation, { view, size });
}

/** From where a plane was drawn on: x to the right, y up. */
export const viewOnto = ({ x, y }: Plane, box: Box, viewport: Pick<Viewport, 'view' | 'size'>): View =>
  around(box, turnOnto(x, y), viewport);

/** The part in the middle, with room to draw around it. */
function around({ min, max }: Box, rotation: Quat, { view, size }: Pick<Viewport, 'view' | 'size'>): View {
  const radius = length3(sub3(max, min)) / 2;
  const least = (ROOM.least * radius) / Math.min(1, size.width / size.height);
  const most = (ROOM.most / ROOM.least) * least;
  const height = radius > 0 ? Math.min(most, Math.max(least, view.height)) : view.height;
  return { ...view, rotation, height, pivot: scale3(add3(min, max), 0.5) };
}

/** Unit, in the drawing plane: from end to end, or, where that tells nothing, the plane's upright. */
function meanAxis(line: readonly Vec3[], { x, y }: Plane): Vec3 {
  const [first, last] = [line[0], line.at(-1)];
  if (!first || !last) return y;
  const chord = sub3(last, first);
  const flat = add3(scale3(x, dot3(chord, x)), scale3(y, dot3(chord, y)));
  const reach = Math.max(...line.map((p) => length3(sub3(p, first))));
  const length = length3(flat);
  return length > 0.25 * reach ? scale3(flat, 1 / length) : y;
}

/** Towards the person who looks: of the two sides the one nearer to the present view, in doubt the right one. */
function sightOf(axis: Vec3, { x, y }: Plane, rotation: Quat): Vec3 {
  const across = cross3(axis, cross3(x, y));
  const unit = scale3(across, 1 / length3(across));
  const nearness = dot3(unit, rotate3(rotation, [0, 0, 1]));
  const side = Math.abs(nearness) > 1e-3 ? nearness : dot3(unit, rotate3(rotation, [1, 0, 0]));
  const below = Math.abs(side) > 1e-3 ? side : dot3(unit, rotate3(rotation, [0, 1, 0]));
  return below < 0 ? scale3(unit, -1) : unit;
}

/** radians that the camera rolls by, so that the axis stands or lies where it leans little */
function rollOf(axis: Vec3, rotation: Quat): number {
  const [right, up] = [rotate3(rotation, [1, 0, 0]), rotate3(rotation, [0, 1, 0])];
  const angle = atan2(dot3(axis, up), dot3(axis, right));
  const off = angle - (PI / 2) * Math.round(angle / (PI / 2));
  return Math.abs(off) < LEANS ? off : 0;
}

const about = (axis: Vec3, angle: number): Quat => {
  const s = sin(angle / 2);
  return [s * axis[0], s * axis[1], s * axis[2], cos(angle / 2)];
};

function turnedBy(turn: Quat, rotation: Quat): Quat {
  const still = (q: Quat): Placement => ({ rotation: q, translation: [0, 0, 0] });
  return compose(still(turn), still(rotation)).rotation;
}
