/**
 * The axis l(u) of a sheet as the side view shows it: its centres c(u) projected along V, with the distance s(u) walked
 * on it and a direction T_l(u) that never vanishes (thesis 6.1: T_l is l′/|l′|, undefined where centres stand still).
 *
 * Two ways of walking. Along the path: s is the arc length of l, so that d = l moves nothing. Along a line: when l is
 * straight to 5 % but turns back, stands still or swings about (a U seen from its side, a ring edge-on), and for rings
 * bent by an open stroke, s is the advance along that line, T_l its direction, and what sticks out of the line is part of
 * the section. Arc length would unroll the U and fold its sections at the turn. Exactly straight ways are both.
 */
import { once } from '../math/once.ts';
import type { Plane } from '../math/plane.ts';
import { atan2, cos, sin } from '../math/trig.ts';
import { add2, cross2, distance2, dot2, length2, scale2, sub2 } from '../math/tuple.ts';
import type { Vec2, Vec3 } from '../math/vec.ts';
import { arcTable } from './arcTable.ts';
import type { Spine } from './sheet.ts';
import { type Side2, sideView } from './sideView.ts';

export interface Axis {
  /** mm of way, above 0 */
  readonly length: number;
  /** where the way is at 0 and at `length`, mm in the side view */
  readonly ends: readonly [Vec2, Vec2];
  /** T_l is the same everywhere */
  readonly straight: boolean;
  /** the way closes on itself */
  readonly closed: boolean;
  /** ascending u between which all is smooth */
  readonly breaks: readonly number[];
  /** `side`: at a break, the directions before (−1) or after (1) it */
  at(u: number, side: -1 | 1): AxisPoint;
}

/** Each is computed when asked for: of spines bent one on another hardly more than one is needed at a time. */
export interface AxisPoint {
  /** mm walked, 0 … length */
  walked(): number;
  /** its derivative by u; negative where the way turns back */
  speed(): number;
  /** the point of the axis to which the section belongs, mm, and its derivative by u */
  point(): Vec2;
  rate(): Vec2;
  /** T_l, unit */
  direction(): Vec2;
}

/** A place on l. */
interface Probe {
  readonly u: number;
  readonly side: -1 | 1;
  readonly l: Vec2;
  readonly rate: Vec2;
}

/** l is straight when it strays from a line by this part of its extent */
const STRAIGHT = 0.05;
/** … and one with the line when it strays by no more than rounding */
const EXACT = 1e-12;
/** cosine of the swing (30°) that leaves l′ as the direction of a straight l */
const QUIET = 0.866;
/** seen from an end: a view that shows less than this part of the way */
const END_ON = 0.02;
/** slower than this part of the mean, l stands still */
const STILL = 1e-4;
/** … and this slow its direction is rounding */
const NOISE = 1e-9;
/** cosine of the turn (120°) between neighbouring probes that is a turning back */
const BACK = -0.5;
/** probes of the whole way, and of a piece at least */
const PROBES = 160;
const FEWEST = 9;

/** The axis in the side view `plane` (in the coordinates of the sheet), or null when it is seen end-on or has no length. */
export function bendAxis(spine: Spine, plane: Plane, closedStroke = false): Axis | null {
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

function probesOf(spine: Spine, view: Side2): Probe[] {
  return spine.stops.slice(1).flatMap((to, i) => {
    const from = spine.stops[i]!;
    const count = Math.max(Math.ceil(PROBES * (to - from)), FEWEST);
    return Array.from({ length: count + 1 }, (_, k) => {
      const side = k === count ? -1 : 1;
      return probe(spine, view, k === count ? to : from + ((to - from) * k) / count, side);
    });
  });
}

function probe(spine: Spine, view: Side2, u: number, side: -1 | 1): Probe {
  const { centre, rate } = spine.at(u, side);
  return { u, side, l: view.point(centre), rate: view.flat(rate) };
}

/** The diagonal of the box, mm. */
function extentOf(probes: readonly Probe[]): number {
  return extent(probes.map(({ l }) => [l[0], l[1], 0]));
}

function depthOf(spine: Spine): number {
  return extent(Array.from({ length: 33 }, (_, i) => spine.at(i / 32, i === 32 ? -1 : 1).centre));
}

function extent(points: readonly Vec3[]): number {
  const sides = ([0, 1, 2] as const).map((k) => {
    const xs = points.map((p) => p[k]);
    return Math.max(...xs) - Math.min(...xs);
  });
  return Math.sqrt(sides.reduce((sum, side) => sum + side * side, 0));
}

/** What l is when looked at as a line. */
interface Way {
  /** unit, from start to end */
  readonly along: Vec2;
  readonly straight: boolean;
  readonly exact: boolean;
  /** l′ is everywhere about along the line */
  readonly quiet: boolean;
}

function lineOf(probes: readonly Probe[], extent: number, closed: boolean): Way {
  const chord = sub2(probes[probes.length - 1]!.l, probes[0]!.l);
  const along =
    !closed && length2(chord) > 0.5 * extent ? scale2(chord, 1 / length2(chord)) : longest(probes);
  const across = probes.map(({ l }) => cross2(along, l));
  const stray = (Math.max(...across) - Math.min(...across)) / extent;
  const quiet = probes.every(({ rate }) => {
    const speed = length2(rate);
    return speed > STILL * extent && dot2(rate, along) >= QUIET * speed;
  });
  return { along, straight: stray <= STRAIGHT, exact: stray <= EXACT, quiet };
}

/** The direction in which the points are spread most, pointing as the way does first. */
function longest(probes: readonly Probe[]): Vec2 {
  const n = probes.length;
  const mean = scale2(
    probes.reduce<Vec2>((sum, { l }) => add2(sum, l), [0, 0]),
    1 / n,
  );
  let [xx, xy, yy] = [0, 0, 0];
  for (const { l } of probes) {
    const [x, y] = sub2(l, mean);
    xx += x * x;
    xy += x * y;
    yy += y * y;
  }
  const angle = 0.5 * atan2(2 * xy, xx - yy);
  const along: Vec2 = [cos(angle), sin(angle)];
  const places = probes.map(({ l }) => dot2(along, l));
  const forth = places.indexOf(Math.max(...places)) >= places.indexOf(Math.min(...places));
  return forth ? along : scale2(along, -1);
}

/** Advance along a line; what sticks out of the line belongs to the section. */
function lineAxis(spine: Spine, view: Side2, along: Vec2, probes: readonly Probe[]): Axis {
  const places = probes.map(({ l }) => dot2(along, l));
  const from = Math.min(...places);
  const length = Math.max(...places) - from;
  const middle = probes.reduce((sum, { l }) => sum + cross2(along, l), 0) / probes.length;
  const across: Vec2 = [-along[1], along[0]];
  const on = (place: number): Vec2 => add2(scale2(along, place), scale2(across, middle));
  return {
    length,
    ends: [on(from), on(from + length)],
    straight: true,
    closed: false,
    breaks: spine.stops,
    at: (u, side) => {
      const station = spine.at(u, side);
      const place = once(() => dot2(along, view.point(station.centre)));
      const speed = once(() => dot2(along, view.flat(station.rate)));
      return {
        walked: () => place() - from,
        speed,
        point: once(() => on(place())),
        rate: once(() => scale2(along, speed())),
        direction: () => along,
      };
    },
  };
}

/** A stretch on which l stands still or turns back: its direction is led from one end to the other. */
interface Hold {
  readonly from: number;
  readonly to: number;
  readonly start: Vec2;
  /** radians */
  readonly turn: number;
  /** whether l goes the other way afterwards */
  readonly back: boolean;
}

function pathAxis(spine: Spine, view: Side2, probes: readonly Probe[], closed: boolean): Axis {
  const mean = wayOf(probes);
  const holds = holdsOf(probes, STILL * mean);
  const rateAt = (u: number, side: -1 | 1): Vec2 => view.flat(spine.at(u, side).rate);
  const direction = (u: number, side: -1 | 1, rate: Vec2): Vec2 => {
    const hold = holdAt(holds, u);
    if (hold) return turned(hold.start, (hold.turn * (u - hold.from)) / (hold.to - hold.from));
    const moving = movingRate(rateAt, rate, u, side, spine.stops, NOISE * mean);
    return scale2(moving, signAt(holds, u) / (length2(moving) || 1));
  };
  const speed = (u: number, side: -1 | 1, rate: Vec2): number =>
    holdAt(holds, u) ? dot2(rate, direction(u, side, rate)) : signAt(holds, u) * length2(rate);
  const edges = holds.flatMap(({ from, to }) => [from, to]);
  const breaks = [...new Set([...spine.stops, ...edges])].sort((a, b) => a - b);
  const table = arcTable((u) => speed(u, 1, rateAt(u, 1)), breaks);
  return {
    length: table.most - table.least,
    ends: [probes[0]!.l, probes[probes.length - 1]!.l],
    straight: false,
    closed,
    breaks,
    at: (u, side) => {
      const station = spine.at(u, side);
      const rate = once(() => view.flat(station.rate));
      return {
        walked: () => table.upTo(u) - table.least,
        speed: once(() => speed(u, side, rate())),
        point: once(() => view.point(station.centre)),
        rate,
        direction: once(() => direction(u, side, rate())),
      };
    },
  };
}

function wayOf(probes: readonly Probe[]): number {
  return probes.reduce((sum, { l }, i) => sum + (i > 0 ? distance2(l, probes[i - 1]!.l) : 0), 0);
}

function holdsOf(probes: readonly Probe[], still: number): Hold[] {
  const holds: Hold[] = [];
  let sign = 1;
  let before: Probe | null = null;
  let between = 0;
  for (const here of probes) {
    if (!(length2(here.rate) > still)) {
      between++;
      continue;
    }
    const to = scale2(here.rate, sign / length2(here.rate));
    if (before === null) {
      if (between > 1) holds.push({ from: 0, to: here.u, start: to, turn: 0, back: false });
    } else {
      const start = scale2(before.rate, sign / length2(before.rate));
      const corner = before.u === here.u;
      const back = !corner && dot2(start, to) < BACK;
      if (back || (between > 1 && here.u > before.u)) {
        const end = back ? scale2(to, -1) : to;
        const turn = atan2(cross2(start, end), dot2(start, end));
        holds.push({ from: before.u, to: here.u, start, turn, back });
        if (back) sign = -sign;
      }
    }
    before = here;
    between = 0;
  }
  if (before !== null && between > 1) {
    const start = scale2(before.rate, sign / length2(before.rate));
    holds.push({ from: before.u, to: 1, start, turn: 0, back: false });
  }
  return holds;
}

function holdAt(holds: readonly Hold[], u: number): Hold | undefined {
  return holds.find(({ from, to }) => u > from && u < to);
}

function signAt(holds: readonly Hold[], u: number): 1 | -1 {
  return holds.filter(({ to, back }) => back && to <= u).length % 2 === 0 ? 1 : -1;
}

/** l′ at u, or a little further inside the piece where it vanishes (poles). */
function movingRate(
  rateAt: (u: number, side: -1 | 1) => Vec2,
  here: Vec2,
  u: number,
  side: -1 | 1,
  stops: readonly number[],
  still: number,
): Vec2 {
  if (length2(here) > still) return here;
  const edge = side === 1 ? stops.find((stop) => stop > u) : stops.findLast((stop) => stop < u);
  for (const part of [1e-6, 1e-4, 1e-2, 0.1]) {
    const inside = rateAt(u + part * ((edge ?? u) - u), side);
    if (length2(inside) > still) return inside;
  }
  return [1, 0];
}

function turned([x, y]: Vec2, angle: number): Vec2 {
  const [c, s] = [cos(angle), sin(angle)];
  return [c * x - s * y, s * x + c * y];
}
