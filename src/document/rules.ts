/**
 * What a schema cannot say field by field: that axes are at right angles, that a surface has its number of strokes, that
 * ids differ. A JSON Schema cannot say it either; `docs/format.md` lists these rules.
 */
import * as v from 'valibot';
import { bindField } from '../field/bind.ts';
import type { FieldNode } from '../field/node.ts';
import type { Plane } from '../math/plane.ts';
import { dot3, length3 } from '../math/tuple.ts';
import type { Quat, Vec3 } from '../math/vec.ts';
import type { MedialGraph } from '../skeleton/medial/axis.ts';
import { FieldError } from '../skeleton/skeleton.ts';
import { itemsOf } from './command/changeParts.ts';
import type { BodyPart, Document, Draft, Part, SolidPart, SurfacePart } from './document.ts';
import { LIMITS, UNIT_TOLERANCE } from './limits.ts';
import { type Fault, pathTo } from './samples.ts';
import { isTooLarge, SIZE } from './size.ts';
import { type Component, EXTRUSION, type Group, isForm, MOST_HOLES, mostStrokes } from './solid.ts';
import { strayIn, straySection } from './strays.ts';
import { MADE_OF } from './surfacePart.ts';
import { WORD } from './words.ts';

/** A rule as a step of a schema; it is asked only where every field is what it should be. */
function rule<T>(fault: (value: T) => Fault | null) {
  return v.rawCheck<T>(({ dataset, addIssue }) => {
    if (!dataset.typed || dataset.issues) return;
    const found = fault(dataset.value);
    if (!found) return;
    const { expected, path, refused } = found;
    const said = { message: refused ?? expected, ...(refused && { received: REFUSED }) };
    addIssue(path.length ? { ...said, path: pathTo(dataset.value, path) } : said);
  });
}

/** Marks a message that says all, without what was expected and found. */
export const REFUSED = 'refused';

const isNear = (value: number, wanted: number): boolean => Math.abs(value - wanted) <= UNIT_TOLERANCE;

export const planeRules = <T extends Plane>() =>
  rule<T>(({ x, y }) => {
    if (!isNear(length3(x), 1)) return { expected: 'a unit vector', path: ['x'] };
    const fits = isNear(length3(y), 1) && isNear(dot3(x, y), 0);
    return fits ? null : { expected: 'a unit vector at right angles to x', path: ['y'] };
  });

export const unitRules = <T extends Vec3>() =>
  rule<T>((vector) =>
    isNear(length3(vector), 1) ? null : { expected: 'a unit vector, three numbers', path: [] },
  );

export const rotationRules = <T extends Quat>() =>
  rule<T>((q) => {
    const length = Math.sqrt(q.reduce((sum, value) => sum + value * value, 0));
    return isNear(length, 1) ? null : { expected: 'a unit quaternion, four numbers', path: [] };
  });

export const partRules = <T extends Pick<SurfacePart, 'kind' | 'strokes' | 'sections'>>() =>
  rule<T>(({ kind, strokes, sections }) => {
    const { strokes: count, sections: needed } = MADE_OF[kind];
    if (strokes.length < count.least || strokes.length > count.most) {
      const many = count.least === count.most ? `${count.least}` : `${count.least} or ${count.most}`;
      const expected = `${many} stroke${count.most === 1 ? '' : 's'}, which "${kind}" is made of`;
      return { expected, path: ['strokes'] };
    }
    if (sections.length < needed)
      return {
        expected: `at least ${needed} section${needed === 1 ? '' : 's'}, which "${kind}" is made of`,
        path: ['sections'],
      };
    return strayIn(strokes) ?? straySection(strokes, sections);
  });

/** of one form */
const MOST_STROKES = Math.max(...Object.values(MADE_OF).map(({ strokes }) => strokes.most));

export const draftRules = <T extends Draft>() =>
  rule<T>((draft) => {
    const { strokes, sections = [] } = draft;
    const most = mostOf(draft);
    if (strokes.length >= 1 && strokes.length <= most)
      return strayIn(strokes) ?? straySection(strokes, sections);
    return { expected: `1 to ${most} strokes, else null for the whole draft`, path: ['strokes'] };
  });

/** Closed strokes may be made tubes of, one each, however many there are. */
function mostOf({ form, strokes, sections = [], recreates }: Draft): number {
  if (form !== undefined && isForm(form)) return mostStrokes(form);
  const isUnsaid = form === undefined && sections.length === 0 && !recreates;
  return strokes[0]?.closed && (isUnsaid || form === 'tube') ? MOST_HOLES + 1 : MOST_STROKES;
}

/** Outlines have holes; everything else is of one stroke. */
export const groupRules = <T extends Pick<Group, 'form' | 'strokes' | 'shape'>>() =>
  rule<T>(({ form, strokes, shape: { section, exponent } }) => {
    if (section === 'extrusion' && exponent < EXTRUSION)
      return { expected: 'a number from 2 to 100, of an extrusion', path: ['shape', 'exponent'] };
    const most = mostStrokes(form);
    if (strokes.length >= 1 && strokes.length <= most) return strayIn(strokes);
    return {
      expected: most > 1 ? `1 to ${most} strokes` : `1 stroke, which "${form}" is made of`,
      path: ['strokes'],
    };
  });

export const graphRules = <T extends MedialGraph>() =>
  rule<T>(({ nodes, links }) => {
    const stray = links.findIndex(([a, b]) => a >= nodes.length || b >= nodes.length || a === b);
    return stray < 0 ? null : { expected: 'two indices of circles that are there', path: ['links', stray] };
  });

/** One of two fields is there, and not the other. */
export const eitherOf = <T extends object>(one: string, other: string) =>
  rule<T>((value) => {
    if (one in value !== other in value) return null;
    return { expected: `${one} or ${other}, one of the two`, path: [] };
  });

/** A curve is cut into so many segments a piece that there is room for them. */
export const cutInBounds = <T extends { readonly points: readonly unknown[]; readonly density: number }>() =>
  rule<T>(({ points, density }) => {
    if (points.length * density <= LIMITS.skels) return null;
    return { expected: `at most ${LIMITS.skels} segments, points times density`, path: ['density'] };
  });

/** A tree that makes a field; what is wrong with it is said where fields are made. */
export const bindable = () =>
  rule<FieldNode>((node) => {
    try {
      bindField(node);
      return null;
    } catch (error) {
      if (!(error instanceof FieldError)) throw error;
      const [, place = '', why = error.message] = /^([\w.[\]]+): (.*)$/s.exec(error.message) ?? [];
      return { expected: 'a field', path: stepsOf(place), refused: `makes no field: ${why}` };
    }
  });

/** `parts[1].node` → parts, 1, node */
const stepsOf = (place: string): PropertyKey[] =>
  (place.match(/\w+/g) ?? []).map((step) => (/^\d+$/.test(step) ? Number(step) : step));

type Unnamed<P> = Omit<P, 'id' | 'name'> & {
  readonly id?: string | undefined;
  readonly name?: string | undefined;
};

type UnnamedSolid = Unnamed<Omit<SolidPart, 'components'>> & {
  readonly components: readonly (Unnamed<Omit<Component, 'groups'>> & {
    readonly groups: readonly Unnamed<Group>[];
  })[];
};

/** A document whose parts may lack what can be worked out. */
export type Incomplete = Omit<Document, 'parts' | 'nextId'> & {
  readonly parts: readonly (Unnamed<SurfacePart> | Unnamed<BodyPart> | UnnamedSolid)[];
  readonly nextId?: number | undefined;
};

/** Ids, names and the next number, where they were left out. */
export function completed(document: Incomplete): Document {
  const named = document.parts.map((part, i) => {
    const { id = `part-${i + 1}`, name = `${WORD[part.kind]} ${i + 1}` } = part;
    return { ...part, id, name };
  });
  // numbers of what is in solids begin after all that are there
  const first = 1 + Math.max(highestNumber(named), named.length);
  let free = first;
  const parts = named.map(
    (part): Part => (part.kind === 'solid' ? completedSolid(part, () => free++) : part),
  );
  const { nextId = HIGH } = document;
  const above = 1 + highestNumber(allOf(parts));
  // numbers that were given here are in nobody's way
  const least = free > first ? above : nextId;
  return { ...document, parts, nextId: nextId < HIGH ? Math.max(nextId, least) : above };
}

function completedSolid(part: UnnamedSolid & Pick<SolidPart, 'id' | 'name'>, free: () => number): SolidPart {
  const components = part.components.map((component): Component => {
    const groups = component.groups.map((group): Group => {
      const number = group.id === undefined || group.name === undefined ? free() : 0;
      return {
        ...group,
        id: group.id ?? `group-${number}`,
        name: group.name ?? `${WORD[group.form]} ${number}`,
      };
    });
    const number = component.id === undefined || component.name === undefined ? free() : 0;
    const { id = `component-${number}`, name = `${WORD.component} ${number}` } = component;
    return { ...component, id, name, groups };
  });
  return { ...part, components };
}

/** Numbers stay so far below what integers can be that no amount of drawing gets there. */
const HIGH = 4e15;

/** Of ids as the program gives them, `part-7`, `group-8`; longer numbers are words like any other. */
function highestNumber(items: readonly { readonly id: string }[]): number {
  const numberIn = (id: string) => Number(/^(?:part|component|group)-(\d{1,15})$/.exec(id)?.[1] ?? 0);
  return items.reduce((most, { id }) => Math.max(most, numberIn(id)), 0);
}

interface PlacedItem {
  readonly item: { readonly id: string };
  readonly path: readonly PropertyKey[];
}

/** Everything that has an id, and where it is. */
function placesOf(parts: readonly Part[]): readonly PlacedItem[] {
  return parts.flatMap((part, i): readonly PlacedItem[] => {
    const path = ['parts', i];
    if (part.kind !== 'solid') return [{ item: part, path }];
    const inside = part.components.flatMap((component, k): readonly PlacedItem[] => {
      const place = [...path, 'components', k];
      const groups = component.groups.map((group, n) => ({ item: group, path: [...place, 'groups', n] }));
      return [{ item: component, path: place }, ...groups];
    });
    return [{ item: part, path }, ...inside];
  });
}

const allOf = (parts: readonly Part[]) => itemsOf({ parts } as Document);

export const documentRules = <T extends Document>() =>
  rule<T>((document) => {
    const { parts, nextId } = document;
    if (isTooLarge(document)) return { expected: SIZE, path: ['parts'] };
    const seen = new Set<string>();
    const isTwin = ({ id }: { readonly id: string }) => seen.size === seen.add(id).size;
    const twin = placesOf(parts).find(({ item }) => isTwin(item));
    if (twin) return { expected: 'an id that nothing else has', path: [...twin.path, 'id'] };
    const highest = highestNumber(allOf(parts));
    if (nextId > highest) return null;
    return { expected: `a whole number above ${highest}, which is in use`, path: ['nextId'] };
  });
