import type { CommandKind } from './index.ts';

/** Steps back from two strokes to two tubes, or forward again; no stroke is lost. */
export const setTubesOnly: CommandKind<'setTubesOnly', { readonly on: boolean }> = {
  type: 'setTubesOnly',
  apply: (document, { on }) => (document.tubesOnly === on ? document : { ...document, tubesOnly: on }),
  describe: (_document, { on }) => (on ? 'every stroke a tube' : 'two strokes make it round'),
};
