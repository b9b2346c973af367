/**
 * How often loops go round a point, and the area that they go round: what bounds on the field of a plate need.
 *
 * Drawn outlines cross themselves. The area that is left when backward lobes are subtracted says nothing of what one lobe
 * does beside itself, and where an outline goes round twice the plate is worth two.
 */
import { cross2, sub2 } from '../math/tuple.ts';
import type { Vec2 } from '../math/vec.ts';

type Loop = readonly Vec2[];

export interface Winding {
  /** the largest number of times, either way round; not less than it is */
  readonly turns: number;
  /** of all places, as often as the loops go round them; not less than it is */
  readonly covered: number;
  /** surely no place is gone round the other way */
  readonly isOneWay: boolean;
}

/** Exact for an outline with holes in it where nothing touches; `area` is theirs. */
export function windingOf(loops: readonly Loop[], area: number): Winding {
  if (isTidy(loops)) return { turns: 1, covered: area, isOneWay: true };
  // a straight line meets a chain that only rises or only falls once, and each turn twice
  const chains = (axis: 0 | 1) => loops.reduce((sum, loop) => sum + chainsOf(loop, axis), 0);
  const turns = Math.min(chains(0), chains(1)) / 2;
  const fan = (loop: Loop) => loop.reduce((sum, p, i) => sum + Math.abs(cross2(loop.at(i - 1)!, p)) / 2, 0);
  return { turns, covered: loops.reduce((sum, loop) => sum + fan(loop), 0), isOneWay: false };
}

function isTidy(loops: readonly Loop[]): boolean {
  if (anyMeet(loops.flatMap((loop) => loop.map((b, i): Edge => [loop.at(i - 1)!, b])))) return false;
  const [outline, ...holes] = loops;
  return holes.every((hole) => {
    const around = holes.some((other) => other !== hole && holds(other, hole[0]!));
    return holds(outline!, hole[0]!) && !around;
  });
}

type Edge = readonly [Vec2, Vec2];

const low = ([a, b]: Edge, axis: 0 | 1) => Math.min(a[axis], b[axis]);
const high = ([a, b]: Edge, axis: 0 | 1) => Math.max(a[axis], b[axis]);

/** From left to right: an edge meets none that begins beyond its end. */
function anyMeet(edges: readonly Edge[]): boolean {
  const sorted = [...edges].sort((e, f) => low(e, 0) - low(f, 0));
  return sorted.some((edge, i) => {
    const end = high(edge, 0);
    for (let j = i + 1; j < sorted.length && low(sorted[j]!, 0) <= end; j++) {
      if (meet(edge, sorted[j]!)) return true;
    }
    return false;
  });
}

/** Of two that share a stretch of x. Neighbours, which share a vertex, do not count; a touch does. */
function meet(e: Edge, f: Edge): boolean {
  const [[a, b], [c, d]] = [e, f];
  if (a === d || b === c || high(e, 1) < low(f, 1) || high(f, 1) < low(e, 1)) return false;
  const [ab, cd] = [sub2(b, a), sub2(d, c)];
  const apart = (along: Vec2, p: Vec2, q: Vec2) => cross2(along, p) * cross2(along, q) > 0;
  return !apart(ab, sub2(c, a), sub2(d, a)) && !apart(cd, sub2(a, c), sub2(b, c));
}

function holds(loop: Loop, [x, y]: Vec2): boolean {
  return loop.reduce((inside, [bx, by], i) => {
    const [ax, ay] = loop.at(i - 1)!;
    if (ay > y === by > y) return inside;
    return ax + ((y - ay) * (bx - ax)) / (by - ay) > x ? !inside : inside;
  }, false);
}

/** Parts of a loop along which the coordinate only rises or only falls. */
function chainsOf(loop: Loop, axis: 0 | 1): number {
  const ways = loop.map((p, i) => p[axis] - loop.at(i - 1)![axis]).filter((step) => step !== 0);
  return ways.filter((step, i) => step > 0 !== ways.at(i - 1)! > 0).length;
}
