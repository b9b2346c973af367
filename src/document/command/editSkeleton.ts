import type { MedialGraph } from '../../skeleton/medial/axis.ts';
import { isGroupInReach } from '../inReach.ts';
import type { Group } from '../solid.ts';
import { changeParts, nameOf } from './changeParts.ts';
import type { CommandKind } from './index.ts';

export interface Data {
  /** of a group */
  readonly id: string;
  /** on the plane of its strokes, mm; null: from the strokes again */
  readonly skeleton: MedialGraph | null;
}

/** A skeleton by hand, in place of the one from the strokes, which stay. */
export const editSkeleton: CommandKind<'editSkeleton', Data> = {
  type: 'editSkeleton',
  apply: (document, { id, skeleton }) =>
    changeParts(
      document,
      [id],
      (part) => part,
      // of the group itself, and not of all that is in a component
      (group) => (group.id === id ? edited(group, skeleton) : group),
    ),
  describe: (document, { id }) => `skeleton of ${nameOf(document, [id])}`,
};

function edited(group: Group, skeleton: MedialGraph | null): Group {
  const next = { ...group, skeleton };
  return group.skeleton !== skeleton && isGroupInReach(next) ? next : group;
}
