import { UNMOVED, unplaced } from '../../math/placement.ts';
import type { Stroke } from '../../stroke/stroke.ts';
import {
  type Brush,
  type Document,
  formOfDraft,
  isSurface,
  readingOf,
  type SolidPart,
  type SurfacePart,
  tubesOf,
} from '../document.ts';
import { draftPart, joinedOf } from '../draftPart.ts';
import { isFormInReach } from '../inReach.ts';
import { placedStroke } from '../placedStroke.ts';
import { withGroups } from '../solid.ts';
import { PLAIN, strokesOfForm, withStrokes } from '../surfacePart.ts';
import { samePlane } from '../together.ts';
import { WORD } from '../words.ts';
import type { CommandKind } from './index.ts';

/** The unfinished form becomes a part; strokes that stay tubes become one part each. Strokes of a part in hand go back to it. */
export const keep: CommandKind<'keep', object> = {
  type: 'keep',
  apply(document) {
    if (readingOf(document) === 'solid') return keptSolid(document);
    const again = recreatedOf(document);
    const drawn = keptParts(document, document.nextId);
    const [first] = drawn;
    if (!first) return document;
    const whole = again && givenBack(again, first, document);
    // the first one has an id already
    const added = whole ? keptParts(document, document.nextId - 1).slice(1) : drawn;
    return {
      ...document,
      parts: [...document.parts.map((part) => (whole && part === again ? whole : part)), ...added],
      draft: null,
      brush: brushAfter(document),
      nextId: document.nextId + added.length,
    };
  },
  describe(document) {
    const what = recreatedOf(document)?.name ?? WORD[readingOf(document) ?? 'tube'].toLowerCase();
    return `${what} kept`;
  },
};

/** What the next form is made with. */
const brushAfter = ({ draft, brush }: Document): Brush => draft?.recreates?.brush ?? brush;

/** Ids as `draftPart` gives them: of the group, its component and its part. */
const IDS = 3;

/** A part whose strokes become a solid is that solid from then on, or goes into the one they join. */
function keptSolid(document: Document): Document {
  const solid = draftPart(document)!;
  const joined = joinedOf(document);
  const again = recreatedOf(document);
  const place = joined ?? again;
  const { id, name } = place ?? solid;
  const kept = { ...unrough(solid), id, name };
  const parts = place
    ? document.parts.flatMap((part) => (part === place ? [kept] : part === again ? [] : [part]))
    : [...document.parts, kept];
  return { ...document, parts, draft: null, brush: brushAfter(document), nextId: document.nextId + IDS };
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

/** Name, place and bends are the part's, all else is what was drawn. Null where that would be out of reach. */
function givenBack(part: SurfacePart, drawn: SurfacePart, { brush }: Document): SurfacePart | null {
  const { kind, strokes, sections, back, between, detail } = drawn;
  const local = withStrokes({ strokes, sections, bends: PLAIN.bends }, homeOf(part));
  const { bends } = part;
  if (!isFormInReach({ ...local, bends })) return null;
  return { ...part, ...local, back, between, detail, kind, brush, bends };
}

/** Planes that the part has already are those, to the bit: what was not changed comes back as it was. */
export function homeOf(part: SurfacePart): (stroke: Stroke) => Stroke {
  const own = strokesOfForm(part).map((stroke) => ({
    before: stroke.plane,
    after: placedStroke(stroke, part.placement).plane,
  }));
  const way = unplaced(part.placement);
  return (stroke) => {
    const known = own.find(({ after }) => samePlane(after, stroke.plane));
    return known ? { ...stroke, plane: known.before } : placedStroke(stroke, way);
  };
}

/** Numbered from `first`. */
function keptParts(document: Document, first: number): SurfacePart[] {
  const kind = readingOf(document);
  const { draft } = document;
  if (!draft || kind === null || kind === 'solid') return [];
  const whole = formOfDraft(draft);
  const forms = kind === 'tube' ? tubesOf(whole) : [whole];
  return forms.map((form, i) => ({
    id: `part-${first + i}`,
    name: `${WORD[kind]} ${first + i}`,
    kind,
    ...form,
    brush: document.brush,
    placement: UNMOVED,
    hidden: false,
  }));
}
