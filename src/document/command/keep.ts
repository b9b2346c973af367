import { UNMOVED } from '../../math/placement.ts';
import { type Document, type Part, readingOf } from '../document.ts';
import { WORD } from '../words.ts';
import type { CommandKind } from './index.ts';

/** The unfinished form becomes a part; strokes that stay tubes become one part each. */
export const keep: CommandKind<'keep', object> = {
  type: 'keep',
  apply(document) {
    const parts = keptParts(document);
    if (parts.length === 0) return document;
    return {
      ...document,
      parts: [...document.parts, ...parts],
      draft: null,
      nextId: document.nextId + parts.length,
    };
  },
  describe: (document) => `${WORD[readingOf(document) ?? 'tube'].toLowerCase()} kept`,
};

function keptParts(document: Document): Part[] {
  const kind = readingOf(document);
  const strokes = document.draft?.strokes ?? [];
  if (kind === null) return [];
  const forms = kind === 'tube' ? strokes.map((stroke) => [stroke]) : [strokes];
  return forms.map((form, i) => {
    const number = document.nextId + i;
    return {
      id: `part-${number}`,
      name: `${WORD[kind]} ${number}`,
      kind,
      strokes: form,
      brush: document.brush,
      placement: UNMOVED,
      hidden: false,
    };
  });
}
