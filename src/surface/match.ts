/**
 * Which point of one side belongs to which of the other, exactly: ends, crossings and corners.
 *
 * After arc-length parametrisation the corners of two strokes never fall on the same u; blended as they are, a
 * candle gets slanted double creases. So corners are matched like two words are aligned (least sum of costs, in
 * order), and u is stretched piecewise linearly between matches, so that a crease runs straight across.
 * Crossings are matched too: there the sides meet in a point instead of missing each other.
 */
import { atan2, PI } from '../math/trig.ts';
import { cross2, dot2 } from '../math/tuple.ts';
import { crossings, type Match } from './crossings.ts';
import type { Side } from './side.ts';

export interface Anchor extends Match {
  readonly crossing: boolean;
}

/** strokes that cross this near to both their ends are trimmed there: nobody draws a tip that small on purpose */
const TRIM = 0.03;
/** crossings nearer to each other than this part of a stroke are noise between strokes that run together */
const SHORTEST = 0.005;
/** between crossings one side may run this many times faster than the other */
const STRETCH = 6;
/** cost of leaving a corner alone: two corners farther apart than twice this part of their piece do not match */
const ALONE = 0.125;
/** cost of matching corners whose turns differ by π */
const TURN = 0.1;

/** Ends, crossings and matched corners, ascending in both parameters. `pinched`: the ends are one crossing. */
export function matchSides(l: Side, r: Side, pinched: boolean): Anchor[] {
  const found = crossings(l, r);
  const head = (pinched ? null : found.find(({ a, b }) => Math.max(a, b) < TRIM)) ?? { a: 0, b: 0 };
  const tail = (pinched ? null : found.findLast(({ a, b }) => Math.min(a, b) > 1 - TRIM)) ?? { a: 1, b: 1 };
  const chain = longestChain(found, head, tail);
  const pins: Anchor[] = [
    { ...head, crossing: pinched || head.a + head.b > 0 },
    ...chain.map((match) => ({ ...match, crossing: true })),
    { ...tail, crossing: pinched || tail.a + tail.b < 2 },
  ];
  return pins.flatMap((pin, i) => {
    const following = pins[i + 1];
    return following ? [pin, ...matchCorners(l, r, pin, following)] : [pin];
  });
}

/** The most crossings that can be kept in order without stretching a side too much. */
function longestChain(found: readonly Match[], head: Match, tail: Match): Match[] {
  const nodes = [head, ...found, tail];
  const chains: (Match[] | null)[] = [[]];
  for (let i = 1; i < nodes.length; i++) {
    let best: Match[] | null = null;
    for (let j = 0; j < i; j++) {
      const before = chains[j];
      if (!before || !follows(nodes[j]!, nodes[i]!)) continue;
      if (!best || before.length + 1 > best.length) best = [...before, nodes[i]!];
    }
    chains.push(best);
  }
  return chains[nodes.length - 1]?.slice(0, -1) ?? [];
}

function follows(before: Match, after: Match): boolean {
  const a = after.a - before.a;
  const b = after.b - before.b;
  return a > SHORTEST && b > SHORTEST && a < STRETCH * b && b < STRETCH * a;
}

/** Alignment of the corners between two pins by dynamic programming. */
function matchCorners(l: Side, r: Side, from: Match, to: Match): Anchor[] {
  const as = l.corners.filter((u) => u > from.a && u < to.a);
  const bs = r.corners.filter((u) => u > from.b && u < to.b);
  // once each, not once a pair: a hatch has thousands
  const turns = { a: as.map((u) => turn(l, u)), b: bs.map((u) => turn(r, u)) };
  const cost = (i: number, j: number): number => {
    const away = Math.abs((as[i]! - from.a) / (to.a - from.a) - (bs[j]! - from.b) / (to.b - from.b));
    return away + (TURN * Math.abs(turns.a[i]! - turns.b[j]!)) / PI;
  };
  const table = as.map(() => bs.map(() => 0));
  const rest = (i: number, j: number): number =>
    i < as.length && j < bs.length ? table[i]![j]! : ALONE * (as.length - i + bs.length - j);
  for (let i = as.length - 1; i >= 0; i--) {
    for (let j = bs.length - 1; j >= 0; j--) {
      const together = cost(i, j) + rest(i + 1, j + 1);
      table[i]![j] = Math.min(together, ALONE + rest(i + 1, j), ALONE + rest(i, j + 1));
    }
  }
  const found: Anchor[] = [];
  for (let i = 0, j = 0; i < as.length && j < bs.length; ) {
    if (rest(i, j) === ALONE + rest(i + 1, j)) i++;
    else if (rest(i, j) === ALONE + rest(i, j + 1)) j++;
    else found.push({ a: as[i++]!, b: bs[j++]!, crossing: false });
  }
  return found;
}

/** How far a side turns at a corner, 0 … π. */
function turn(side: Side, u: number): number {
  const before = side.derivative(u, -1);
  const after = side.derivative(u, 1);
  return Math.abs(atan2(cross2(before, after), dot2(before, after)));
}
