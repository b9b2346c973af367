import { compose, type Placement, UNMOVED, unplaced } from '../../math/placement.ts';
import { type Document, isSolid, type Joins, type Part, type SolidPart } from '../document.ts';
import { placedStroke } from '../placedStroke.ts';
import { type Component, DEFAULT_COMPONENT, type Group, groupsOf, withGroups } from '../solid.ts';
import { WORD } from '../words.ts';
import { nameOf } from './changeParts.ts';
import type { CommandKind } from './index.ts';

export interface Data {
  /** of groups, or of components and solids for all that is in them */
  readonly ids: readonly string[];
  /** null: a solid of their own */
  readonly to: Joins | null;
}

/**
 * Groups go into another component, where they blend with it, or beside the others of a solid. They stay where they are in space. A solid that is
 * taken as a whole keeps its components unless it is to blend: beside others, too, it is the form it was.
 */
export const moveGroups: CommandKind<'moveGroups', Data> = {
  type: 'moveGroups',
  apply(document, { ids, to }) {
    const taken = takenFrom(document, ids);
    if (taken.length === 0) return document;
    if (!to) {
      const isOwn = isOfOne(taken, ({ from }) => from) && isWhole(taken[0]!.from, taken);
      return isOwn ? document : settled(document, [...without(document, ids), ownSolid(document, taken)]);
    }
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

const isOfOne = <T>(taken: readonly Taken[], of: (one: Taken) => T): boolean =>
  taken.every((one) => of(one) === of(taken[0]!));

const isWhole = (solid: SolidPart, taken: readonly Taken[]): boolean =>
  groupsOf(solid).length === taken.filter(({ from }) => from === solid).length;

function isThereAlready(target: SolidPart, { component: to }: Joins, taken: readonly Taken[]): boolean {
  if (!taken.every(({ from }) => from === target)) return false;
  if (to !== null) return taken.every(({ component }) => component.id === to);
  const isComponent =
    isOfOne(taken, ({ component }) => component) && taken[0]!.component.groups.length === taken.length;
  return isComponent || isWhole(target, taken);
}

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
  taken: readonly Taken[],
): readonly Part[] {
  const coming =
    component === null && isWhole(target, taken) ? taken.filter((one) => one.from !== target) : taken;
  const gone = new Set(coming.map(({ group }) => group.id));
  const kept = target.components.map((of) => ({
    ...of,
    groups: of.groups.filter(({ id }) => !gone.has(id)),
  }));
  const blended = () => coming.map(({ group, from }) => placedIn(group, from, target.placement));
  const components = component
    ? kept.map((of) => (of.id === component ? { ...of, groups: [...of.groups, ...blended()] } : of))
    : [...kept, ...beside(document, coming, target.placement, target.components[0])];
  const solid = { ...target, components: components.filter((of) => of.groups.length > 0) };
  return without(document, ids, target.id).map((part) => (part.id === target.id ? solid : part));
}

/** Components of whole solids as they are; all else in one, which sums as `like` does. */
function beside(
  document: Document,
  taken: readonly Taken[],
  into: Placement,
  like?: Component,
): readonly Component[] {
  const wholes = [...new Set(taken.map(({ from }) => from))].filter((from) => isWhole(from, taken));
  const whole = wholes.flatMap((from) =>
    from.components.map((of) => ({ ...of, groups: of.groups.map((group) => placedIn(group, from, into)) })),
  );
  const loose = taken.filter(({ from }) => !wholes.includes(from));
  if (loose.length === 0) return whole;
  const groups = loose.map(({ group, from }) => placedIn(group, from, into));
  const { kernel, threshold } = like ?? loose[0]!.component;
  return [...whole, { ...componentFor(document, groups), kernel, threshold }];
}

function ownSolid(document: Document, taken: readonly Taken[]): SolidPart {
  const number = document.nextId + 1;
  return {
    id: `part-${number}`,
    name: `${WORD.solid} ${number}`,
    kind: 'solid',
    components: beside(document, taken, UNMOVED),
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
