/**
 * Section: near a construction curve the guide of that place shows, and a stroke from one side to the other is the cross section there
 * (thesis 5.4.1). Its ends snap to the curves. A stroke that ends outside the form is none: the guide stays.
 */
import { apply, type Command } from '../document/command/index.ts';
import type { Document } from '../document/document.ts';
import { LIMITS } from '../document/limits.ts';
import { compose, isUnmoved, place3, unplaced } from '../math/placement.ts';
import { length2 } from '../math/tuple.ts';
import type { Stroke, View } from '../stroke/stroke.ts';
import {
  type Across,
  acrossOf,
  distanceToOther,
  type Guide,
  guideAt,
  isWithin,
  progressOf,
  REACH,
} from './across.ts';
import { guideMarks } from './guideMarks.ts';
import { strokeOn } from './penStroke.ts';
import type { Bench, Pen, State } from './tool.ts';

/** Pixels: less is a tap. */
const MINIMUM = 12;
/** of the chord: from here on the stroke is a section, and is shown as one */
const HALF = 0.5;

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
  const guide = guideAt(across, pen, bench.viewport) ?? (stays ? shown : null);
  if (!guide) bench.notify('off-sides');
  return guide ? drawing({ pens: [pen], length: 0, guide, view: bench.viewport.view }, bench) : sectioning;
}

/** A stroke that may become a section. */
export interface Crossing {
  readonly pens: Pen[];
  /** px along the path */
  readonly length: number;
  readonly guide: Guide;
  readonly view: View;
}

function drawing(crossing: Crossing, bench: Bench): State {
  const { guide, pens } = crossing;
  const isShown = isPastMiddle(crossing, bench);
  let preview: Document | null = null;
  return {
    name: crossing.length < MINIMUM ? 'section.pointing' : 'section.drawing',
    guide: placeOf(guide),
    wet: { pens, on: null, closing: false },
    marks: marksOf(crossing, bench),
    ...(isUnfinished(guide) && !isShown && { faint: true as const }),
    preview: (now) => (preview ??= previewOf(crossing, now)),
    move: (more, now) => drawing(more.reduce(extend, crossing), now),
    up(now) {
      const commands = plan(crossing, now);
      if (!commands) return guided(guide, now);
      now.commit(commands);
      return sectioning;
    },
    cancel: () => guided(guide, bench),
  };
}

/** Words go with the first pixels. */
function marksOf(crossing: Crossing, bench: Bench) {
  const { guide, length } = crossing;
  const held = length >= MINIMUM && { near: true, far: isSnapped(crossing, bench) };
  return guideMarks(guide, bench.viewport, held ? { held } : {});
}

/** The pen's path is only ever appended to. */
function extend(crossing: Crossing, pen: Pen): Crossing {
  const { pens, length } = crossing;
  if (pens.length >= LIMITS.samples) return crossing;
  const last = pens.at(-1) ?? pen;
  pens.push(pen);
  return { ...crossing, length: length + length2([pen.x - last.x, pen.y - last.y]) };
}

function isSnapped({ guide, pens }: Crossing, { viewport }: Bench): boolean {
  const last = pens.at(-1)!;
  return progressOf(guide, last, viewport) > HALF && distanceToOther(guide, last, viewport) <= REACH;
}

/** It would be a section if the pen were lifted now. */
function isPastMiddle({ guide, pens, length }: Crossing, { viewport }: Bench): boolean {
  const last = pens.at(-1)!;
  return (
    length >= MINIMUM && progressOf(guide, last, viewport) > HALF && isWithin(guide.across, last, viewport)
  );
}

/** Null: none. */
function plan(crossing: Crossing, bench: Bench): readonly Command[] | null {
  if (!isPastMiddle(crossing, bench)) return null;
  const stroke = strokeOf(crossing, bench);
  return stroke && sectionCommands(crossing.guide, stroke, bench.document);
}

/** What drawing it does; who had gone back to tubes means a surface again. */
export function sectionCommands(
  { across, u, side }: Guide,
  stroke: Stroke,
  document: Document,
): readonly Command[] {
  const { part } = across;
  const add: Command = {
    type: 'addSection',
    u,
    drawn: { stroke, half: null },
    ...(side === 'back' && { side }),
    ...(part !== undefined && { part }),
  };
  const isPinned = part === undefined && document.tubesOnly;
  return isPinned ? [{ type: 'setTubesOnly', on: false }, add] : [add];
}

function strokeOf({ pens, guide, view }: Crossing, { viewport }: Bench): Stroke | null {
  const stroke = strokeOn(guide.across.plane, pens, view, viewport.size);
  return stroke && { ...stroke, plane: guide.across.own, view: ownView(view, guide.across) };
}

/** As the part would have been looked at where it was drawn. */
function ownView(view: View, { placement }: Across): View {
  if (isUnmoved(placement)) return view;
  const back = unplaced(placement);
  const { rotation } = compose(back, { rotation: view.rotation, translation: [0, 0, 0] });
  return { ...view, pivot: place3(back, view.pivot), rotation };
}

/** What is not drawn yet runs straight to the other side, so that the form is not blown up by what is. */
function previewOf(crossing: Crossing, bench: Bench): Document | null {
  if (!isPastMiddle(crossing, bench)) return null;
  const stroke = strokeOf(crossing, bench);
  if (!stroke) return null;
  const whole = isSnapped(crossing, bench) ? stroke : completed(stroke, crossing.guide);
  return sectionCommands(crossing.guide, whole, bench.document).reduce(apply, bench.document);
}

/** With points up to q_r(u), or q_l(u). */
function completed(stroke: Stroke, { left, right, near }: Guide): Stroke {
  const [x, y] = near === 'left' ? right : left;
  const last = stroke.samples.at(-1)!;
  const rest = Array.from({ length: REST }, (_, i) => {
    const t = (i + 1) / REST;
    return {
      ...last,
      x: last.x + t * (x - last.x),
      y: last.y + t * (y - last.y),
      time: last.time + 8 * (i + 1),
    };
  });
  return { ...stroke, samples: [...stroke.samples, ...rest] };
}

const REST = 16;
