import type { Brush, Document } from '../document.ts';
import { type BrushChange, changedBrush } from '../finish.ts';
import type { CommandKind } from './index.ts';

/** Colour, radius and the rest of what the next form is made with. */
export const setBrush: CommandKind<'setBrush', { readonly change: BrushChange }> = {
  type: 'setBrush',
  apply(document, { change }) {
    const brush = changedBrush(document.brush, change);
    return brush === document.brush ? document : { ...document, brush };
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
  finish: 'finish',
};

/** What is changed, in words: "colour, radius". */
export const brushWords = (keys: readonly (keyof Brush)[]): string =>
  keys.map((key) => WORDS[key]).join(', ');

function changedKeys({ brush }: Document, change: BrushChange): (keyof Brush)[] {
  const next = changedBrush(brush, change);
  return (Object.keys(change) as (keyof Brush)[]).filter((key) => next[key] !== brush[key]);
}
