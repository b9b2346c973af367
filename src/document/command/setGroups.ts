import { isSolid } from '../document.ts';
import { type Group, type GroupShape, withGroups } from '../solid.ts';
import { changeParts, nameOf } from './changeParts.ts';
import type { CommandKind } from './index.ts';

export interface Data {
  /** of groups, or of components and solids for all that is in them */
  readonly ids: readonly string[];
  readonly change: Partial<GroupShape> & Partial<Pick<Group, 'form'>>;
}

/** What the strokes of kept groups become, their weight, cross section and profile. Another form takes its skeleton from the strokes again. */
export const setGroups: CommandKind<'setGroups', Data> = {
  type: 'setGroups',
  apply: (document, { ids, change }) =>
    changeParts(
      document,
      ids,
      (part) => (isSolid(part) ? withGroups(part, (group) => [changed(group, change)]) : part),
      (group) => changed(group, change),
    ),
  describe: (document, { ids, change }) =>
    `${Object.keys(change)
      .map((key) => WORDS[key as keyof typeof WORDS])
      .join(', ')} of ${nameOf(document, ids)}`,
};

const WORDS: Readonly<Record<keyof Data['change'], string>> = {
  form: 'form',
  weight: 'weight',
  breadth: 'breadth',
  depth: 'depth',
  section: 'cross section',
  exponent: 'corners',
  profile: 'profile',
  density: 'density',
  knots: 'knots',
};

function changed(group: Group, { form = group.form, ...rest }: Data['change']): Group {
  const keys = Object.keys(rest) as (keyof GroupShape)[];
  const isSame = form === group.form && keys.every((key) => rest[key] === group.shape[key]);
  if (isSame) return group;
  const skeleton = form === group.form ? group.skeleton : null;
  return { ...group, form, skeleton, shape: { ...group.shape, ...rest } };
}
