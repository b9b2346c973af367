/**
 * Section: near a construction curve the guide of that place shows, and a stroke from one side to the other is the cross section there
 * (thesis 5.4.1). Its ends snap to the curves. A stroke that ends outside the form is none: the guide stays.
 */
import { acrossOf, type Guide, guideAt, isWithin, turned } from './across.ts';
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
  if (!guide) bench.notify('off-sides');
  return guide ? drawing({ ...traceFrom(pen, bench.viewport.view), guide }, bench) : sectioning;
}

function drawing(crossing: Crossing, bench: Bench): State {
  const { guide, pens } = crossing;
  const isShown = isPastMiddle(crossing, bench);
  return {
    name: crossing.length < LEAST_LENGTH ? 'section.pointing' : 'section.drawing',
    guide: placeOf(guide),
    wet: { pens, on: null, closing: false },
    marks: marksOf(crossing, bench),
    ...(isUnfinished(guide) && !isShown && { faint: true as const }),
    preview: previewed((now) => previewOf(crossing, now)),
    move: (more, now) => drawing(traced(crossing, more), now),
    up(now) {
      const commands = plan(crossing, now);
      if (!commands) return guided(guide, now);
      now.commit(commands);
      return sectioning;
    },
    cancel: () => guided(guide, bench),
  };
}
