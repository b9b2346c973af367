/**
 * Bend (thesis 6.1): the camera comes to the side of a part, its axis shows as blue pencil, and the stroke that is drawn becomes the new
 * centre line; each further one takes its place, until the bend is kept. One may look from elsewhere before drawing: what counts is the
 * view a stroke was drawn in. Laying the tool down brings the camera back.
 */
import { solidOf } from '../document/build.ts';
import { centreLine, spineOf } from '../document/centreLine.ts';
import { apply, type Command } from '../document/command/index.ts';
import { type Document, isSurface, type SurfacePart } from '../document/document.ts';
import { boxOfMesh } from '../document/extent.ts';
import { placedStroke } from '../document/placedStroke.ts';
import type { Bend } from '../document/surfacePart.ts';
import { place3, unplaced } from '../math/placement.ts';
import { add3, scale3 } from '../math/tuple.ts';
import type { Vec3 } from '../math/vec.ts';
import { facingPlane, toWorld } from '../stroke/plane.ts';
import type { Plane, Stroke, View } from '../stroke/stroke.ts';
import { isBendable } from '../surface/deform.ts';
import { within } from '../surface/sideView.ts';
import type { Mark } from './marks.ts';
import { previewed } from './previewed.ts';
import { sideView, viewOnto } from './sideView.ts';
import type { Bench, Pen, State } from './tool.ts';
import { isClosing, strokeOf, type Trace, traced, traceFrom } from './trace.ts';

/** What is being bent. */
export interface Bending {
  /** of the part */
  readonly id: string;
  /** of the bend in the part's list; it may not be made yet */
  readonly index: number;
  /** as it was before; null: it is a new one */
  readonly old: Bend | null;
  readonly keepsLength: boolean;
  /** where the camera goes when the tool is laid down */
  readonly home: View;
}

/** px a tap may move */
const STILL = 6;

/** Nothing is being bent: a tap on a part says which. */
export const choosing: State = {
  name: 'bend.choosing',
  waits: true,
  down: (pen) => pressed(pen),
  cancel: () => choosing,
};

function pressed(start: Pen): State {
  return {
    name: 'bend.pressed',
    still: true,
    move(pens) {
      const last = pens.at(-1) ?? start;
      return Math.max(Math.abs(last.x - start.x), Math.abs(last.y - start.y)) > STILL ? choosing : undefined;
    },
    up(bench) {
      const id = bench.viewport.pick(start.x, start.y)?.id ?? '';
      const part = surfaceIn(bench.document, id);
      if (!part) {
        bench.notify('bend-what');
        return choosing;
      }
      bench.select([id]);
      return bendPart(bench, id, part.bends.length);
    },
    cancel: () => choosing,
  };
}

/**
 * Begins a bend of a part, or takes one of its bends in hand again; the camera goes to the side of it, or to the view that bend was drawn in.
 * `home`: where it returns to, if not to where it is, or is on its way to.
 */
export function bendPart(bench: Bench, id: string, index: number, home = bench.viewport.goal): State {
  const part = surfaceIn(bench.document, id);
  const mesh = part && solidOf(part)?.mesh;
  if (!part || !mesh) return choosing;
  const old = part.bends[index] ?? null;
  const plane = placedPlane(part);
  const box = boxOfMesh(mesh);
  const drawnOn = old && placedStroke(old.stroke, part.placement).plane;
  bench.lookFrom(
    drawnOn
      ? viewOnto(drawnOn, box, bench.viewport)
      : sideView(axisOf(part, index), plane, box, bench.viewport),
  );
  bench.notify('bend');
  return bending({ id, index, old, keepsLength: old?.keepsLength ?? true, home });
}

/** With a length that is kept, or not: of what is drawn next, and of what is drawn. */
export const withLength = (held: Bending, keepsLength: boolean): State => bending({ ...held, keepsLength });

/** The bend, once it is made. */
export const madeBend = ({ id, index }: Bending, document: Document): Bend | null =>
  surfaceIn(document, id)?.bends[index] ?? null;

function bending(held: Bending): State {
  const state: State = {
    name: 'bend.ready',
    waits: true,
    bending: held,
    marked: (bench) => marksOf(held, bench.document),
    down(pen, bench) {
      const part = surfaceIn(bench.document, held.id);
      if (!part) {
        bench.lookFrom(held.home);
        return choosing;
      }
      if (!isSeenAlong(part, held.index, bench.viewport.view)) {
        bench.notify('end-on');
        return undefined;
      }
      return drawing(stillThere(held, part), traceFrom(pen, bench.viewport.view));
    },
    leave: (bench) => bench.lookFrom(held.home),
    cancel: () => state,
  };
  return state;
}

/** Where bends beneath it were undone it comes after those that are left, and is a new one. */
const stillThere = (held: Bending, { bends: { length } }: SurfacePart): Bending =>
  held.index <= length ? held : { ...held, index: length, old: null };

function drawing(held: Bending, trace: Trace): State {
  return {
    name: 'bend.drawing',
    bending: held,
    wet: { pens: trace.pens, on: null, closing: false },
    marked: (bench) => marksOf(held, bench.document, true),
    preview: previewed((bench) => {
      const command = commandOf(held, trace, bench);
      return command && apply(bench.document, command);
    }),
    move: (pens) => drawing(held, traced(trace, pens)),
    up(bench) {
      const command = commandOf(held, trace, bench);
      if (command) bench.commit([command]);
      else bench.notify('too-short');
      return bending(held);
    },
    leave: (bench) => bench.lookFrom(held.home),
    cancel: () => bending(held),
  };
}

/** A new bend, or, until it is kept, another one in its place. */
function commandOf({ id, index, keepsLength }: Bending, trace: Trace, bench: Bench): Command | null {
  const part = surfaceIn(bench.document, id);
  const line = part ? axisOf(part, index) : [];
  if (!part || line.length === 0) return null;
  const plane = facingPlane(trace.view, middleOf(line));
  const isLoop = spineOf(part, index)?.closed === true && isClosing(trace);
  const drawn = strokeOf(plane, trace, bench.viewport.size, isLoop);
  if (!drawn) return null;
  const stroke = placedStroke(drawn, unplaced(part.placement));
  return part.bends[index]
    ? { type: 'setBend', id, index, change: { stroke, keepsLength } }
    : { type: 'bend', id, bend: { stroke, keepsLength, isOff: false } };
}

/** The axis as it was before this bend; and, when it is made, what was drawn. */
function marksOf(held: Bending, document: Document, isDrawing = false): readonly Mark[] {
  const part = surfaceIn(document, held.id);
  if (!part) return [];
  const bend = part.bends[held.index];
  const axis: Mark = { kind: 'line', style: 'axis', points: axisOf(part, held.index) };
  if (!bend || isDrawing) return [axis];
  return [
    axis,
    { kind: 'line', style: 'flat', points: strokePoints(placedStroke(bend.stroke, part.placement)) },
  ];
}

const strokePoints = ({ samples, plane }: Stroke): Vec3[] =>
  samples.map(({ x, y }) => toWorld(plane, [x, y]));

/** In the world. */
const axisOf = (part: SurfacePart, index: number): Vec3[] =>
  centreLine(part, index).map((p) => place3(part.placement, p));

function placedPlane({ strokes, placement }: SurfacePart): Plane {
  return placedStroke(strokes[0]!, placement).plane;
}

function middleOf(points: readonly Vec3[]): Vec3 {
  return scale3(
    points.reduce((sum, p) => add3(sum, p), [0, 0, 0] as Vec3),
    1 / points.length,
  );
}

/** From the end of the axis there is nothing to bend. */
function isSeenAlong(part: SurfacePart, index: number, view: View): boolean {
  const spine = spineOf(part, index);
  const plane = facingPlane(view, part.placement.translation);
  const onto = placedPlane(part);
  return spine !== null && isBendable(spine, within(plane, onto));
}

function surfaceIn({ parts }: Document, id: string): SurfacePart | null {
  const part = parts.find((other) => other.id === id);
  return part && isSurface(part) ? part : null;
}
