/**
 * The axis l(u) of a sheet as the side view shows it: its centres c(u) projected along V, with the distance s(u) walked
 * on it and a direction T_l(u) that never vanishes (thesis 6.1: T_l is l′/|l′|, undefined where centres stand still).
 *
 * Two ways of walking. Along the path: s is the arc length of l, so that d = l moves nothing. Along a line: when l is
 * straight to 5 % but turns back, stands still or swings about (a U seen from its side, a ring edge-on), and for rings
 * bent by an open stroke, s is the advance along that line, T_l its direction, and what sticks out of the line is part of
 * the section. Arc length would unroll the U and fold its sections at the turn. Exactly straight ways are both.
 */
import type { Plane } from '../math/plane.ts';
import type { Axis } from './axis.ts';
import { depthOf, extentOf, probesOf } from './axisProbes.ts';
import { lineOf } from './axisWay.ts';
import { kept } from './keptSpine.ts';
import { lineAxis } from './lineAxis.ts';
import { pathAxis } from './pathAxis.ts';
import type { Spine } from './sheet.ts';
import { sideView } from './sideView.ts';

/** seen from an end: a view that shows less than this part of the way */
const END_ON = 0.02;

interface Known {
  readonly plane: Plane;
  readonly closedStroke: boolean;
  readonly axis: Axis | null;
}

/** Of each spine the last ones: while a bend is drawn neither spine nor view change. */
const axes = new WeakMap<Spine, readonly Known[]>();
const KEPT = 3;

/** The axis in the side view `plane` (in the coordinates of the sheet), or null when it is seen end-on or has no length. */
export function bendAxis(spine: Spine, plane: Plane, closedStroke = false): Axis | null {
  const known = axes.get(spine) ?? [];
  const found = known.find((other) => other.closedStroke === closedStroke && isSame(other.plane, plane));
  if (found) return found.axis;
  const axis = newAxis(kept(spine), plane, closedStroke);
  axes.set(spine, [{ plane, closedStroke, axis }, ...known].slice(0, KEPT));
  return axis;
}

function isSame(a: Plane, b: Plane): boolean {
  return [0, 1, 2].every((k) => a.origin[k] === b.origin[k] && a.x[k] === b.x[k] && a.y[k] === b.y[k]);
}

function newAxis(spine: Spine, plane: Plane, closedStroke: boolean): Axis | null {
  const view = sideView(plane);
  const probes = probesOf(spine, view);
  const extent = extentOf(probes);
  if (!(extent > END_ON * depthOf(spine)) || !(extent > 0)) return null;
  const way = lineOf(probes, extent, spine.closed);
  const loop = spine.closed && !way.straight;
  if (way.exact || (way.straight && !way.quiet) || (loop && !closedStroke)) {
    return lineAxis(spine, view, way.along, probes);
  }
  return pathAxis(spine, view, probes, loop);
}
