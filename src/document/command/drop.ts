import type { CommandKind } from './index.ts';

/** The whole unfinished form goes, in one undo step. */
export const drop: CommandKind<'drop', object> = {
  type: 'drop',
  apply: (document) => (document.draft ? { ...document, draft: null } : document),
  describe: () => 'drop',
};
