/** Where the outlines of an unfinished solid cross themselves, or each other. Nothing of them is lost by it: what they go round is filled (form/soft.ts). */
import { crossingsOf } from '../math/untangle.ts';
import type { Vec3 } from '../math/vec.ts';
import { toWorld } from '../stroke/plane.ts';
import type { Stroke } from '../stroke/stroke.ts';
import { curveOfStroke } from './curves.ts';
import { type Document, readingOf } from './document.ts';
import { formOf } from './draftPart.ts';
import { loopsDrawn } from './form/soft.ts';

const known = new WeakMap<readonly Stroke[], readonly Vec3[]>();

/** In space, mm. */
export function draftCrossings(document: Document): readonly Vec3[] {
  const { draft, brush } = document;
  if (!draft || readingOf(document) !== 'solid') return [];
  if (formOf(document) !== 'soft' && formOf(document) !== 'plate') return [];
  const before = known.get(draft.strokes);
  if (before) return before;
  const curves = draft.strokes
    .map((stroke) => curveOfStroke(stroke, brush))
    .filter((curve) => curve !== null);
  const plane = draft.strokes[0]!.plane;
  const found = crossingsOf(loopsDrawn(curves)).map(({ at }) => toWorld(plane, at));
  known.set(draft.strokes, found);
  return found;
}
