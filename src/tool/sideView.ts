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
/** part of the picture that is left free at each side, unless controls cover more */
const AIR = 0.1;

type Looking = Pick<Viewport, 'view' | 'size' | 'room'>;

/** `line`: the centre line, `plane`: on which it was drawn, `box`: around the part; all in the world. */
export function sideView(line: readonly Vec3[], plane: Plane, box: Box, viewport: Looking): View {
  const { view } = viewport;
  const axis = meanAxis(line, plane);
  const back = sightOf(axis, plane, view.rotation);
  const turn = shortestTurn(rotate3(view.rotation, [0, 0, 1]), back);
  const turned = turnedBy(turn, view.rotation);
  const rotation = turnedBy(about(back, rollOf(axis, turned)), turned);
  return around(box, rotation, viewport);
}

/** From where a plane was drawn on: x to the right, y up. */
export const viewOnto = ({ x, y }: Plane, box: Box, viewport: Looking): View =>
  around(box, turnOnto(x, y), viewport);

/** The part in the middle of what the controls leave free, as large as it was; smaller only where it would not fit. */
function around(box: Box, rotation: Quat, viewport: Looking): View {
  const { view, size } = viewport;
  const { left, right, top, bottom } = viewport.room?.() ?? {
    left: AIR,
    right: AIR,
    top: AIR,
    bottom: AIR,
  };
  const aspect = size.width / size.height;
  const middle = scale3(add3(box.min, box.max), 0.5);
  const [across, up, back] = UNITS.map((unit) => rotate3(rotation, unit)) as [Vec3, Vec3, Vec3];
  const opening = (view.fov * PI) / 360;
  const slope = sin(opening) / cos(opening);
  const needed = cornersOf(box).map((corner) => {
    const from = sub3(corner, middle);
    const wide = (2 * Math.abs(dot3(from, across))) / (aspect * (1 - left - right));
    const high = (2 * Math.abs(dot3(from, up))) / (1 - top - bottom);
    // in perspective a corner nearer than the middle appears larger
    return Math.max(wide, high) + 2 * slope * dot3(from, back);
  });
  const height = Math.max(view.height, ...needed);
  const aside = scale3(across, (height * aspect * (right - left)) / 2);
  const pivot = add3(middle, add3(aside, scale3(up, (height * (top - bottom)) / 2)));
  return { ...view, rotation, height, pivot };
}

const UNITS: readonly Vec3[] = [
  [1, 0, 0],
  [0, 1, 0],
  [0, 0, 1],
];

const cornersOf = ({ min, max }: Box): Vec3[] =>
  [min[0], max[0]].flatMap((x) =>
    [min[1], max[1]].flatMap((y) => [min[2], max[2]].map((z): Vec3 => [x, y, z])),
  );

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

/** radians: far enough that what lay on edge is seen as an ellipse */
const TIPS = (35 * PI) / 180;

/** Turned a little, so that a plane that is seen from its edge is seen, from above, or from the right. */
export function tipped(plane: Plane, view: View): View {
  const [right, up, back] = UNITS.map((unit) => rotate3(view.rotation, unit)) as [Vec3, Vec3, Vec3];
  const normal = cross3(plane.x, plane.y);
  const [across, above] = [dot3(normal, right), dot3(normal, up)];
  const isAbove = Math.abs(above) > 0.3 ? above > 0 : across > 0;
  const axis = cross3(back, scale3(normal, isAbove ? 1 : -1));
  const size = length3(axis);
  if (!(size > 0)) return view;
  return { ...view, rotation: turnedBy(about(scale3(axis, 1 / size), TIPS), view.rotation) };
}

const about = (axis: Vec3, angle: number): Quat => {
  const s = sin(angle / 2);
  return [s * axis[0], s * axis[1], s * axis[2], cos(angle / 2)];
};

function turnedBy(turn: Quat, rotation: Quat): Quat {
  const still = (q: Quat): Placement => ({ rotation: q, translation: [0, 0, 0] });
  return compose(still(turn), still(rotation)).rotation;
}
