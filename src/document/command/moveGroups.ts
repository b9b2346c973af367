import { compose, type Placement, UNMOVED, unplaced } from '../../math/placement.ts';
import { type Document, isSolid, type Joins, type Part, type SolidPart } from '../document.ts';
import { placedStroke } from '../placedStroke.ts';
import { type Component, DEFAULT_COMPONENT, type Group, withGroups } from '../solid.ts';
import { WORD } from '../words.ts';
import { nameOf } from './changeParts.ts';
import type { CommandKind } from './index.ts';

export interface Data {
  /** of groups, or of components and solids for all that is in them */
  readonly ids: readonly string[];
  /** null: a solid of their own */
  readonly to: Joins | null;
}

/** Groups go into another component, where they blend with it, or beside the others of a solid. They stay where they are in space. */
export const moveGroups: CommandKind<'moveGroups', Data> = {
  type: 'moveGroups',
  apply(document, { ids, to }) {
    const taken = takenFrom(document, ids);
    if (taken.length === 0) return document;
    if (!to && isWholeSolid(taken)) return document;
    if (!to) return settled(document, [...without(document, ids), ownSolid(document, taken)]);
    const target = document.parts.filter(isSolid).find(({ id }) => id === to.solid);
    const isThere =
      target && (to.component === null || target.components.some(({ id }) => id === to.component));
    if (!isThere || isThereAlready(target, to, taken)) return document;
    return settled(document, joined(document, ids, target, to, taken));
  },
  describe: (document, { ids, to }) =>
    `${nameOf(document, ids)} ${to ? (to.component ? 'blends' : 'attached') : 'apart'}`,
};

interface Taken {
  readonly group: Group;
  readonly from: SolidPart;
  readonly component: Component;
}

function takenFrom({ parts }: Document, ids: readonly string[]): readonly Taken[] {
  const chosen = new Set(ids);
  return parts.filter(isSolid).flatMap((from) =>
    from.components.flatMap((component) => {
      const all = chosen.has(from.id) || chosen.has(component.id);
      return component.groups
        .filter(({ id }) => all || chosen.has(id))
        .map((group) => ({ group, from, component }));
    }),
  );
}

const isWhole = (component: Component, taken: readonly Taken[]): boolean =>
  component.groups.every((group) => taken.some((one) => one.group === group));

/** Beside the others of a solid lies what is all of its component. */
const isThereAlready = (target: SolidPart, { component }: Joins, taken: readonly Taken[]): boolean =>
  taken.every(
    ({ from, component: now }) =>
      from === target && (component === null ? isWhole(now, taken) : now.id === component),
  );

const isWholeSolid = (taken: readonly Taken[]): boolean =>
  taken.every(({ from }) => from === taken[0]!.from && from.components.every((of) => isWhole(of, taken)));

function placedIn(group: Group, from: SolidPart, into: Placement): Group {
  const by = compose(unplaced(into), from.placement);
  return { ...group, strokes: group.strokes.map((stroke) => placedStroke(stroke, by)) };
}

/** The solid stays, though nothing may be left in it but what comes. */
function joined(
  document: Document,
  ids: readonly string[],
  target: SolidPart,
  { component }: Joins,
  all: readonly Taken[],
): readonly Part[] {
  // a component of the solid's own that is taken whole is beside the others already
  const stays = (one: Taken) => component === null && one.from === target && isWhole(one.component, all);
  const taken = all.filter((one) => !stays(one));
  const gone = new Set(taken.map(({ group }) => group.id));
  const groups = taken.map(({ group, from }) => placedIn(group, from, target.placement));
  const kept = target.components.map((of) => ({
    ...of,
    groups: of.groups.filter(({ id }) => !gone.has(id)),
  }));
  const components = component
    ? kept.map((of) => (of.id === component ? { ...of, groups: [...of.groups, ...groups] } : of))
    : [...kept.filter((of) => of.groups.length > 0), ...componentsOf(document, taken, target.placement)];
  const solid = { ...target, components: components.filter((of) => of.groups.length > 0) };
  return without(document, ids, target.id).map((part) => (part.id === target.id ? solid : part));
}

/** What blended as a whole goes on as a component of its own; single groups become one together. */
function componentsOf(document: Document, taken: readonly Taken[], into: Placement): readonly Component[] {
  const wholes = taken.filter(
    ({ component, group }) => group === component.groups[0] && isWhole(component, taken),
  );
  const loose = taken.filter(({ component }) => !isWhole(component, taken));
  const moved = wholes.map(({ component, from }) => ({
    ...component,
    groups: component.groups.map((group) => placedIn(group, from, into)),
  }));
  if (loose.length === 0) return moved;
  const { kernel, threshold } = loose[0]!.component;
  const groups = loose.map(({ group, from }) => placedIn(group, from, into));
  return [...moved, { ...componentFor(document, groups), kernel, threshold }];
}

function ownSolid(document: Document, taken: readonly Taken[]): SolidPart {
  return {
    id: `part-${document.nextId + 1}`,
    name: `${WORD.solid} ${1 + document.parts.filter(isSolid).length}`,
    kind: 'solid',
    components: componentsOf(document, taken, UNMOVED),
    placement: UNMOVED,
    hidden: false,
  };
}

function componentFor({ nextId }: Document, groups: readonly Group[]): Component {
  return { id: `component-${nextId}`, name: `${WORD.component} ${nextId}`, ...DEFAULT_COMPONENT, groups };
}

/** Parts without these groups; those that are empty then are gone, but for one. */
function without({ parts }: Document, ids: readonly string[], stays?: string): readonly Part[] {
  const chosen = new Set(ids);
  return parts.flatMap((part): readonly Part[] => {
    if (!isSolid(part) || part.id === stays) return [part];
    const left = withGroups(part, (group, of) =>
      chosen.has(part.id) || chosen.has(of.id) || chosen.has(group.id) ? [] : [group],
    );
    return left.components.length > 0 ? [left] : [];
  });
}

const settled = (document: Document, parts: readonly Part[]): Document => ({
  ...document,
  parts,
  nextId: document.nextId + 2,
});
