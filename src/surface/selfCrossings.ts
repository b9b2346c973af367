/**
 * Where a closed outline crosses itself, as its chords have it: between the two places of a crossing it is crossed an even number of
 * times (Gauss), which uncrossed.ts lives by. So no place is refined on the curve, and ends of chords count by the side they lie on.
 */
import { cross2, distance2, sub2 } from '../math/tuple.ts';
import type { Vec2 } from '../math/vec.ts';
import type { Outline } from './outline.ts';

/** One time that the outline comes through a crossing. */
export interface Pass {
  readonly v: number;
  /** of the same crossing, the other time: its place in the list */
  readonly other: number;
}

/** chords, those between corners aside: half a circle of 128 is off by 7.5e-5 of its radius */
const CHORDS = 256;
/** half chords: longer ones are divided, where much was drawn over a small part, but not into more than so many */
const LONG = 0.1;
const MOST_PARTS = 32;
/** half chords: a lens or a loop that is thinner is none */
const THIN = 1e-3;
/** of v */
const HAIR = 1e-6;
/** places at which lenses and loops are looked at */
const LOOKS = 8;

/** Ascending in v. Slivers are left out: a front and a back that run on each other cross as rounding pleases. */
export function selfCrossings(outline: Outline): readonly Pass[] {
  const vs = placesOn(outline);
  const points = vs.map((v) => outline.point(v));
  const at = (k: number, t: number): number => vs[k]! + t * (vs[k + 1]! - vs[k]!);
  const found: [number, number][] = [];
  const count = vs.length - 1;
  for (let i = 0; i < count; i++)
    for (let j = i + 2; j < (i === 0 ? count - 1 : count); j++) {
      const cut = intersect(points[i]!, points[i + 1]!, points[j]!, points[j + 1]!);
      if (cut) found.push([at(i, cut[0]), at(j, cut[1])]);
    }
  return withoutSlivers(outline, passesOf(found));
}

/** Ends of chords, ascending from 0 to 1. */
function placesOn({ point, corners }: Outline): number[] {
  const even = Array.from({ length: CHORDS + 1 }, (_, i) => i / CHORDS);
  const vs = [...new Set([...even, ...corners])].sort((a, b) => a - b);
  return vs.flatMap((to, i) => {
    const from = vs[i - 1] ?? to;
    const parts = Math.min(Math.ceil(distance2(point(from), point(to)) / LONG) || 1, MOST_PARTS);
    return Array.from({ length: parts }, (_, k) =>
      k + 1 === parts ? to : from + ((to - from) * (k + 1)) / parts,
    );
  });
}

/** Never at q_l or q_r themselves: a hair beside them, on the same side. */
function beside(v: number): number {
  const inside = Math.min(Math.max(v, HAIR), 1 - HAIR);
  if (Math.abs(inside - 0.5) >= HAIR) return inside;
  return inside < 0.5 ? 0.5 - HAIR : 0.5 + HAIR;
}

function intersect(p: Vec2, q: Vec2, r: Vec2, s: Vec2): readonly [number, number] | null {
  for (const k of [0, 1] as const) {
    if (Math.max(p[k], q[k]) < Math.min(r[k], s[k])) return null;
    if (Math.max(r[k], s[k]) < Math.min(p[k], q[k])) return null;
  }
  const [e, f] = [sub2(q, p), sub2(s, r)];
  const [fromP, fromQ] = [cross2(f, sub2(p, r)), cross2(f, sub2(q, r))];
  const [fromR, fromS] = [cross2(e, sub2(r, p)), cross2(e, sub2(s, p))];
  if (fromP >= 0 === fromQ >= 0 || fromR >= 0 === fromS >= 0) return null;
  return [fromP / (fromP - fromQ), fromR / (fromR - fromS)];
}

function passesOf(pairs: readonly (readonly [number, number])[]): Pass[] {
  const ends = pairs.flatMap(([a, b], crossing) => [
    { v: a, crossing },
    { v: b, crossing },
  ]);
  ends.sort((x, y) => x.v - y.v);
  return ends.map(({ v, crossing }, i) => ({
    v: beside(v),
    other: ends.findIndex((end, j) => j !== i && end.crossing === crossing),
  }));
}

/** Without the crossing of a loop, or both of a lens, everything else stays on the side it was. */
function withoutSlivers(outline: Outline, all: readonly Pass[]): readonly Pass[] {
  const count = all.length;
  for (let i = 0; i < count; i++) {
    const next = (i + 1) % count;
    const [a, b] = [all[i]!.other, all[next]!.other];
    const way = stretch(all[i]!.v, all[next]!.v, 1);
    const isLoop = a === next && isThin(outline, way, () => all[i]!.v);
    const turn = (a + 1) % count === b ? 1 : (b + 1) % count === a ? -1 : 0;
    const isLens = turn !== 0 && a !== next && isThin(outline, way, stretch(all[a]!.v, all[b]!.v, turn));
    if (isLoop || isLens) return withoutSlivers(outline, without(all, [i, next, a, b]));
  }
  return all;
}

type Stretch = (t: number) => number;

/** From v to v, onward or back, past the seam if need be. */
const stretch = (from: number, to: number, turn: 1 | -1): Stretch => {
  const way = (to - from) * turn;
  return (t) => from + turn * t * (way < 0 ? way + 1 : way);
};

function isThin({ point }: Outline, a: Stretch, b: Stretch): boolean {
  const wrapped = (v: number): number => v - Math.floor(v);
  return Array.from({ length: LOOKS }, (_, k) => (k + 1) / (LOOKS + 1)).every(
    (t) => distance2(point(wrapped(a(t))), point(wrapped(b(t)))) < THIN,
  );
}

function without(all: readonly Pass[], gone: readonly number[]): Pass[] {
  const left = all.filter((_, i) => !gone.includes(i));
  return left.map(({ v, other }) => ({ v, other: left.indexOf(all[other]!) }));
}
