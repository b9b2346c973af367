import { changeParts, nameOf } from './changeParts.ts';
import { withoutHand } from './drop.ts';
import type { CommandKind } from './index.ts';

/** Deletes the parts, components and groups with these ids; what is empty then goes with them. */
export const removeParts: CommandKind<'removeParts', { readonly ids: readonly string[] }> = {
  type: 'removeParts',
  apply(document, { ids }) {
    const gone = new Set(ids);
    const parts = document.parts.filter(({ id }) => !gone.has(id));
    const left = parts.length === document.parts.length ? document : withoutHand({ ...document, parts });
    return changeParts(
      left,
      ids,
      (part) => part,
      () => null,
    );
  },
  describe: (document, { ids }) => `${nameOf(document, ids)} deleted`,
};
