import { drop } from './drop.ts';
import type { CommandKind } from './index.ts';

/** Deletes every part and the unfinished form (thesis, hot key E). */
export const removeAll: CommandKind<'removeAll', object> = {
  type: 'removeAll',
  apply: (document) => {
    const { parts } = document;
    return parts.length || document.draft ? { ...drop.apply(document, {}), parts: [] } : document;
  },
  describe: (document) => `all ${document.parts.length} parts deleted`,
};
