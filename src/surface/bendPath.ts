/**
 * The bend stroke d as the way that sections take: from mm walked on the axis to a place on d (thesis 6.1).
 *
 * Departures. The thesis pairs d(u) with l(u) by a parameter that is even on neither, so that sections slide (3.9 % of
 * the length on an arc of 120°); here both are walked by arc length. 'Keeps length' walks as many millimetres on d as
 * on l and runs on straight where d is too short; else d is stretched over the whole axis. A stroke drawn from the other
 * end is turned round; a closed one on a closed axis starts where it is nearest and turns the same way.
 */
import { once } from '../math/once.ts';
import { atan2, TAU } from '../math/trig.ts';
import { add2, cross2, distance2, scale2 } from '../math/tuple.ts';
import type { Vec2 } from '../math/vec.ts';
import type { Curve } from '../stroke/curve.ts';
import { nearestParameter } from '../stroke/nearestPoint.ts';
import type { Axis } from './axis.ts';
import { ON_CORNER } from './side.ts';
import { slope } from './slope.ts';

export interface PathPoint {
  point(): Vec2;
  /** unit, the way the axis runs */
  tangent(): Vec2;
}

export interface BendPath {
  /** mm on d for each mm walked on the axis */
  readonly stretch: number;
  /** mm walked on the axis at which d has corners */
  readonly corners: readonly number[];
  /** `side`: at a corner, the tangent before (−1) or after (1) it */
  at(walked: number, side: -1 | 1): PathPoint;
  /** radians to the left for each mm walked on the axis */
  turning(walked: number, side: -1 | 1): number;
}

/** The way along `curve` for an axis; null for a curve without length. */
export function bendPath(axis: Axis, curve: Curve, keepsLength: boolean): BendPath | null {
  if (!(curve.length > 0 && curve.length < Infinity)) return null;
  const round = axis.closed && curve.closed;
  const sense = round ? senseRound(axis, curve) : senseAlong(axis, curve);
  const part = keepsLength && !round ? 1 / curve.length : 1 / axis.length;
  const start = round ? nearestStart(axis, curve) : sense === 1 ? 0 : part * axis.length;
  const on = (walked: number): number => snapped(start + sense * part * walked, curve, round);
  const at: BendPath['at'] = (walked, side) => {
    const t = on(walked);
    const inside = round ? t : Math.min(Math.max(t, 0), 1);
    const along = once(() => curve.tangent(inside, sense === 1 ? side : side === 1 ? -1 : 1));
    const beyond = (t - inside) * curve.length;
    return {
      point: () => {
        const point = curve.point(inside);
        return beyond === 0 ? point : add2(point, scale2(along(), beyond));
      },
      tangent: () => scale2(along(), sense),
    };
  };
  const corners = cornersOf(curve, start, sense, round)
    .map((share) => share / part)
    .filter((walked) => round || isInside(walked / axis.length));
  const angle = (share: number, side: -1 | 1): number => {
    const [x, y] = at(share * axis.length, side).tangent();
    return atan2(y, x);
  };
  const breaks = [0, ...corners.map((walked) => walked / axis.length), 1];
  return {
    stretch: part * curve.length,
    corners,
    at,
    turning: (walked, side) => slope(angle, walked / axis.length, side, breaks, TAU) / axis.length,
  };
}

/** 1 when d runs as the axis does, −1 when its ends match better turned round. */
function senseAlong({ ends: [a, b] }: Axis, curve: Curve): 1 | -1 {
  const [from, to] = [curve.point(0), curve.point(1)];
  return distance2(from, a) + distance2(to, b) <= distance2(from, b) + distance2(to, a) ? 1 : -1;
}

/** Rings turn the same way as their axis. */
function senseRound(axis: Axis, curve: Curve): 1 | -1 {
  const area = (point: (t: number) => Vec2): number =>
    Array.from({ length: 64 }, (_, i) => cross2(point(i / 64), point(((i + 1) % 64) / 64))).reduce(
      (a, b) => a + b,
    );
  return area((u) => axis.at(u, 1).point()) * area((t) => curve.point(t)) < 0 ? -1 : 1;
}

function nearestStart(axis: Axis, curve: Curve): number {
  return nearestParameter(
    (t) => curve.point(t),
    (t) => curve.tangent(t),
    axis.ends[0],
    true,
  );
}

/** Shares of d from its start, in the way it is walked, at which it has corners. */
function cornersOf(curve: Curve, start: number, sense: 1 | -1, round: boolean): number[] {
  const shares = curve.corners.map((corner) => sense * (corner - start));
  return (round ? shares.map((share) => share - Math.floor(share)) : shares).sort((a, b) => a - b);
}

const isInside = (share: number): boolean => share > ON_CORNER && share < 1 - ON_CORNER;

/** A place within rounding of a corner is on it. */
function snapped(t: number, curve: Curve, round: boolean): number {
  const inside = round ? t - Math.floor(t) : t;
  return curve.corners.find((corner) => Math.abs(corner - inside) <= ON_CORNER) ?? inside;
}
