/**
 * How the sections of surfaces stand and move (sheet.ts): for two strokes the plane of x′ and the drawing plane's n at
 * c = (q_l + q_r)/2, for one stroke the plane across its tangent.
 *
 * The plane turns about n alone: x′ = h/|h| turns by (x′ × h′)/|h|. At tips, where h vanishes, by as much as a little further in.
 */
import { cross2, dot2, scale2 } from '../math/tuple.ts';
import type { Vec2 } from '../math/vec.ts';
import type { Curve } from '../stroke/curve.ts';
import type { Pair } from './pair.ts';
import { ringAt } from './ring.ts';
import { pieceAt } from './rows.ts';
import type { Spine, Station } from './sheet.ts';
import { ON_CORNER } from './side.ts';
import { bendIn, stopsOf, tangentAt } from './slices.ts';

/** how far from a tip, in u, the turning of its section is looked for */
const BEYOND = 1e-4;
/** per unit of u; a chord that shrinks to nothing and swings round turns faster, but no section is drawn there */
const FASTEST = 1e4;
/** places a lobe is looked at for which way it goes */
const LOOKS = 16;

/** Between two strokes. Normals point along u, all along a lobe on the same side of its chords. */
export function pairSpine(pair: Pair): Spine {
  const stops = pair.stops.map(({ u }) => u);
  const poles = pair.stops.filter(({ pole }) => pole).map(({ u }) => u);
  const ends = [...new Set([0, ...poles, 1])];
  const senses = ends.slice(1).map((end, i) => senseOf(pair, ends[i]!, end));
  const at = (u: number, wished: -1 | 1): Station => {
    const side = pair.closed ? wished : u <= 0 ? 1 : u >= 1 ? -1 : wished;
    const pole = poles.some((stop) => Math.abs(stop - u) < ON_CORNER);
    const { axis, centre, dCentre } = ringAt(pair, u, side, pole);
    const sense = senses[pieceAt(ends, u, side)]!;
    return station(centre, dCentre, [sense * axis[1], -sense * axis[0]], turning(pair, u, side, pole));
  };
  return { closed: pair.closed, stops, at };
}

/** Along a stroke; u = 0 of a closed one is its first corner. */
export function strokeSpine(curve: Curve): Spine {
  const onCurve = stopsOf(curve);
  const start = onCurve[0]!;
  const stops = onCurve.map((u) => u - start);
  const at = (u: number, side: -1 | 1): Station => {
    const piece = pieceAt(stops, u, side);
    const tangent = tangentAt(curve, start + u, side);
    const bend = bendIn(curve, onCurve[piece]!, start + u, onCurve[piece + 1]!);
    return station(curve.point(start + u), scale2(tangent, curve.length), tangent, bend * curve.length);
  };
  return { closed: curve.closed, stops, at };
}

function station(centre: Vec2, rate: Vec2, normal: Vec2, spin: number): Station {
  return {
    centre: [centre[0], centre[1], 0],
    rate: [rate[0], rate[1], 0],
    normal: [normal[0], normal[1], 0],
    spin: [0, 0, spin],
  };
}

/** d angle / du of the chord. */
function turning(pair: Pair, u: number, side: -1 | 1, pole: boolean): number {
  const here = ringAt(pair, u, side, pole);
  const inside = Math.min(Math.max(u + side * BEYOND, 0), 1);
  const { axis, dHalf, radius } = here.radius > 0 ? here : ringAt(pair, inside, side, false);
  const turn = radius > 0 ? cross2(axis, dHalf) / radius : 0;
  return Math.min(Math.max(turn, -FASTEST), FASTEST);
}

/** 1: from q_l to q_r turned left is along the lobe's way, as it is where q_l is on the left. */
function senseOf(pair: Pair, from: number, to: number): -1 | 1 {
  let sum = 0;
  for (let i = 0; i < LOOKS; i++) {
    const { axis, dCentre, radius } = ringAt(pair, from + ((to - from) * (i + 0.5)) / LOOKS, 1, false);
    sum += radius * radius * dot2(dCentre, [axis[1], -axis[0]]);
  }
  return sum < 0 ? -1 : 1;
}
