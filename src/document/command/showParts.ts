import { changeParts, nameOf } from './changeParts.ts';
import type { CommandKind } from './index.ts';

export interface Data {
  readonly ids: readonly string[];
  readonly visible: boolean;
}

/** Hides parts, or shows them again; a hidden part is neither drawn nor exported. */
export const showParts: CommandKind<'showParts', Data> = {
  type: 'showParts',
  apply: (document, { ids, visible }) =>
    changeParts(
      document,
      ids,
      (part) => (part.hidden === !visible ? part : { ...part, hidden: !visible }),
      (group) => (group.hidden === !visible ? group : { ...group, hidden: !visible }),
    ),
  describe: (document, { ids, visible }) => `${nameOf(document, ids)} ${visible ? 'shown' : 'hidden'}`,
};
