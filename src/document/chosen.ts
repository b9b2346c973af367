/** What a list of ids names in a document: whole parts, and within solids that are not chosen as a whole their components and groups. */
import { type Document, isSolid, type Part, type SolidPart } from './document.ts';
import type { Component, Group } from './solid.ts';
import { shapedOf } from './solidNode.ts';

/** A group and what it is in. */
export interface GroupAt {
  readonly group: Group;
  readonly component: Component;
  readonly solid: SolidPart;
}

/** Parts, and those that chosen components and groups are in; the document's order. */
export function partsWith({ parts }: Document, ids: readonly string[]): readonly Part[] {
  if (ids.length === 0) return [];
  const chosen = new Set(ids);
  const isIn = ({ components }: SolidPart) =>
    components.some(({ id, groups }) => chosen.has(id) || groups.some((group) => chosen.has(group.id)));
  return parts.filter((part) => chosen.has(part.id) || (isSolid(part) && isIn(part)));
}

/** All groups that are chosen, by themselves or with what they are in. */
export function groupsChosen({ parts }: Document, ids: readonly string[]): readonly GroupAt[] {
  const chosen = new Set(ids);
  return parts.filter(isSolid).flatMap((solid) => groupsIn(solid).filter((at) => isIn(at, chosen)));
}

export const groupsIn = (solid: SolidPart): readonly GroupAt[] =>
  solid.components.flatMap((component) => component.groups.map((group) => ({ group, component, solid })));

const isIn = ({ group, component, solid }: GroupAt, ids: ReadonlySet<string>): boolean =>
  ids.has(group.id) || ids.has(component.id) || ids.has(solid.id);

/** The group that a skel of the tree of a solid belongs to, by its place there (field/skelAt.ts): `parts[1].skels[3]`. */
export function groupAt(solid: SolidPart, path: string): Group | null {
  const [, of = '0', skel] = /^(?:parts\[(\d+)\]\.)?skels\[(\d+)\]$/.exec(path) ?? [];
  const component = solid.components[Number(of)];
  if (!component || skel === undefined) return null;
  let left = Number(skel);
  for (const group of component.groups.filter(({ hidden }) => !hidden)) {
    left -= shapedOf(group, component)?.skels.length ?? 0;
    if (left < 0) return group;
  }
  return null;
}
