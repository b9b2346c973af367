/**
 * The places along a stroke at which a tube has its rows, corners included.
 *
 * Corners stay creases. Up to a turn of 100° both legs run on to the bisecting plane (a mitre, stretched by
 * 1/cos(turn/2) ≤ 1.56); the ring there is shared and only its normals are doubled. Points of nearby rings slide along
 * the tangent in proportion, out of the way of the inner side of the mitre: on straight legs they stay on the
 * cylinder. Sharper turns get a ball joint instead: rings that turn about the corner point.
 *
 * Tried: rings perpendicular up to the corner (they overlap on the inside from radius × tan(turn/2) on) and
 * clipping them at the bisecting plane (collapsed quads, and on bent legs the two sides no longer meet).
 */
import { atan2, cos, PI, sin, TAU } from '../math/trig.ts';
import { cross2, dot2 } from '../math/tuple.ts';
import type { Vec2 } from '../math/vec.ts';
import type { Curve } from '../stroke/curve.ts';
import { pieces } from './rows.ts';
import type { RowAt } from './sheet.ts';

export interface Slice {
  readonly point: Vec2;
  /** unit */
  readonly tangent: Vec2;
  /** mm */
  readonly radius: number;
  /** widening per mm */
  readonly flare: number;
  /** signed curvature per mm, positive to the left; only known where the flare is not 0 */
  readonly bend: number;
  /** how far points slide along the tangent, in units of their way to the left of the stroke */
  readonly slide: number;
  /** false after a crease */
  readonly joined: boolean;
  readonly at: RowAt;
}

/** a full turn's worth of rows, over all ball joints of a tube */
const JOINT_ROWS = 1024;

/** mm at u */
export type Radius = (u: number) => number;

/** sharper turns are rounded by a ball joint, radians */
const SHARPEST_MITRE = (100 * PI) / 180;
/** u over which slopes are measured: a thousandth of the stroke smooths no feature that a pen can draw */
const STEP = 5e-4;
/** points slide over this many times the length of the mitre, so that inner quads keep half their length */
const SLIDE_OVER = 2;

/**
 * Slices from end to end, about `quads` of them between; a closed stroke begins at its first corner, and its
 * last slice is its first again. `around`: quads of a full turn, for ball joints.
 */
export function slices(curve: Curve, radius: Radius, quads: number, around: number): Slice[] {
  const stops = stopsOf(curve);
  const least = curve.closed ? Math.ceil(3 / (stops.length - 1)) : 1;
  const turns = turnsAt(curve, stops);
  const joint = jointQuads(turns, around);
  const found = pieces(stops, quads, () => least).flatMap((us, i) => {
    const leg: Leg = { first: us[0]!, last: us[us.length - 1]!, turns: [turns[i]!, turns[i + 1]!] };
    const row = us.map((u, k) => sliceAt(curve, radius, leg, u, k > 0, k < us.length - 1));
    return [...row, ...ballJoint(row[row.length - 1]!, turns[i + 1]!, joint)];
  });
  const ballAtSeam = curve.closed && isBall(turns[0]!);
  return ballAtSeam ? [...found, { ...found[0]!, joined: true }] : found;
}

/** Ends and corners; a closed stroke begins at its first corner and ends there, a whole turn on. */
export function stopsOf(curve: Curve): number[] {
  const start = curve.closed ? (curve.corners[0] ?? 0) : 0;
  const inner = curve.corners.filter((corner) => corner > start && corner < start + 1);
  return [start, ...inner, start + 1];
}

/** u of a surface, which begins where its first stop is, at u of its stroke. */
function fromStart(curve: Curve, u: number): number {
  return curve.closed ? u - (curve.corners[0] ?? 0) : u;
}

/** By what angle the stroke turns at each stop; 0 at ends. */
export function turnsAt(curve: Curve, stops: readonly number[]): number[] {
  return stops.map((u, i) => {
    const end = i === 0 || i === stops.length - 1;
    return end && !(curve.closed && curve.corners.length > 0) ? 0 : turnAt(curve, u);
  });
}

/** Rows of a full turn of a ball joint: a hatch has hundreds of sharp turns, which share what there is. */
export function jointQuads(turns: readonly number[], around: number): number {
  const sharp = turns.filter(isBall).length;
  return Math.max(4, Math.min(around, Math.floor(JOINT_ROWS / Math.max(1, sharp))));
}

/** Too sharp a turn for a mitre. */
export const isBall = (turn: number): boolean => Math.abs(turn) > SHARPEST_MITRE;

/** The angle from the arriving to the leaving tangent, −π … π, positive to the left. */
function turnAt(curve: Curve, u: number): number {
  const before = tangentAt(curve, u, -1);
  const after = tangentAt(curve, u, 1);
  return atan2(cross2(before, after), dot2(before, after));
}

/** What lies between two stops. */
export interface Leg {
  readonly first: number;
  readonly last: number;
  /** at both, radians */
  readonly turns: readonly [number, number];
}

/** The slice at u; `begun`, `goesOn`: it is not the leg's first, not its last. */
export function sliceAt(
  curve: Curve,
  radius: Radius,
  { first, last, turns }: Leg,
  u: number,
  begun: boolean,
  goesOn: boolean,
): Slice {
  const [turnBefore, turnAfter] = turns;
  const size = radius(u);
  const slideFrom = (turn: number, away: number): number => {
    if (turn === 0 || isBall(turn)) return 0;
    const slope = sin(turn / 2) / cos(turn / 2);
    // legs share their piece when it is short
    const over = Math.min(SLIDE_OVER * size * Math.abs(slope), (curve.length * (last - first)) / 2);
    return away === 0 ? slope : slope * Math.max(1 - (away * curve.length) / over, 0);
  };
  const flare = slopeIn(radius, first, u, last) / (curve.length || 1);
  return {
    point: curve.point(u),
    tangent: tangentAt(curve, u, goesOn ? 1 : -1),
    radius: size,
    flare,
    bend: flare === 0 ? 0 : bendIn(curve, first, u, last),
    slide: slideFrom(turnBefore, u - first) - slideFrom(turnAfter, last - u),
    joined: begun || isBall(turnBefore),
    at: { u: fromStart(curve, u), side: goesOn ? 1 : -1 },
  };
}

/** Rings that turn about a corner too sharp for a mitre, without those of the two legs. */
export function ballJoint(arriving: Slice, turn: number, around: number): Slice[] {
  if (!isBall(turn)) return [];
  const steps = Math.max(Math.ceil((Math.abs(turn) / TAU) * around), 2);
  const [x, y] = arriving.tangent;
  return Array.from({ length: steps - 1 }, (_, i) => {
    const angle = (turn * (i + 1)) / steps;
    const tangent: Vec2 = [x * cos(angle) - y * sin(angle), x * sin(angle) + y * cos(angle)];
    const at: RowAt = { u: arriving.at.u, side: 2 * i < steps - 1 ? -1 : 1, rigid: true };
    return { ...arriving, tangent, flare: 0, bend: 0, slide: 0, joined: true, at };
  });
}

/** df/du inside a piece, central where there is room. */
function slopeIn(f: (u: number) => number, first: number, u: number, last: number): number {
  const from = Math.max(u - STEP, first);
  const to = Math.min(u + STEP, last);
  return to > from ? (f(to) - f(from)) / (to - from) : 0;
}

/** Signed curvature per mm, inside a piece. */
export function bendIn(curve: Curve, first: number, u: number, last: number): number {
  const from = Math.max(u - STEP, first);
  const to = Math.min(u + STEP, last);
  const before = tangentAt(curve, from, 1);
  const after = tangentAt(curve, to, -1);
  const angle = atan2(cross2(before, after), dot2(before, after));
  return to > from && curve.length > 0 ? angle / ((to - from) * curve.length) : 0;
}

/** The unit tangent; a dot has none, and points to the right. */
export function tangentAt(curve: Curve, u: number, side: -1 | 1): Vec2 {
  const tangent = curve.tangent(u, side);
  return dot2(tangent, tangent) > 0.5 ? tangent : [1, 0];
}
