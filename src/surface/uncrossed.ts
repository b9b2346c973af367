/**
 * A closed outline that crosses itself, walked so that it only touches itself: round all that it goes round an odd number of times,
 * front first. Where front and back cross they change places, which makes the upper the front and the lower the back; a front that
 * loops over itself runs through its loop the other way round. Nothing is enclosed backwards then, so nothing is inside out.
 *
 * Between crossings every second stretch of a closed curve has what is odd on its other side (Gauss), so that these are turned
 * round; at a crossing the stretches are joined up without crossing, in that of the two ways which leaves one line. Where it touches
 * itself it is cut short by a web, as mirrored fronts are (joined.ts), with creases: a solid that touches itself is none.
 *
 * Crossings are those of chords, which lie up to 1e-4 off the curve: of 2,000 outlines by lot seven kept slivers up to .008 wide.
 */
import { cross2, length2, mix2, scale2, sub2 } from '../math/tuple.ts';
import type { Vec2 } from '../math/vec.ts';
import type { Outline } from './outline.ts';
import { type Pass, selfCrossings } from './selfCrossings.ts';

/** half chords from a crossing to where it is cut short, on each of its four stretches */
const SHORT = 2e-3;
/** … where a stretch ends in it, so many times */
const LONGER = 1.1;
/** … but no more of a stretch than this */
const MOST = 0.25;
/** a scribble of more crossings stays as it was drawn */
const MOST_CROSSINGS = 100;
/** chords of a stretch by which areas are told */
const CHORDS = 64;
/** squared half chords: less is rounding */
const NO_AREA = 1e-9;
/** v nearer than this are one */
const SAME = 1e-10;

/** The outline itself where it crosses nothing and runs the right way. q_l stays at v = 0, q_r at ½. */
export function uncrossed(outline: Outline): Outline {
  const passes = selfCrossings(outline);
  if (passes.length > 2 * MOST_CROSSINGS) return outline;
  const ring = ringOf(passes);
  const area = ring.reduce((sum, part) => sum + (part.isTurned ? -1 : 1) * areaOf(outline, part), 0);
  if (passes.length === 0 && area <= NO_AREA) return outline;
  const parts = area > 0 ? ring.map((part) => ({ ...part, isTurned: !part.isTurned })) : ring;
  return pieced(outline, walk(parts));
}

/** A stretch between crossings, q_l and q_r, v ascending. */
interface Part {
  readonly from: number;
  readonly to: number;
  readonly isTurned: boolean;
  /** the part that begins where the crossing at `from` is passed the other time; null at q_l and q_r */
  readonly crossing: number | null;
}

function ringOf(passes: readonly Pass[]): Part[] {
  const ends: readonly Pass[] = [0, 0.5].map((v) => ({ v, other: -1 }));
  const starts = [...passes, ...ends].sort((a, b) => a.v - b.v);
  let isTurned = false;
  return starts.map((start, i) => {
    const other = start.other < 0 ? -1 : starts.indexOf(passes[start.other]!);
    if (other >= 0) isTurned = !isTurned;
    return {
      from: start.v,
      to: starts[i + 1]?.v ?? 1,
      isTurned,
      crossing: other < 0 ? null : other,
    };
  });
}

/** Positive when counter-clockwise, about the origin. */
function areaOf({ point }: Outline, { from, to }: Part): number {
  let sum = 0;
  let before = point(from);
  for (let i = 1; i <= CHORDS; i++) {
    const next = point(from + ((to - from) * i) / CHORDS);
    sum += cross2(before, next) / 2;
    before = next;
  }
  return sum;
}

/** A stretch as the new outline walks it. */
interface Step {
  readonly from: number;
  readonly to: number;
}

/** All parts, from q_l to q_l. Ends of parts: 2k is where part k begins, 2k + 1 where it ends. */
function walk(parts: readonly Part[]): Step[] {
  const mates = matesOf(parts);
  const start = parts[0]!.isTurned ? 2 * parts.length - 1 : 0;
  const steps: Step[] = [];
  let end = start;
  do {
    const { from, to } = parts[end >> 1]!;
    steps.push(end % 2 === 0 ? { from, to } : { from: to, to: from });
    end = mates[end ^ 1]!;
  } while (end !== start);
  return steps;
}

/** Which end goes on at which, so that all of it is one line. */
function matesOf(parts: readonly Part[]): number[] {
  const mates = new Array<number>(2 * parts.length);
  const join = (a: number, b: number): void => {
    mates[a] = b;
    mates[b] = a;
  };
  const before = (k: number): number => 2 * ((k || parts.length) - 1) + 1;
  parts.forEach(({ crossing }, k) => {
    if (crossing === null) join(before(k), 2 * k);
    else if (k < crossing) {
      join(before(k), before(crossing));
      join(2 * k, 2 * crossing);
    }
  });
  const isOne = (a: number, b: number): boolean => {
    for (let end = mates[a ^ 1]!; ; end = mates[end ^ 1]!) {
      if (end === b || end === (b ^ 1)) return true;
      if (end === a) return false;
    }
  };
  parts.forEach(({ crossing }, k) => {
    if (crossing === null || crossing < k || isOne(before(k), 2 * k)) return;
    join(before(k), 2 * crossing);
    join(before(crossing), 2 * k);
  });
  return mates;
}

/** A stretch of v, on the old outline or on a web. */
interface Piece {
  readonly from: number;
  readonly to: number;
  /** v of its corners, its ends aside, and where the old outline has them */
  readonly corners: readonly { readonly v: number; readonly old: number }[];
  point(v: number): Vec2;
  derivative(v: number, side: -1 | 1): Vec2;
}

function pieced(outline: Outline, steps: readonly Step[]): Outline {
  const middle = steps.findIndex(({ to }) => to === 0.5) + 1;
  const pieces = [
    ...halfOf(outline, steps.slice(0, middle), 0),
    ...halfOf(outline, steps.slice(middle), 0.5),
  ];
  const webs = pieces.slice(1).map(({ from }) => from);
  return {
    closed: true,
    corners: [
      ...outline.corners.filter((v) => v === 0 || v === 0.5),
      ...webs.filter((v) => v !== 0.5),
      ...pieces.flatMap(({ corners }) => corners.map(({ v }) => v)),
    ].sort((a, b) => a - b),
    point: (v) => {
      const at = v - Math.floor(v);
      return pieces.findLast(({ from }) => from <= at)!.point(at);
    },
    derivative: (v, side) => {
      const at = v === 1 && side === -1 ? 1 : v - Math.floor(v);
      if (side === 1) return pieces.findLast(({ from }) => from <= at + SAME)!.derivative(at, side);
      const back = at <= SAME ? 1 : at;
      return pieces.find(({ to }) => to >= back - SAME)!.derivative(back, side);
    },
  };
}

/** The front (`start` 0) or the back (½): as much of v for every step as it has of the old. */
function halfOf(outline: Outline, all: readonly Step[], start: 0 | 0.5): Piece[] {
  const steps = all.filter(({ from, to }) => Math.abs(to - from) > SAME);
  const whole = steps.reduce((sum, { from, to }) => sum + Math.abs(to - from), 0);
  const pieces: Piece[] = [];
  let done = 0;
  steps.forEach((step, i) => {
    const span = Math.abs(step.to - step.from);
    const cutFrom = i > 0 ? cutAt(outline, step.from, step) : 0;
    const cutTo = i < steps.length - 1 ? cutAt(outline, step.to, step) : 0;
    const vAt = (share: number): number => start + (0.5 * share) / whole;
    const from = i > 0 ? vAt(done + cutFrom) : start;
    const to = i < steps.length - 1 ? vAt(done + span - cutTo) : start + 0.5;
    const turn = step.to > step.from ? 1 : -1;
    const piece = stretchOf(outline, step.from + turn * cutFrom, step.to - turn * cutTo, from, to);
    const before = pieces[pieces.length - 1];
    if (before) pieces.push(webOf(before, piece));
    pieces.push(piece);
    done += span;
  });
  return pieces;
}

/** v of the old outline that are cut off a step at one of its ends. */
function cutAt(outline: Outline, v: number, { from, to }: Step): number {
  const side = v === Math.min(from, to) ? 1 : -1;
  const most = MOST * Math.abs(to - from);
  // webs at both ends of a spike, which runs back on itself, must not meet
  const short = v === from ? SHORT : LONGER * SHORT;
  return Math.min(short / length2(outline.derivative(v, side)), most);
}

function stretchOf(outline: Outline, first: number, last: number, from: number, to: number): Piece {
  const pace = (last - first) / (to - from);
  const [low, high] = [Math.min(first, last), Math.max(first, last)];
  const corners = outline.corners
    .filter((old) => old > low + SAME && old < high - SAME)
    .map((old) => ({ old, v: from + (old - first) / pace }));
  const oldOf = (v: number): number => {
    if (v <= from + SAME || v >= to - SAME) return v <= from + SAME ? first : last;
    return corners.find((corner) => Math.abs(corner.v - v) < SAME)?.old ?? first + (v - from) * pace;
  };
  return {
    from,
    to,
    corners,
    point: (v) => outline.point(oldOf(v)),
    derivative: (v, side) =>
      scale2(outline.derivative(oldOf(v), pace > 0 ? side : side === 1 ? -1 : 1), pace),
  };
}

/** Straight on to where the outline goes on. */
function webOf(before: Piece, after: Piece): Piece {
  const { to: from } = before;
  const { from: to } = after;
  const [p, q] = [before.point(from), after.point(to)];
  const rate = scale2(sub2(q, p), 1 / (to - from));
  return {
    from,
    to,
    corners: [],
    point: (v) => mix2(p, q, (v - from) / (to - from)),
    derivative: () => rate,
  };
}
