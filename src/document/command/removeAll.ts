import type { CommandKind } from './index.ts';

/** Deletes every part and the unfinished form (thesis, hot key E). */
export const removeAll: CommandKind<'removeAll', object> = {
  type: 'removeAll',
  apply: (document) =>
    document.parts.length || document.draft ? { ...document, parts: [], draft: null } : document,
  describe: (document) => `all ${document.parts.length} parts deleted`,
};
