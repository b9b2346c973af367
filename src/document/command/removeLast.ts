import { withoutHand } from './drop.ts';
import type { CommandKind } from './index.ts';

/** Deletes the part that was kept last (thesis, hot key C). */
export const removeLast: CommandKind<'removeLast', object> = {
  type: 'removeLast',
  apply: (document) => {
    const { parts } = document;
    return parts.length ? withoutHand({ ...document, parts: parts.slice(0, -1) }) : document;
  },
  describe: (document) => `${document.parts.at(-1)?.name ?? 'nothing'} deleted`,
};
