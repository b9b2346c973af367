import type { Brush, Document } from '../document.ts';
import type { CommandKind } from './index.ts';

/** Colour, radius and the rest of what the next form is made with. */
export const setBrush: CommandKind<'setBrush', { readonly change: Partial<Brush> }> = {
  type: 'setBrush',
  apply(document, { change }) {
    return changedKeys(document, change).length
      ? { ...document, brush: { ...document.brush, ...change } }
      : document;
  },
  describe: (document, { change }) => brushWords(changedKeys(document, change)),
};

const WORDS: Readonly<Record<keyof Brush, string>> = {
  colour: 'colour',
  radius: 'radius',
  pressure: 'pressure',
  caps: 'closed ends',
  filter: 'stroke filter',
  levels: 'smoothing',
};

/** What is changed, in words: "colour, radius". */
export const brushWords = (keys: readonly (keyof Brush)[]): string =>
  keys.map((key) => WORDS[key]).join(', ');

function changedKeys(document: Document, change: Partial<Brush>): (keyof Brush)[] {
  return (Object.keys(change) as (keyof Brush)[]).filter((key) => change[key] !== document.brush[key]);
}
