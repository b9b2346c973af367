/**
 * What sections are carried along, one stroke or two, seen alike: a stand at every u, and stops at which rows must lie.
 */
import { add2, scale2, sub2 } from '../math/tuple.ts';
import type { Vec2 } from '../math/vec.ts';
import type { Curve } from '../stroke/curve.ts';
import { type Pair, pairCurves, type Stop } from './pair.ts';
import { ringAt } from './ring.ts';
import { pieceAt, pieces } from './rows.ts';
import type { RowAt, Spine } from './sheet.ts';
import { ON_CORNER } from './side.ts';
import { ballJoint, isBall, jointQuads, type Leg, type Slice, sliceAt, stopsOf, turnsAt } from './slices.ts';
import { pairSpine, strokeSpine } from './spine.ts';
import type { Stand } from './stand.ts';
import { flattened, LEAST_SPEED, radiusOf } from './tube.ts';

export interface SourceInput {
  /** one or two, on one plane */
  readonly curves: readonly Curve[];
  /** of half a chord on a single stroke, mm, above 0 */
  readonly radius: number;
  /** the pen's pressure changes it */
  readonly pressure: boolean;
}

export interface Source {
  /** u = 1 is u = 0 */
  readonly closed: boolean;
  /** mm; 0 where there is nothing to build on */
  readonly length: number;
  /** two strokes: its ends have no tangent out of them that a dome could follow */
  readonly paired: boolean;
  /** ascending from 0 to 1; a `pole` is a tip */
  readonly stops: readonly Stop[];
  readonly spine: Spine;
  /** `side`: at a stop, the stand before (−1) or after (1) it */
  stand(u: number, side: -1 | 1): Stand;
  /** What turns about a stop too sharp for a mitre; `around`: rows of a full turn. Empty at all others. */
  joint(stop: number, around: number): readonly StandRow[];
}

export interface StandRow {
  readonly stand: Stand;
  readonly at: RowAt;
  /** false: at a stop, again in the place of the row before it */
  readonly joined: boolean;
}

interface Known extends Omit<SourceInput, 'curves'> {
  readonly second: Curve | undefined;
  readonly source: Source;
}

const sources = new WeakMap<Curve, readonly Known[]>();
/** of one curve: a stroke alone, and with others that were tried */
const KEPT = 4;

/** The same for the same curves. Throws RangeError for other numbers of curves, and for a radius that is not above 0. */
export function sourceOf(input: SourceInput): Source {
  const { curves, radius, pressure } = input;
  const [first, second] = curves;
  const known = (first && sources.get(first)) ?? [];
  const isIt = (other: Known) =>
    other.second === second && other.radius === radius && other.pressure === pressure;
  const found = curves.length <= 2 ? known.find(isIt) : undefined;
  if (found) return found.source;
  const source = made(input);
  sources.set(first!, [{ second, radius, pressure, source }, ...known].slice(0, KEPT));
  return source;
}

function made({ curves, radius, pressure }: SourceInput): Source {
  const [first, second] = curves;
  if (!first || curves.length > 2) {
    throw new RangeError(`surface: sections are carried along 1 or 2 strokes, got ${curves.length}`);
  }
  return second
    ? pairSource(pairCurves(first, second))
    : strokeSource(first, radiusOf(first, { radius, pressure }));
}

function pairSource(pair: Pair): Source {
  const poles = pair.stops.filter(({ pole }) => pole).map(({ u }) => u);
  const isPole = (u: number): boolean => poles.some((stop) => Math.abs(stop - u) < ON_CORNER);
  return {
    closed: pair.closed,
    length: pair.length,
    paired: true,
    stops: pair.stops,
    spine: pairSpine(pair),
    stand: (u, side) => ringAt(pair, u, side, isPole(u)),
    joint: () => [],
  };
}

function strokeSource(curve: Curve, radius: (u: number) => number): Source {
  const onCurve = stopsOf(curve);
  const start = onCurve[0]!;
  const stops = onCurve.map((u) => u - start);
  const turns = turnsAt(curve, onCurve);
  const slice = (u: number, side: -1 | 1): Slice => {
    const k = pieceAt(stops, u, side);
    const leg: Leg = { first: onCurve[k]!, last: onCurve[k + 1]!, turns: [turns[k]!, turns[k + 1]!] };
    const found = sliceAt(curve, radius, leg, start + u, u > stops[k]!, u < stops[k + 1]!);
    return !curve.closed && (u <= 0 || u >= 1) ? flattened(found) : found;
  };
  return {
    closed: curve.closed,
    length: curve.length,
    paired: false,
    stops: stops.map((u) => ({ u, pole: false })),
    spine: strokeSpine(curve),
    stand: (u, side) => standOf(slice(u, side)),
    joint: (stop, around) => {
      const turn = turns[stop]!;
      if (!isBall(turn)) return [];
      return ballJoint(slice(stops[stop]!, -1), turn, jointQuads(turns, around)).map((turned) => ({
        stand: standOf(turned),
        at: turned.at,
        joined: true,
      }));
    },
  };
}

/** The left of the stroke is q_l; at a mitre the chord leans into the bisecting plane. */
function standOf({ point, tangent, radius, flare, bend, slide }: Slice): Stand {
  const axis: Vec2 = [-tangent[1], tangent[0]];
  const half = scale2(add2(axis, scale2(tangent, slide)), radius);
  return {
    left: add2(point, half),
    right: sub2(point, half),
    centre: point,
    axis,
    radius,
    dCentre: tangent,
    dHalf: add2(scale2(axis, flare), scale2(tangent, -radius * bend)),
    leastSpeed: LEAST_SPEED,
  };
}

/** Rows from tip to tip (or end to end), about `quads` in all; `around`: quads of a full turn, for ball joints. */
export function standLobes(source: Source, quads: number, around: number): StandRow[][] {
  const { stops, closed } = source;
  const lobes: StandRow[][] = [[]];
  let turned = false;
  const least = (i: number): number => {
    if (stops[i]!.pole && stops[i + 1]!.pole) return 2;
    return closed ? Math.ceil(3 / (stops.length - 1)) : 1;
  };
  pieces(
    stops.map(({ u }) => u),
    quads,
    least,
  ).forEach((us, i) => {
    if (i > 0 && stops[i]!.pole) lobes.push([]);
    const rows = us.map((u, k): StandRow => {
      const side = k === us.length - 1 ? -1 : 1;
      return { stand: source.stand(u, side), at: { u, side }, joined: k > 0 || turned };
    });
    const joint = source.joint(i + 1, around);
    turned = joint.length > 0;
    lobes[lobes.length - 1]!.push(...rows, ...joint);
  });
  const seam = lobes[0]![0];
  if (turned && closed && seam) lobes[lobes.length - 1]!.push({ ...seam, joined: true });
  return lobes;
}
