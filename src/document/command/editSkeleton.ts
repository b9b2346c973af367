import type { MedialGraph } from '../../skeleton/medial/axis.ts';
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
      (group) => (group.skeleton === skeleton ? group : { ...group, skeleton }),
    ),
  describe: (document, { id }) => `skeleton of ${nameOf(document, [id])}`,
};
