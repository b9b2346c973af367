/**
 * Sections made to go together across: one v on all of them, so that creases run from corner to corner.
 *
 * q_l, q_r (v = 0, ½ of closed outlines; 0, 1 of open ones) stay where they are. Between them the corners of all
 * sections are matched in order when those that have any have equally many, and meet at their mean v; v is stretched smoothly
 * in between (monotone.ts). Sections without corners there keep theirs, and are smooth across the crease, which fades away
 * towards them. Where counts disagree every corner is a crease at its own v.
 */
import { length2, scale2 } from '../math/tuple.ts';
import type { Vec2 } from '../math/vec.ts';
import { IN_BREAK } from './knots.ts';
import { ascending } from './monotone.ts';
import type { Outline } from './outline.ts';

/** One outline between two creases. */
export interface Along {
  /** at the common v, from crease to crease */
  point(v: number): Vec2;
  /** by the common v; on a crease, of this side */
  derivative(v: number): Vec2;
}

export interface AlikePiece {
  readonly from: number;
  /** of closed outlines it may be above 1, as far as `from` once more round */
  readonly to: number;
  /** in the order of the outlines given */
  readonly along: readonly Along[];
}

export interface Alike {
  readonly closed: boolean;
  /** closed, and no crease: one piece that goes on in itself */
  readonly seamless: boolean;
  /** in order of v */
  readonly pieces: readonly AlikePiece[];
}

/** v nearer to each other are one */
const SAME = 1e-6;
/** v at which speeds next to a place are taken */
const BESIDE = 1e-5;
/** part by which they may differ in one smooth curve */
const SPEEDS_ALIKE = 0.05;

/** RangeError when open and closed outlines are mixed. */
export function alike(outlines: readonly Outline[]): Alike {
  const closed = outlines[0]?.closed ?? false;
  if (outlines.some((outline) => outline.closed !== closed)) {
    throw new RangeError('surface: sections must be all open or all closed');
  }
  const still = closed ? [0, 0.5, 1] : [0, 1];
  const parts = still.slice(1).map((to, i) => common(outlines, still[i]!, to));
  const atStill = still
    .slice(0, -1)
    .filter(
      (end) =>
        !closed ||
        parts.some(({ places }) => places.some((v) => isBeside(v, end))) ||
        outlines.some((o) => cornersAt(o, end) || changesSpeed(o, end)),
    );
  const creases = [...parts.flatMap(({ places }) => places), ...atStill].sort((a, b) => a - b);
  const seamless = creases.length === 0;
  const breaks = seamless ? [0, 1] : [...creases, closed ? creases[0]! + 1 : 1];
  const owns = outlines.map((_, k) => {
    const own = breaks.slice(0, -1).map((v) => ownPlace(parts, k, v));
    return [...own, closed ? own[0]! + 1 : 1];
  });
  const pieces = breaks.slice(1).map((to, i) => {
    const from = breaks[i]!;
    const places = [
      from,
      ...(closed ? [0.5, 1, 1.5].filter((v) => v > from + SAME && v < to - SAME) : []),
      to,
    ];
    return {
      from,
      to,
      along: outlines.map((outline, k) => along(outline, places, owns[k]![i]!, owns[k]![i + 1]!)),
    };
  });
  return { closed, seamless, pieces };
}

type Part = ReturnType<typeof common>;

/** Where outline k has the crease at v. */
function ownPlace(parts: readonly Part[], k: number, v: number): number {
  for (const { places, owns } of parts) {
    const i = places.indexOf(v);
    if (i >= 0) return owns[k]?.[i] ?? v;
  }
  return v;
}

/** Too near for columns of one piece (knots.ts): q_l and q_r would have none, if they were not creases too. */
const isBeside = (v: number, end: number): boolean => Math.abs(v - end - Math.round(v - end)) <= IN_BREAK;

/** Where front and back of a closed outline meet smoothly but run on at other speeds, a spline would ripple. */
function changesSpeed(outline: Outline, end: number): boolean {
  if (!outline.closed || cornersAt(outline, end)) return false;
  const [before, after] = [speedBeside(outline, end, -1), speedBeside(outline, end, 1)];
  return Math.abs(before - after) > SPEEDS_ALIKE * Math.max(before, after);
}

function cornersAt({ corners }: Outline, end: number): boolean {
  return corners.some((corner) => Math.abs(corner - end) < SAME || Math.abs(corner - end - 1) < SAME);
}

/** |d point / dv| next to a place. */
function speedBeside(outline: Outline, v: number, side: -1 | 1): number {
  return length2(outline.derivative(inside(outline, v + side * BESIDE), side));
}

/** The creases between two ends, and where each section has them (null: where they are). */
function common(outlines: readonly Outline[], from: number, to: number) {
  const corners = outlines.map((outline) =>
    apart(outline.corners.filter((c) => c > from + SAME && c < to - SAME)),
  );
  const some = corners.filter((list) => list.length > 0);
  const count = some[0]?.length ?? 0;
  if (some.some((list) => list.length !== count)) {
    return { places: apart(corners.flat().sort((a, b) => a - b)), owns: corners.map(() => null) };
  }
  const places = Array.from({ length: count }, (_, i) => mean(some.map((list) => list[i]!)));
  return { places, owns: corners.map((list) => (list.length > 0 ? list : null)) };
}

function apart(places: readonly number[]): number[] {
  return places.filter((place, i) => i === 0 || place > places[i - 1]! + SAME);
}

/** Equal numbers keep their last bit. */
function mean(values: readonly number[]): number {
  const first = values[0]!;
  return first + values.reduce((sum, value) => sum + (value - first), 0) / values.length;
}

/** `places`: common v of the piece's ends and of what stands still between; `first`, `last`: the outline's own v at its ends. */
function along(outline: Outline, places: readonly number[], first: number, last: number): Along {
  const from = places[0]!;
  const to = places[places.length - 1]!;
  const map = from === first && to === last ? null : ascending(places, [first, ...places.slice(1, -1), last]);
  const uneven = [0, 0.5].filter((end) => changesSpeed(outline, end));
  const own = (v: number): number => (v <= from ? first : v >= to ? last : (map?.at(v) ?? v));
  return {
    point: (v) => outline.point(inside(outline, own(v))),
    derivative: (v) => {
      const side = v >= to ? -1 : 1;
      const at = inside(outline, own(v));
      // what arrives at v = 0 of a closed outline is the derivative at v = 1
      const found = outline.derivative(outline.closed && at === 0 && side === -1 ? 1 : at, side);
      // which has one derivative for front and back
      const speed = uneven.includes(at) ? speedBeside(outline, at, side) / (length2(found) || 1) : 1;
      return scale2(found, speed * (map?.slope(v) ?? 1));
    },
  };
}

/** In [0, 1], and on a corner to the last bit. */
function inside({ closed, corners }: Outline, v: number): number {
  const turned = closed ? v - Math.floor(v) : v;
  return corners.find((corner) => Math.abs(corner - turned) < SAME) ?? turned;
}
