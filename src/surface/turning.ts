/**
 * How finely a section must be cut for what is drawn on it: by the angle through which it turns, whichever way, as a circle of the
 * wished number is. Lengths alone give a bump as little as a straight piece of its size: 64 quads miss twelve bumps by 7 % of the half chord.
 */
import { atan2, TAU } from '../math/trig.ts';
import { cross2, dot2, sub2 } from '../math/tuple.ts';
import type { Vec2 } from '../math/vec.ts';

/** chords of an outline, and of a piece of it at least */
const LOOKS = 256;
const FEWEST = 24;
/** what is drawn costs at most so many times the wished number: a scribble turns without end */
const MOST = 6;

/** Radians, to the left and to the right alike, between two v; corners at them do not count. */
export function turnOf(point: (v: number) => Vec2, from: number, to: number): number {
  const count = Math.max(Math.ceil(LOOKS * (to - from)), FEWEST);
  let sum = 0;
  let at = point(from);
  let before: Vec2 = [0, 0];
  for (let i = 1; i <= count; i++) {
    const next = point(i === count ? to : from + ((to - from) * i) / count);
    const way = sub2(next, at);
    sum += Math.abs(atan2(cross2(before, way), dot2(before, way)));
    [at, before] = [next, way];
  }
  return sum;
}

/** Pieces of a section at least, each `coarser` times as wide in angle as those of a circle of `wish`. */
export function leastPieces(turns: readonly number[], wish: number, coarser: number): number[] {
  const found = turns.map((turn) => (turn * wish) / (coarser * TAU));
  const whole = found.reduce((sum, count) => sum + count, 0);
  const part = whole > MOST * wish ? (MOST * wish) / whole : 1;
  return found.map((count) => Math.ceil(part * count - ROUNDING));
}

/** of pieces */
const ROUNDING = 1e-6;
