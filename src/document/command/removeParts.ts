import { nameOf } from './changeParts.ts';
import type { CommandKind } from './index.ts';

/** Deletes the parts with these ids. */
export const removeParts: CommandKind<'removeParts', { readonly ids: readonly string[] }> = {
  type: 'removeParts',
  apply(document, { ids }) {
    const gone = new Set(ids);
    const parts = document.parts.filter(({ id }) => !gone.has(id));
    return parts.length === document.parts.length ? document : { ...document, parts };
  },
  describe: (document, { ids }) => `${nameOf(document, ids)} deleted`,
};
