/**
 * Oversketch of strokes: the part of an old one between the points nearest to the ends of a new one is replaced by it, in
 * raw samples (thesis B.2.2, there for curves: but here what was drawn is the truth, and everything is derived from it).
 *
 * The new samples stay as they were drawn, less the flicks at their ends (hooks.ts), which the filter would not look for in the
 * middle. Where they begin beside the old stroke, that is cut back by three times the gap: the way across then turns by 18°
 * at each end, and no corner is found there (47°) that nobody drew. A closed stroke never runs over its own seam, which is
 * joined only at ends (closed.ts).
 */
import { clean } from './clean.ts';
import { CLOSED_TOLERANCE, isClosed } from './closed.ts';
import { REST_GRAINS } from './filter.ts';
import { removeHooks } from './hooks.ts';
import { distance, type Ink, inkAt, mixInk, type Path, pathOf, segmentAt } from './path.ts';
import type { Sample, Stroke } from './stroke.ts';

/** the old stroke is cut back by this many gaps */
const CUT_BACK = 3;
/** … but by no more than this part of what stays of it */
const MOST_CUT = 0.5;
/** a rest of the old stroke shorter than this many gaps goes, too */
const LEAST_REST = 2;
/** a stroke that comes back to where it left, to this part of its length, replaces nothing */
const LEAST_PART = 0.05;
/** ms between the last sample of one and the first of the next */
const PAUSE = 8;
const PROBES = 48;

/**
 * `old` with `over` in the place of what it was drawn over, either way; both on the same plane. Drawn on from an end it is
 * longer. A closed stroke loses the part nearer to `over`, or all when that is closed itself. The old stroke when the new
 * one says nothing (a dot, a spur). `grain`: mm, as for the filter.
 */
export function splice(old: Stroke, over: Stroke, grain: number): Stroke {
  const kept = withoutHooks(old.samples, grain);
  const before = pathOf(kept, false);
  const drawn = withoutHooks(over.samples, grain);
  const path = pathOf(drawn, false);
  if (!isWay(before) || !isWay(path)) return old;
  if (over.closed || (old.closed && isClosed(path, CLOSED_TOLERANCE))) {
    return old.closed ? { ...old, samples: drawn } : old;
  }
  const [a, b] = [nearestOn(before, drawn[0]!), nearestOn(before, drawn[drawn.length - 1]!)];
  const forth = a.s === b.s ? startsNearer(before, a, b) : a.s < b.s;
  const [low, high] = forth ? [a, b] : [b, a];
  const along = forth ? drawn : turnedRound(drawn);
  if (old.closed && isOutside(before, path, low.s, high.s)) {
    return { ...old, samples: inOneGo([middleOf(kept, before, low, high), turnedRound(along)]) };
  }
  const atEnd = low.s === 0 || high.s === before.length;
  if (high.s - low.s < LEAST_PART * path.length && !atEnd) return old;
  return {
    ...old,
    samples: inOneGo([headOf(kept, before, low), along, tailOf(kept, before, high)]),
  };
}

const isWay = ({ length }: Path): boolean => length > 0 && length < Infinity;

/** A place on the old stroke: mm from its start, and how far off the new one is there, mm. */
interface Place {
  readonly s: number;
  readonly gap: number;
}

function nearestOn(path: Path, p: Ink): Place {
  let best: Place = { s: 0, gap: distance(path.points[0]!, p) };
  for (let i = 1; i < path.points.length; i++) {
    const [a, b] = [path.points[i - 1]!, path.points[i]!];
    const [dx, dy] = [b.x - a.x, b.y - a.y];
    const squared = dx * dx + dy * dy;
    const t = squared > 0 ? Math.min(Math.max(((p.x - a.x) * dx + (p.y - a.y) * dy) / squared, 0), 1) : 0;
    const gap = distance(mixInk(a, b, t), p);
    const [from, to] = [path.lengths[i - 1]!, path.lengths[i]!];
    if (gap < best.gap) best = { s: t === 1 ? to : from + t * (to - from), gap };
  }
  return best;
}

/** Of a stroke with both ends at one end of the old one: whether it runs as that does. */
function startsNearer({ length }: Path, a: Place, b: Place): boolean {
  return a.s === length ? a.gap <= b.gap : a.gap > b.gap;
}

/** Of a closed stroke: whether `path` lies along the part with the seam rather than between the two places. */
function isOutside(ring: Path, path: Path, low: number, high: number): boolean {
  const places = Array.from({ length: PROBES + 1 }, (_, i) => i / PROBES);
  const drawn = places.map((x) => inkAt(path, x * path.length));
  const inside = places.map((x) => inkAt(ring, low + x * (high - low)));
  const rest = ring.length - (high - low);
  const outside = places.map((x) => {
    const s = high + x * rest;
    return inkAt(ring, s > ring.length ? s - ring.length : s);
  });
  return apart(drawn, outside) < apart(drawn, inside);
}

function apart(a: readonly Ink[], b: readonly Ink[]): number {
  return meanToNearest(a, b) + meanToNearest(b, a);
}

function meanToNearest(from: readonly Ink[], to: readonly Ink[]): number {
  const nearest = from.map((p) => to.reduce((least, q) => Math.min(least, distance(p, q)), Infinity));
  return nearest.reduce((sum, d) => sum + d, 0) / from.length;
}

/** How much of a rest of `length` mm goes for the way across a gap. */
function cut({ gap }: Place, length: number): number {
  return length < LEAST_REST * gap ? length : Math.min(CUT_BACK * gap, MOST_CUT * length);
}

function headOf(samples: readonly Sample[], path: Path, place: Place): Sample[] {
  return stretch(samples, path, 0, place.s - cut(place, place.s));
}

function tailOf(samples: readonly Sample[], path: Path, place: Place): Sample[] {
  return stretch(samples, path, place.s + cut(place, path.length - place.s), path.length);
}

/** What stays of a closed stroke when the part with its seam goes. */
function middleOf(samples: readonly Sample[], path: Path, low: Place, high: Place): Sample[] {
  const half = (high.s - low.s) / 2;
  return stretch(samples, path, low.s + cut(low, half), high.s - cut(high, half));
}

/** The samples from `from` to `to` mm, one made at each end where none is; none for no length. */
function stretch(samples: readonly Sample[], path: Path, from: number, to: number): Sample[] {
  if (!(to > from)) return [];
  const inside = samples.filter((_, i) => path.lengths[i]! > from && path.lengths[i]! < to);
  return [sampleAt(samples, path, from, 0), ...inside, sampleAt(samples, path, to, 1)];
}

/** `end`: which of several samples in one place is meant, the last (0) or the first (1). */
function sampleAt(samples: readonly Sample[], path: Path, s: number, end: 0 | 1): Sample {
  const on = end === 0 ? path.lengths.lastIndexOf(s) : path.lengths.indexOf(s);
  if (on >= 0) return samples[on]!;
  const i = segmentAt(path, s);
  const [a, b] = [samples[i]!, samples[i + 1]!];
  const t = (s - path.lengths[i]!) / (path.lengths[i + 1]! - path.lengths[i]!);
  const mix = (of: (sample: Sample) => number): number => of(a) * (1 - t) + of(b) * t;
  return {
    ...mixInk(a, b, t),
    tiltX: mix((x) => x.tiltX),
    tiltY: mix((x) => x.tiltY),
    time: mix((x) => x.time),
  };
}

/** Without flicks, found as the filter finds them: with the pen's rests as one. */
function withoutHooks(samples: readonly Sample[], grain: number): readonly Sample[] {
  const cleaned = clean(samples, REST_GRAINS * grain)?.samples ?? [];
  const kept = removeHooks(cleaned, grain) as readonly Sample[];
  if (kept.length < 2) return [];
  const from = kept[0] === cleaned[0] ? -Infinity : kept[0]!.time;
  const last = kept[kept.length - 1]!;
  const to = last === cleaned[cleaned.length - 1] ? Infinity : last.time;
  return samples.filter(({ x, y, time }) => Number.isFinite(x + y) && time >= from && time <= to);
}

function turnedRound(samples: readonly Sample[]): Sample[] {
  const last = samples[samples.length - 1]!.time;
  return samples.map((sample) => ({ ...sample, time: last - sample.time })).reverse();
}

/** One stroke of several: times go on from part to part, from 0. */
function inOneGo(parts: readonly (readonly Sample[])[]): Sample[] {
  let next = 0;
  return parts.flatMap((part) => {
    const first = part[0]?.time ?? 0;
    const shift = next - first;
    const timed = part.map((sample) => ({ ...sample, time: sample.time + shift }));
    if (timed.length > 0) next = timed[timed.length - 1]!.time + PAUSE;
    return timed;
  });
}
