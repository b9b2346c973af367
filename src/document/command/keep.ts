import { UNMOVED, unplaced } from '../../math/placement.ts';
import {
  type Document,
  formOfDraft,
  isSurface,
  readingOf,
  type SolidPart,
  type SurfacePart,
} from '../document.ts';
import { draftPart, joinedOf } from '../draftPart.ts';
import { placedStroke } from '../placedStroke.ts';
import { withGroups } from '../solid.ts';
import { PLAIN, withStrokes } from '../surfacePart.ts';
import { WORD } from '../words.ts';
import type { CommandKind } from './index.ts';

/** The unfinished form becomes a part; strokes that stay tubes become one part each. */
export const keep: CommandKind<'keep', object> = {
  type: 'keep',
  apply(document) {
    if (readingOf(document) === 'solid') return keptSolid(document);
    const parts = keptParts(document);
    if (parts.length === 0) return document;
    const added = { ...document, draft: null, nextId: document.nextId + parts.length };
    const again = recreatedOf(document);
    if (!again) return { ...added, parts: [...document.parts, ...parts] };
    const [first, ...others] = parts;
    const whole = givenBack(again, first!, document);
    const all = document.parts.map((part) => (part === again ? whole : part));
    return { ...added, parts: [...all, ...others], brush: document.draft!.recreates!.brush };
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

/** The part whose strokes are in hand; null: none, or it is gone. */
export const recreatedOf = ({ draft, parts }: Document): SurfacePart | null =>
  parts.filter(isSurface).find(({ id }) => id === draft?.recreates?.part) ?? null;

/** Name, place and bends are the part's, all else is what was drawn. */
function givenBack(part: SurfacePart, drawn: SurfacePart, { brush }: Document): SurfacePart {
  const { kind, strokes, sections, back, between, detail } = drawn;
  const form = { strokes, sections, back, between, detail, bends: PLAIN.bends };
  const local = withStrokes(form, (stroke) => placedStroke(stroke, unplaced(part.placement)));
  return { ...part, ...local, kind, brush, bends: part.bends };
}

function keptParts(document: Document): SurfacePart[] {
  const kind = readingOf(document);
  const { draft } = document;
  if (!draft || kind === null || kind === 'solid') return [];
  const whole = formOfDraft(draft);
  const forms = kind === 'tube' ? draft.strokes.map((stroke) => [stroke]) : [draft.strokes];
  return forms.map((strokes, i) => {
    const number = document.nextId + i;
    return {
      id: `part-${number}`,
      name: `${WORD[kind]} ${number}`,
      kind,
      ...(i === 0 ? whole : PLAIN),
      strokes,
      brush: document.brush,
      placement: UNMOVED,
      hidden: false,
    };
  });
}
