/** The rows of the list: parts, and of solids that are open what they are made of. A component has a row of its own where there are several. */
import { countsOfPart } from '../document/bodyCounts.ts';
import { groupsChosen } from '../document/chosen.ts';
import {
  type Document,
  isImplicit,
  isSolid,
  isSurface,
  type Part,
  type SolidPart,
  strokesOf,
} from '../document/document.ts';
import { type Component, type Group, groupsOf } from '../document/solid.ts';
import { shapedOf } from '../document/solidNode.ts';
import { kernelNamed } from '../kernel/index.ts';
import type { IconName } from './icons.ts';
import { PART_WORDS, SOLID_WORDS, SURFACE } from './words.ts';

/** What a row is of: the innermost that it has. */
export interface Row {
  readonly id: string;
  readonly name: string;
  readonly icon: IconName;
  readonly hidden: boolean;
  readonly part: Part;
  readonly component?: Component;
  readonly group?: Group;
  /** 1: of a part */
  readonly level: number;
  /** among its siblings, from 1 */
  readonly at: number;
  readonly of: number;
  /** of the row it is in */
  readonly parent: string | null;
  /** null: there is nothing in it */
  readonly open: boolean | null;
}

const cached = new WeakMap<
  readonly Part[],
  { readonly open: ReadonlySet<string>; readonly rows: readonly Row[] }
>();

/** `open`: ids of the rows whose content is shown. The same list for the same arguments. */
export function rowsOf(parts: readonly Part[], open: ReadonlySet<string>): readonly Row[] {
  const known = cached.get(parts);
  if (known?.open === open) return known.rows;
  const rows = parts.flatMap((part, i) => rowsOfPart(part, i + 1, parts.length, open));
  cached.set(parts, { open, rows });
  return rows;
}

function rowsOfPart(part: Part, at: number, of: number, open: ReadonlySet<string>): readonly Row[] {
  const { id, name, hidden, kind } = part;
  const isOpen = isSolid(part) ? open.has(id) : null;
  const own: Row = { id, name, icon: kind, hidden, part, level: 1, at, of, parent: null, open: isOpen };
  if (!isSolid(part) || !isOpen) return [own];
  const [only, ...others] = part.components;
  if (only && others.length === 0) return [own, ...groupRows(part, only, 2, id)];
  return [own, ...part.components.flatMap((component, i) => componentRows(part, component, i + 1, open))];
}

function componentRows(
  part: SolidPart,
  component: Component,
  at: number,
  open: ReadonlySet<string>,
): readonly Row[] {
  const { id, name, groups } = component;
  const isOpen = open.has(id);
  const own: Row = {
    id,
    name,
    icon: groups.length > 1 ? 'component' : iconOf(groups[0]!),
    hidden: groups.every(({ hidden }) => hidden),
    part,
    component,
    level: 2,
    at,
    of: part.components.length,
    parent: part.id,
    open: isOpen,
  };
  return isOpen ? [own, ...groupRows(part, component, 3, id)] : [own];
}

export const iconOf = ({ form, shape }: Pick<Group, 'form'> & Partial<Group>): IconName =>
  (shape?.weight ?? 1) < 0 ? 'carve' : form === 'soft' ? 'solid' : form;

const groupRows = (part: SolidPart, component: Component, level: number, parent: string): readonly Row[] =>
  component.groups.map((group, i) => ({
    id: group.id,
    name: group.name,
    icon: iconOf(group),
    hidden: group.hidden,
    part,
    component,
    group,
    level,
    at: i + 1,
    of: component.groups.length,
    parent,
    open: null,
  }));

/** "2 strokes", "12 skels"; bends are none of the strokes it is made of */
export function madeOf(part: Part): string {
  return isImplicit(part)
    ? PART_WORDS.skels(countsOfPart(part).skels)
    : PART_WORDS.strokes(strokesOf(isSurface(part) ? { ...part, bends: [] } : part).length);
}

/** "Soft · 12 skels", "Ring · 6 mm", "3 forms · 60 skels" */
export function factsOf({ part, component, group }: Row): string[] {
  if (group) return factsOfGroup(group, component!);
  if (component)
    return [
      SOLID_WORDS.component(component.groups.length),
      kernelNamed(component.kernel)?.label ?? component.kernel,
    ];
  if (!isSolid(part)) return [SURFACE[part.kind].name, madeOf(part)];
  return [SOLID_WORDS.inside(part.components.length, groupsOf(part).length), madeOf(part)];
}

function factsOfGroup(group: Group, component: Component): string[] {
  const { form, brush, shape, skeleton } = group;
  const skels = form === 'soft' ? (shapedOf(group, component)?.skels.length ?? 0) : 0;
  return [
    SOLID_WORDS.form[form],
    form === 'soft' ? PART_WORDS.skels(skels) : `${Math.round(10 * brush.radius) / 10} mm`,
    ...(shape.weight < 0 ? [SOLID_WORDS.carves] : []),
    ...(skeleton ? [SOLID_WORDS.byHand] : []),
  ];
}

/** With what these ids are in, so that their rows are there. */
export function openedFor(
  document: Document,
  ids: readonly string[],
  open: ReadonlySet<string>,
): ReadonlySet<string> {
  const parts = new Set(document.parts.map(({ id }) => id));
  const within = ids.filter((id) => !parts.has(id));
  if (within.length === 0) return open;
  const wanted = new Set(within);
  const around = groupsChosen(document, within).flatMap(({ group, component, solid }) =>
    wanted.has(group.id) ? [solid.id, component.id] : [solid.id],
  );
  return around.every((id) => open.has(id)) ? open : new Set([...open, ...around]);
}

/** With a row open, and all in it; or closed. */
export function toggled(document: Document, id: string, open: ReadonlySet<string>): ReadonlySet<string> {
  if (open.has(id)) return new Set([...open].filter((other) => other !== id));
  const part = document.parts.find((other) => other.id === id);
  const inside = part && isSolid(part) ? part.components.map((component) => component.id) : [];
  return new Set([...open, id, ...inside]);
}

/** None of them can be seen. */
export function isHidden(document: Document, ids: readonly string[]): boolean {
  const chosen = new Set(ids);
  const parts = document.parts.filter(({ id }) => chosen.has(id));
  const inside = groupsChosen(
    document,
    ids.filter((id) => !parts.some((part) => part.id === id)),
  );
  return parts.every(({ hidden }) => hidden) && inside.every(({ group }) => group.hidden);
}
