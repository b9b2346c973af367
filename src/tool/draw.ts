/**
 * Draw: a stroke becomes part of the unfinished form, or keeps it and begins the next one. Strokes land on the
 * plane through the pivot that faces the camera; one that starts on a surface lies at the depth of that point;
 * all strokes of a form share the plane of its first (thesis ch. 5; the surface under the pen is ours).
 */

import { draftIsWhole } from '../document/build.ts';
import { joinsDraft } from '../document/command/addStroke.ts';
import { apply, type Command } from '../document/command/index.ts';
import { type Document, readingOf } from '../document/document.ts';
import { LIMITS } from '../document/limits.ts';
import { length2 } from '../math/tuple.ts';
import { facingPlane, onPlane, rayAt } from '../stroke/plane.ts';
import { isInReach, type Plane, type Sample, type Stroke, type View } from '../stroke/stroke.ts';
import type { Bench, Pen, State } from './tool.ts';
import type { Hit } from './viewport.ts';

/** Pixels. A tube is shown from here on, and a shorter gesture is a dot. */
const MINIMUM = 12;
/** Pixels, or this share of the length, whichever is more: near enough to the start to close. */
const CLOSING = { pixels: 24, share: 0.04 } as const;
/** Cosine between line of sight and plane normal below which strokes would stretch over five times. */
const EDGE_ON = 0.2;

export const idle: State = {
  name: 'draw.idle',
  down(pen, bench) {
    const { plane, on } = planeAt(bench, pen);
    if (isEdgeOn(plane, bench.viewport.view)) {
      bench.notify('edge-on');
      return undefined;
    }
    return drawing({ pens: [pen], plane, view: bench.viewport.view, on, length: 0, reach: 0 });
  },
  cancel: () => idle,
};

interface Drawn {
  readonly pens: Pen[];
  readonly plane: Plane;
  readonly view: View;
  readonly on: Hit | null;
  /** pixels along the path, and the furthest it has been from its start */
  readonly length: number;
  readonly reach: number;
}

function drawing(drawn: Drawn): State {
  return {
    name: drawn.length < MINIMUM ? 'draw.pointing' : 'draw.drawing',
    wet: { pens: drawn.pens, on: drawn.on, closing: isClosing(drawn) },
    preview: (bench) => previewOf(drawn, bench),
    move: (pens) => drawing(pens.reduce(extend, drawn)),
    up(bench) {
      const stroke = strokeOf(drawn, bench);
      if (drawn.length < MINIMUM || !stroke) bench.notify('too-short');
      else bench.commit(plan(bench.document, stroke));
      return idle;
    },
    cancel: () => idle,
  };
}

/** The pen's path is only ever appended to: copying it at each event would cost the square of its length.
 * What a file cannot hold is not drawn. */
function extend(drawn: Drawn, pen: Pen): Drawn {
  if (drawn.pens.length >= LIMITS.samples) return drawn;
  const last = drawn.pens.at(-1) ?? pen;
  const first = drawn.pens[0] ?? pen;
  drawn.pens.push(pen);
  return {
    ...drawn,
    length: drawn.length + length2([pen.x - last.x, pen.y - last.y]),
    reach: Math.max(drawn.reach, length2([pen.x - first.x, pen.y - first.y])),
  };
}

/** Near the start again, after having been clearly away from it. */
function isClosing({ pens, length, reach }: Drawn): boolean {
  const tolerance = Math.max(CLOSING.pixels, CLOSING.share * length);
  const first = pens[0];
  const last = pens.at(-1);
  if (!first || !last || reach < 1.5 * tolerance || length < 4 * tolerance) return false;
  return length2([last.x - first.x, last.y - first.y]) <= tolerance;
}

/** The second stroke of a form joins it wherever it starts. */
const joins = (document: Document): boolean => document.draft?.strokes.length === 1 && !document.tubesOnly;

function planeAt({ document, viewport }: Bench, { x, y }: Pen): { plane: Plane; on: Hit | null } {
  const first = document.draft?.strokes[0];
  if (first && joins(document)) return { plane: first.plane, on: null };
  const on = viewport.pick(x, y);
  return { plane: facingPlane(viewport.view, on?.point ?? viewport.view.pivot), on };
}

function isEdgeOn(plane: Plane, view: View): boolean {
  const facing = facingPlane(view, plane.origin);
  const normal = (p: Plane) => [
    p.x[1] * p.y[2] - p.x[2] * p.y[1],
    p.x[2] * p.y[0] - p.x[0] * p.y[2],
    p.x[0] * p.y[1] - p.x[1] * p.y[0],
  ];
  const a = normal(plane);
  const cosine = normal(facing).reduce((sum, value, i) => sum + value * (a[i] ?? 0), 0);
  return Math.abs(cosine) < EDGE_ON;
}

function strokeOf(drawn: Drawn, { viewport }: Bench): Stroke | null {
  const { pens, plane, view } = drawn;
  const start = pens[0]?.time ?? 0;
  const samples: Sample[] = [];
  for (const pen of pens) {
    const p = onPlane(rayAt(view, viewport.size, pen.x, pen.y), plane);
    if (!p || !isInReach(p)) continue;
    const { pressure, tiltX, tiltY } = pen;
    samples.push({ x: p[0], y: p[1], pressure, tiltX, tiltY, time: pen.time - start });
  }
  if (samples.length < 2 || !isInReach(plane.origin)) return null;
  return { samples, plane, view, pointer: pens[0]?.pointer ?? 'mouse', closed: isClosing(drawn) };
}

/** What a finished stroke does to a document: it joins the unfinished form, or keeps that and begins the next. */
export function plan(document: Document, stroke: Stroke): readonly Command[] {
  const add: Command = { type: 'addStroke', stroke };
  return !document.draft || joinsDraft(document, stroke) ? [add] : [...settled(document), add];
}

/** The unfinished form is kept, but nothing nobody could see: strokes that enclose nothing stay tubes, dots go. */
function settled(document: Document): readonly Command[] {
  const keep: Command = { type: 'keep' };
  if (draftIsWhole(document)) return [keep];
  const tubes: Command = { type: 'setTubesOnly', on: true };
  const rescued = readingOf(document) === 'rotational' && draftIsWhole(apply(document, tubes));
  return rescued ? [tubes, keep, { type: 'setTubesOnly', on: false }] : [{ type: 'drop' }];
}

/** A tube from its first 12 px on; a rotational surface once the second stroke is half as long as the first. */
function previewOf(drawn: Drawn, bench: Bench): Document | null {
  const stroke = drawn.length >= MINIMUM ? strokeOf(drawn, bench) : null;
  if (!stroke) return null;
  const commands = plan(bench.document, stroke);
  const first = bench.document.draft?.strokes[0];
  const young = commands.length === 1 && first && pathLength(stroke) < pathLength(first) / 2;
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
