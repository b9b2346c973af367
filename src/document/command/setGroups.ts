import { isSolid } from '../document.ts';
import { EXTRUSION, type Group, type GroupShape, mostStrokes, withGroups } from '../solid.ts';
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

/** A form that is made of fewer strokes is not taken, and an extrusion has no fewer corners than it can have. */
function changed(group: Group, { form: wanted = group.form, ...rest }: Data['change']): Group {
  const form = group.strokes.length > mostStrokes(wanted) ? group.form : wanted;
  const shape = { ...group.shape, ...rest };
  const exponent = shape.section === 'extrusion' ? Math.max(EXTRUSION, shape.exponent) : shape.exponent;
  const next = { ...shape, exponent };
  if (form === group.form && JSON.stringify(next) === JSON.stringify(group.shape)) return group;
  return { ...group, form, skeleton: form === group.form ? group.skeleton : null, shape: next };
}
