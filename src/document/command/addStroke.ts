import type { Plane, Stroke } from '../../stroke/stroke.ts';
import type { Document } from '../document.ts';
import type { CommandKind } from './index.ts';
import { keep } from './keep.ts';

/** A further stroke of the unfinished form; one that cannot join it keeps it and begins the next. */
export const addStroke: CommandKind<'addStroke', { readonly stroke: Stroke }> = {
  type: 'addStroke',
  apply(document, { stroke }) {
    const on = !document.draft || joinsDraft(document, stroke) ? document : keep.apply(document, {});
    return { ...on, draft: { strokes: [...(on.draft?.strokes ?? []), stroke] } };
  },
  describe: (document) => `stroke ${(document.draft?.strokes.length ?? 0) + 1}`,
};

/** The second stroke makes a form round. An open and a closed one have no ends in common: they stay two tubes. */
export function joinsDraft(document: Document, stroke: Stroke): boolean {
  const strokes = document.draft?.strokes ?? [];
  const first = strokes[0];
  if (!first || strokes.length > 1 || document.tubesOnly) return false;
  return belongTogether(first, stroke);
}

/** May two strokes be sides of one form? */
export function belongTogether(a: Stroke, b: Stroke): boolean {
  return a.closed === b.closed && samePlane(a.plane, b.plane);
}

function samePlane(a: Plane, b: Plane): boolean {
  const same = (key: keyof Plane) => a[key].every((value, i) => value === b[key][i]);
  return a === b || (same('origin') && same('x') && same('y'));
}
