/** A stroke on its way from one construction curve to the other: when it is a section, and what it then does to the document. */
import { apply, type Command } from '../document/command/index.ts';
import type { Document } from '../document/document.ts';
import { compose, isUnmoved, place3, unplaced } from '../math/placement.ts';
import type { Stroke, View } from '../stroke/stroke.ts';
import { type Across, distanceToOther, type Guide, isWithin, progressOf, REACH } from './across.ts';
import { guideMarks } from './guideMarks.ts';
import type { Mark } from './marks.ts';
import { strokeOn } from './penStroke.ts';
import type { Bench } from './tool.ts';
import { LEAST_LENGTH, type Trace } from './trace.ts';

/** of the chord: from here on the stroke is a section, and is shown as one */
const HALF = 0.5;
/** of the chord: what a stroke crosses at least; narrow forms are within reach of both sides at once */
const LEAST_SPAN = 0.4;
/** points of what is not drawn yet */
const REST = 16;

/** A stroke that may become a section. */
export interface Crossing extends Trace {
  readonly guide: Guide;
}

export function isSnapped({ guide, pens }: Crossing, { viewport }: Bench): boolean {
  const last = pens.at(-1)!;
  return progressOf(guide, last, viewport) > HALF && distanceToOther(guide, last, viewport) <= REACH;
}

/** Words go with the first pixels. */
export function marksOf(crossing: Crossing, bench: Bench): readonly Mark[] {
  const { guide, length } = crossing;
  const held = length >= LEAST_LENGTH && { near: true, far: isSnapped(crossing, bench) };
  return guideMarks(guide, bench.viewport, held ? { held } : {});
}

/** It would be a section if the pen were lifted now. */
export function isPastMiddle({ guide, pens, length }: Crossing, { viewport }: Bench): boolean {
  const last = pens.at(-1)!;
  const progress = progressOf(guide, last, viewport);
  return (
    length >= LEAST_LENGTH &&
    progress > HALF &&
    progress - progressOf(guide, pens[0]!, viewport) >= LEAST_SPAN &&
    isWithin(guide.across, last, viewport)
  );
}

/** What it is when the pen is lifted; null: no section. */
export function plan(crossing: Crossing, bench: Bench): readonly Command[] | null {
  if (!isPastMiddle(crossing, bench)) return null;
  const stroke = strokeOf(crossing, bench);
  return stroke && [sectionCommand(crossing.guide, stroke)];
}

const sectionCommand = ({ across: { part }, u, side }: Guide, stroke: Stroke): Command => ({
  type: 'addSection',
  u,
  drawn: { stroke, half: null },
  ...(side === 'back' && { side }),
  ...(part !== undefined && { part }),
});

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
export function previewOf(crossing: Crossing, bench: Bench): Document | null {
  if (!isPastMiddle(crossing, bench)) return null;
  const stroke = strokeOf(crossing, bench);
  if (!stroke) return null;
  const whole = isSnapped(crossing, bench) ? stroke : completed(stroke, crossing.guide);
  return apply(bench.document, sectionCommand(crossing.guide, whole));
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
