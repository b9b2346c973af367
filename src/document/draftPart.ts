/** The unfinished form as the solid it would be: one of its own, or one that is there already with one group more. */

import { UNMOVED, unplaced } from '../math/placement.ts';
import type { Document, SolidPart } from './document.ts';
import { isSolid, readingOf } from './document.ts';
import { placedStroke } from './placedStroke.ts';
import {
  type Component,
  DEFAULT_COMPONENT,
  DEFAULT_SHAPE,
  type Form,
  type Group,
  groupsOf,
  isForm,
} from './solid.ts';
import { shapedOf } from './solidNode.ts';
import { WORD } from './words.ts';

/** The part that the unfinished form joins; null: none, or it is gone. */
export function joinedOf(document: Document): SolidPart | null {
  const { draft, parts } = document;
  if (!draft?.joins || readingOf(document) !== 'solid') return null;
  return parts.filter(isSolid).find(({ id, hidden }) => id === draft.joins!.solid && !hidden) ?? null;
}

/** What closed strokes, or open ones, become when nobody chose. */
export const formOf = ({ draft }: Document): Form =>
  draft?.form !== undefined && isForm(draft.form) ? draft.form : 'soft';

const drafts = new WeakMap<Document, SolidPart | null>();

/** Null where the unfinished form is none. It has the id of the part it joins. */
export function draftPart(document: Document): SolidPart | null {
  const known = drafts.get(document);
  if (known !== undefined) return known;
  const group = draftGroup(document);
  const part = group && solidWith(document, group);
  drafts.set(document, part);
  return part;
}

/** Ids are those that it gets when it is kept, names count what is there. */
function draftGroup(document: Document): Group | null {
  const { draft, brush, nextId } = document;
  if (!draft || readingOf(document) !== 'solid') return null;
  const joined = joinedOf(document);
  const back = unplaced(joined?.placement ?? UNMOVED);
  const form = formOf(document);
  return {
    id: `group-${nextId + 2}`,
    name: `${WORD[form]} ${1 + (joined ? groupsOf(joined).length : 0)}`,
    hidden: false,
    form,
    strokes: draft.strokes.map((stroke) => placedStroke(stroke, back)),
    brush,
    shape: draft.carves && carvedBy(document) ? { ...DEFAULT_SHAPE, weight: -1 } : DEFAULT_SHAPE,
    skeleton: null,
    ...(draft.isRough && { isRough: true }),
  };
}

/** What it takes away from; null: nothing is there, and it is a body like others. */
const carvedBy = (document: Document): Component | null =>
  joinedOf(document)?.components.find(({ id }) => id === document.draft?.joins?.component) ?? null;

function solidWith(document: Document, group: Group): SolidPart {
  const { nextId, draft } = document;
  const joined = joinedOf(document);
  const component: Component = {
    id: `component-${nextId + 1}`,
    name: `${WORD.component} ${1 + (joined?.components.length ?? 0)}`,
    ...DEFAULT_COMPONENT,
    groups: [group],
  };
  if (!joined) {
    const name = `${WORD.solid} ${1 + document.parts.filter(isSolid).length}`;
    const id = `part-${nextId}`;
    return { id, name, kind: 'solid', components: [component], placement: UNMOVED, hidden: false };
  }
  const into = joined.components.find(({ id }) => id === draft?.joins?.component);
  const components = into
    ? joined.components.map((other) =>
        other === into ? { ...into, groups: [...into.groups, group] } : other,
      )
    : [...joined.components, component];
  return { ...joined, components };
}

/** Something can be made of it. */
export function hasDraftGroup(document: Document): boolean {
  const group = draftGroup(document);
  return group !== null && shapedOf(group, DEFAULT_COMPONENT) !== null;
}

/** Kept parts with the unfinished form among them, where it is a solid. */
export function partsWithDraft(document: Document): Document['parts'] {
  const draft = draftPart(document);
  if (!draft) return document.parts;
  const joined = joinedOf(document);
  return joined ? document.parts.map((part) => (part === joined ? draft : part)) : [...document.parts, draft];
}

/** As it is shown while the pen moves: an unfinished solid of fewer points. */
export function roughly(document: Document): Document {
  const { draft } = document;
  if (!draft || readingOf(document) !== 'solid') return document;
  return { ...document, draft: { ...draft, isRough: true } };
}
