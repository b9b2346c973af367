/**
 * Draw: a stroke becomes part of the unfinished form, or keeps it and begins the next one. Strokes land on the
 * plane through the pivot that faces the camera; one that starts on a surface lies at the depth of that point, and on a solid
 * becomes a part of it; all strokes of a form share the plane of its first (thesis ch. 5; the surface under the pen is ours). Which of these
 * a stroke does shows when it is closed or pulled away, so that it has both planes until then.
 */

import { draftIsWhole } from '../document/build.ts';
import { joinsDraft } from '../document/command/addStroke.ts';
import { apply, type Command } from '../document/command/index.ts';
import { type Document, isSolid, type Joins, readingOf, staysTubes } from '../document/document.ts';
import { partsWithDraft } from '../document/draftPart.ts';
import { length2 } from '../math/tuple.ts';
import { facingPlane } from '../stroke/plane.ts';
import type { Plane, Stroke } from '../stroke/stroke.ts';
import { acrossOf, type Guide, guideAt, isWithin } from './across.ts';
import { isSnapped, marksOf, plan as planSection } from './crossing.ts';
import { isEdgeOn, strokeOn } from './penStroke.ts';
import { previewed } from './previewed.ts';
import type { Bench, Pen, State } from './tool.ts';
import { isClosing, LEAST_LENGTH, type Trace, traced, traceFrom } from './trace.ts';
import type { Hit } from './viewport.ts';

/** Pixels: across less a stroke that starts on a side is no section. */
const WIDE = 48;
export const idle: State = {
  name: 'draw.idle',
  down(pen, bench) {
    const ground = groundAt(bench, pen);
    const { view } = bench.viewport;
    if (isEdgeOn(ground.shared ?? ground.own, view)) {
      bench.notify('edge-on');
      return undefined;
    }
    return drawing({ ...traceFrom(pen, view), ground });
  },
  cancel: () => idle,
};

/** What a stroke lies on, and with what. */
interface Ground {
  /** of the unfinished form, whose side or hole it may become */
  readonly shared: Plane | null;
  /** where it begins a form of its own */
  readonly own: Plane;
  readonly on: Hit | null;
  /** the solid it starts on */
  readonly joins: Joins | null;
  /** it starts on a side of the unfinished form: one that ends on the other is a section */
  readonly guide: Guide | null;
}

interface Drawn extends Trace {
  readonly ground: Ground;
}

function drawing(drawn: Drawn): State {
  const { pens, ground } = drawn;
  return {
    name: drawn.length < LEAST_LENGTH ? 'draw.pointing' : 'draw.drawing',
    wet: { pens, on: ground.on, closing: isClosing(drawn) },
    preview: previewed((bench) => previewOf(drawn, bench)),
    move: (more, bench) => over(traced(drawn, more), bench),
    up(bench) {
      const across = sectionOf(drawn, bench);
      if (across) {
        bench.commit(across);
        return idle;
      }
      const stroke = drawn.length < LEAST_LENGTH ? null : strokeOf(drawn, bench);
      if (stroke) bench.commit(plan(bench.document, stroke, ground.joins));
      else bench.notify('too-short', pointPlan(drawn, bench));
      return idle;
    },
    cancel: () => idle,
  };
}

/** Between the two sides of the unfinished form it may become a section: the guide says so. */
function over(drawn: Drawn, bench: Bench): State {
  const { ground } = drawn;
  if (!ground.guide || drawn.length < LEAST_LENGTH || !isBetween(drawn, ground.guide, bench))
    return drawing(drawn);
  return {
    ...drawing(drawn),
    wet: { pens: drawn.pens, on: null, closing: false },
    marks: marksOf({ ...drawn, guide: ground.guide }, bench),
  };
}

const isBetween = ({ pens }: Drawn, guide: Guide, { viewport }: Bench): boolean =>
  isWithin(guide.across, pens.at(-1)!, viewport);

/** From one side to the other one; null: it is something else. */
function sectionOf(drawn: Drawn, bench: Bench): readonly Command[] | null {
  const { guide } = drawn.ground;
  const crossing = guide && { ...drawn, guide };
  return crossing && isSnapped(crossing, bench) ? planSection(crossing, bench) : null;
}

/** The second stroke of a form joins it wherever it starts. */
function isSide(document: Document): boolean {
  const { draft } = document;
  if (draft?.strokes.length !== 1 || staysTubes(document)) return false;
  return readingOf(document) !== 'solid' && draft.form !== 'tube';
}

/** All strokes of a form lie on the plane of its first; others at the depth of what they start on. */
function groundAt({ document, viewport }: Bench, { x, y }: Pen): Ground {
  const on = viewport.pick(x, y);
  const own = facingPlane(viewport.view, on?.point ?? viewport.view.pivot);
  const joins = on && joinsAt(document, on);
  const plane = document.draft?.strokes[0]?.plane ?? null;
  if (isSide(document)) return { shared: plane, own, on: null, joins, guide: null };
  const mayHold = readingOf(document) === 'solid' && plane && !isEdgeOn(plane, viewport.view);
  // who wants tubes draws tubes
  const mayCross = document.draft && readingOf(document) !== 'tube';
  const across = mayCross ? acrossOf({ document, viewport, selection: [] }) : null;
  const guide = across && typeof across !== 'string' ? guideAt(across, { x, y }, viewport, WIDE) : null;
  return { shared: mayHold ? plane : null, own, on, joins, guide };
}

/** The component whose skel is under the pen; skels of a solid with several lie in one part of the tree each. */
function joinsAt(document: Document, { id, skel }: Hit): Joins | null {
  const solid = partsWithDraft(document)
    .filter(isSolid)
    .find((part) => part.id === id);
  const place = /^parts\[(\d+)\]/.exec(skel?.path ?? '')?.[1] ?? 0;
  const component = solid?.components[Number(place)] ?? solid?.components[0];
  return solid && component ? { solid: solid.id, component: component.id } : null;
}

/** On the plane of the unfinished form when it becomes a part of that, or else on its own; null: it lies nowhere. */
function strokeOf(drawn: Drawn, bench: Bench): Stroke | null {
  const { shared, own } = drawn.ground;
  const joining = shared && onThe(shared, drawn, bench);
  return joining && joinsDraft(bench.document, joining) ? joining : onThe(own, drawn, bench);
}

const onThe = (plane: Plane, drawn: Drawn, { viewport }: Bench): Stroke | null =>
  strokeOn(plane, drawn.pens, drawn.view, viewport.size, isClosing(drawn));

/** What a finished stroke does to a document: it joins the unfinished form, or keeps that and begins the next, maybe of the solid it starts on. */
export function plan(document: Document, stroke: Stroke, joins: Joins | null = null): readonly Command[] {
  if (document.draft && joinsDraft(document, stroke)) return [{ type: 'addStroke', stroke }];
  return beginning(document, stroke, joins);
}

/** What a tap would do if a point was meant. */
function pointPlan(drawn: Drawn, bench: Bench): readonly Command[] {
  const stroke = onThe(drawn.ground.own, drawn, bench);
  return stroke ? beginning(bench.document, { ...stroke, closed: false }, drawn.ground.joins, 'point') : [];
}

function beginning(
  document: Document,
  stroke: Stroke,
  joins: Joins | null,
  form?: 'point',
): readonly Command[] {
  const before = document.draft ? settled(document) : [];
  // what it starts on may be the unfinished form, and that may be nothing to keep
  const isThere = before.reduce(apply, document).parts.some(({ id }) => id === joins?.solid);
  const add: Command = {
    type: 'addStroke',
    stroke,
    ...(form && { form }),
    ...(joins && isThere && { joins }),
  };
  return [...before, add];
}

/** The unfinished form is kept, but nothing nobody could see: strokes that enclose nothing stay tubes, dots go. */
function settled(document: Document): readonly Command[] {
  const keep: Command = { type: 'keep' };
  if (draftIsWhole(document)) return [keep];
  const tubes: Command = { type: 'setForm', form: 'tube', joins: null };
  return draftIsWhole(apply(document, tubes)) ? [tubes, keep] : [{ type: 'drop' }];
}

/** A tube from its first 12 px on, a solid while it closes; a rotational surface once the second stroke is half as long as the first. */
function previewOf(drawn: Drawn, bench: Bench): Document | null {
  const across = sectionOf(drawn, bench);
  if (across) return across.reduce(apply, bench.document);
  const { guide } = drawn.ground;
  // nobody knows yet whether it goes all the way across
  if (guide && isBetween(drawn, guide, bench)) return null;
  const stroke = drawn.length >= LEAST_LENGTH ? strokeOf(drawn, bench) : null;
  if (!stroke) return null;
  const commands = plan(bench.document, stroke, drawn.ground.joins);
  const first = bench.document.draft?.strokes[0];
  const isSecond = commands.length === 1 && first && !stroke.closed;
  const young = isSecond && pathLength(stroke) < pathLength(first) / 2;
  return young ? null : commands.reduce(apply, bench.document);
}

function pathLength({ samples }: Stroke): number {
  let length = 0;
  for (let i = 1; i < samples.length; i++) {
    const a = samples[i - 1]!;
    const b = samples[i]!;
    length += length2([b.x - a.x, b.y - a.y]);
  }
  return length;
}
