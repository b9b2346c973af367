/**
 * Section: near a construction curve the guide of that place shows, and a stroke from one side to the other is the cross section there
 * (thesis 5.4.1). Its ends snap to the curves. A stroke that ends outside the form is none: the guide stays. A finger, which cannot hover,
 * slides the guide along the curve once it has rested, and draws where it goes across. What counts is the way it goes, not how far it is from
 * the curve: of a thin form every place is near both sides.
 */
import { distance2 } from '../math/tuple.ts';
import { acrossOf, endsOf, type Guide, guideAt, isWithin, progressOf, REACH, turned } from './across.ts';
import { type Crossing, isPastMiddle, marksOf, plan, previewOf } from './crossing.ts';
import { guideMarks } from './guideMarks.ts';
import { previewed } from './previewed.ts';
import type { Bench, Pen, State } from './tool.ts';
import { LEAST_LENGTH, traced, traceFrom } from './trace.ts';

export const sectioning: State = {
  name: 'section.idle',
  hover: (pen, bench) => hovered(pen, bench) ?? undefined,
  down: (pen, bench) => begun(pen, bench, null),
  cancel: () => sectioning,
};

/** The guide shows where the pen is near; fingers leave it where they were. */
function guided(guide: Guide, bench: Bench): State {
  const state: State = {
    name: 'section.guide',
    guide: placeOf(guide),
    marks: guideMarks(guide, bench.viewport),
    ...(isUnfinished(guide) && { faint: true as const }),
    hover: (pen, now) => hovered(pen, now) ?? sectioning,
    down: (pen, now) => begun(pen, now, guide),
    // Nothing is under way: cancelling it is no deed.
    cancel: () => state,
  };
  return state;
}

const placeOf = ({ u, side }: Guide) => ({ u, side });

const isUnfinished = ({ across }: Guide): boolean => across.part === undefined;

function hovered(pen: Pen | null, bench: Bench): State | null {
  const across = acrossOf(bench);
  const guide = pen && typeof across !== 'string' ? guideAt(across, pen, bench.viewport) : null;
  return guide && guided(guide, bench);
}

/** At the curve under the pen, else where the guide is, when that is still of this form and the pen is within it. */
function begun(pen: Pen, bench: Bench, shown: Guide | null): State | undefined {
  const across = acrossOf(bench);
  if (typeof across === 'string') {
    bench.notify(across);
    return undefined;
  }
  const stays = shown?.across.pair === across.pair && isWithin(across, pen, bench.viewport);
  const guide = guideAt(across, pen, bench.viewport) ?? (stays ? turned(shown, pen, bench.viewport) : null);
  if (!guide) bench.notify(guideAt(across, pen, bench.viewport, 0) ? 'too-narrow' : 'off-sides');
  return guide ? drawing({ ...traceFrom(pen, bench.viewport.view), guide }, bench) : sectioning;
}

/** `rested`: the same from where the finger rested; a round section begins along the side, and is that one if it comes back to its guide. */
function drawing(turnedOff: Crossing, bench: Bench, rested: Crossing | null = null): State {
  const crossing = rested && isMeant(rested, turnedOff, bench) ? rested : turnedOff;
  const { guide, pens } = crossing;
  const isShown = isPastMiddle(crossing, bench);
  return {
    name: crossing.length < LEAST_LENGTH ? 'section.pointing' : 'section.drawing',
    guide: placeOf(guide),
    wet: { pens, on: null, closing: false },
    marks: marksOf(crossing, bench),
    ...(isUnfinished(guide) && !isShown && { faint: true as const }),
    preview: previewed((now) => previewOf(crossing, now)),
    move(more, now) {
      const from = turnedOff.reach;
      const next = traced(turnedOff, more);
      const isDecided = from < LEAST_LENGTH && next.reach >= LEAST_LENGTH;
      return !rested && isDecided && slides(next, now)
        ? slid(guide, next.pens.slice(0, 1), next.pens.slice(1), now, {
            ...traceFrom(next.pens[0]!, next.view),
            guide,
          })
        : drawing(next, now, rested && traced(rested, more));
    },
    up(now) {
      const commands = plan(crossing, now);
      if (!commands) return guided(guide, now);
      now.commit(commands);
      return sectioning;
    },
    cancel: () => guided(guide, bench),
  };
}

/** The one whose other end is nearer. */
function isMeant(rested: Crossing, turnedOff: Crossing, { viewport }: Bench): boolean {
  const last = rested.pens.at(-1)!;
  const [a, b] = [rested, turnedOff].map(({ guide }) => {
    const end = endsOf(guide, viewport)[guide.near === 'left' ? 1 : 0];
    return end ? distance2(end, [last.x, last.y]) : Infinity;
  });
  return a! < b!;
}

/** ms that a finger rests before what it does next slides the guide, and px that it may tremble meanwhile */
const RESTS = { time: 300, pixels: 6 } as const;

/** of the way: what goes so little across, to 25°, slides */
const ALONG_CURVE = 0.42;

/** Where it set out, for good: at once a finger draws, since round sections begin along the curve, too. */
function slides({ guide, pens }: Crossing, { viewport }: Bench): boolean {
  const first = pens[0]!;
  const left = pens.find((pen) => wayOf(first, pen) > RESTS.pixels)!;
  if (first.pointer !== 'touch' || left.time - first.time < RESTS.time) return false;
  const last = pens.at(-1)!;
  const there = guideAt(guide.across, last, viewport);
  return (
    there !== null && wayAcross([guide, first], [there, last], viewport) <= ALONG_CURVE * wayOf(first, last)
  );
}

/** px on the curve from where the trail begins that count as moved along */
const ALONG = 4;

/** `trail`: since it was last moved along; what is drawn begins there. `rested`: since it rested, while it can be a round section from there. */
function slid(
  guide: Guide,
  trail: readonly Pen[],
  more: readonly Pen[],
  bench: Bench,
  rested: Crossing | null,
): State {
  const { viewport } = bench;
  let [shown, from, since, round] = [guide, startOf(guide, trail, viewport), trail, rested];
  for (const [i, pen] of more.entries()) {
    const next = guideAt(from.across, pen, viewport);
    const way = wayOf(since[0]!, pen);
    const across = next ? wayAcross([from, since[0]!], [next, pen], viewport) : Infinity;
    const along = Math.sqrt(Math.max(way * way - across * across, 0));
    if (
      !next ||
      (way >= LEAST_LENGTH && across > along) ||
      (round && isHalfway(round, next, pen, viewport))
    ) {
      const start = { ...traceFrom(since[0]!, viewport.view), guide: from };
      const rest = more.slice(i);
      return drawing(traced(start, [...since.slice(1), ...rest]), bench, round && traced(round, rest));
    }
    if (along >= across) shown = { ...next, near: from.near };
    const isAlong = along > ALONG && along >= across;
    since = isAlong ? [pen] : [...since, pen];
    if (isAlong) from = shown;
    round = round && stillRound(traced(round, [pen]), viewport);
  }
  return sliding(shown, since, bench, round);
}

const startOf = (guide: Guide, [first]: readonly Pen[], viewport: Bench['viewport']): Guide => ({
  ...(guideAt(guide.across, first!, viewport) ?? guide),
  near: guide.near,
});

/** of the chord: what goes further along is no round section; of forms that are wider than so many px a finger leaves the side itself */
const ROUND = { share: 1.5, widest: 4 * REACH } as const;

function stillRound(rested: Crossing, viewport: Bench['viewport']): Crossing | null {
  const chord = chordOf(rested.guide, viewport);
  return chord <= ROUND.widest && rested.reach <= ROUND.share * chord ? rested : null;
}

/** Across as a whole, however much it goes along: the finger is on its way to the other side. */
function isHalfway({ guide, pens }: Crossing, there: Guide, pen: Pen, viewport: Bench['viewport']): boolean {
  const least = Math.max(LEAST_LENGTH, 0.5 * chordOf(guide, viewport));
  return wayAcross([guide, pens[0]!], [there, pen], viewport) >= least;
}

const wayOf = (from: Pen, to: Pen): number => distance2([from.x, from.y], [to.x, to.y]);

type Place = readonly [Guide, Pen];

/** px that the pen came nearer to one side, or to the other: each measured on the chord of its place, from the same side */
function wayAcross([from, first]: Place, [to, last]: Place, viewport: Bench['viewport']): number {
  const offset = (guide: Guide, pen: Pen) =>
    progressOf({ ...guide, near: from.near }, pen, viewport) * chordOf(guide, viewport);
  return Math.abs(offset(to, last) - offset(from, first));
}

function chordOf(guide: Guide, viewport: Bench['viewport']): number {
  const [a, b] = endsOf(guide, viewport);
  return a && b ? distance2(a, b) : 0;
}

const sliding = (guide: Guide, trail: readonly Pen[], bench: Bench, rested: Crossing | null): State => ({
  name: 'section.sliding',
  still: true,
  guide: placeOf(guide),
  marks: guideMarks(guide, bench.viewport),
  ...(isUnfinished(guide) && { faint: true as const }),
  move: (more, now) => slid(guide, trail, more, now, rested),
  up: (now) => guided(guide, now),
  cancel: () => guided(guide, bench),
});
