import { UNMOVED } from '../../math/placement.ts';
import { type Document, type Part, readingOf, type SolidPart } from '../document.ts';
import { draftPart, joinedOf } from '../draftPart.ts';
import { withGroups } from '../solid.ts';
import { WORD } from '../words.ts';
import type { CommandKind } from './index.ts';

/** The unfinished form becomes a part; strokes that stay tubes become one part each. */
export const keep: CommandKind<'keep', object> = {
  type: 'keep',
  apply(document) {
    if (readingOf(document) === 'solid') return keptSolid(document);
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

/** Ids as `draftPart` gives them: of the group, its component and its part. */
const IDS = 3;

function keptSolid(document: Document): Document {
  const solid = draftPart(document)!;
  const joined = joinedOf(document);
  const parts = joined
    ? document.parts.map((part) => (part === joined ? unrough(solid) : part))
    : [...document.parts, unrough(solid)];
  return { ...document, parts, draft: null, nextId: document.nextId + IDS };
}

function unrough(solid: SolidPart): SolidPart {
  return withGroups(solid, (group) => {
    const { isRough, ...plain } = group;
    return [isRough ? plain : group];
  });
}

function keptParts(document: Document): Part[] {
  const kind = readingOf(document);
  const strokes = document.draft?.strokes ?? [];
  if (kind === null || kind === 'solid') return [];
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
