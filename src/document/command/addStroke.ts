import type { Vec2 } from '../../math/vec.ts';
import { isInside } from '../../skeleton/medial/outline.ts';
import type { Stroke } from '../../stroke/stroke.ts';
import { type Document, type Draft, readingOf, staysTubes } from '../document.ts';
import { MOST_HOLES } from '../solid.ts';
import { belongTogether } from '../together.ts';
import type { CommandKind } from './index.ts';
import { keep } from './keep.ts';

export interface Data extends Pick<Draft, 'form' | 'joins' | 'carves'> {
  readonly stroke: Stroke;
}

/** A further stroke of the unfinished form; one that cannot join it keeps it and begins the next, of which the rest is said. */
export const addStroke: CommandKind<'addStroke', Data> = {
  type: 'addStroke',
  apply(document, { stroke, form, joins, carves }) {
    if (document.draft && joinsDraft(document, stroke)) {
      const { draft } = document;
      return { ...document, draft: { ...draft, strokes: [...draft.strokes, stroke] } };
    }
    const on = document.draft ? keep.apply(document, {}) : document;
    const draft: Draft = {
      strokes: [stroke],
      ...(form && { form }),
      ...(joins && { joins }),
      ...(carves && { carves }),
    };
    return { ...on, draft };
  },
  describe: (document) => `stroke ${(document.draft?.strokes.length ?? 0) + 1}`,
};

/** The second stroke makes a form round; further ones inside an outline are holes of it. An open and a closed one have no ends in common: they stay two tubes. */
export function joinsDraft(document: Document, stroke: Stroke): boolean {
  const { strokes = [], form } = document.draft ?? {};
  const first = strokes[0];
  if (!first || !belongTogether(first, stroke)) return false;
  if (readingOf(document) === 'solid') {
    const holds = form === undefined || form === 'soft' || form === 'plate';
    return holds && stroke.closed && strokes.length <= MOST_HOLES && liesInside(stroke, first);
  }
  return strokes.length === 1 && !staysTubes(document) && form !== 'tube';
}

/** All of it. */
function liesInside({ samples }: Stroke, { samples: outline }: Stroke): boolean {
  const loop = outline.map(({ x, y }): Vec2 => [x, y]);
  return samples.every(({ x, y }) => isInside([x, y], [loop]));
}
