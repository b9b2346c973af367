import { type Brush, isBody, type Part } from '../document.ts';
import { changeParts, nameOf } from './changeParts.ts';
import type { CommandKind } from './index.ts';
import { brushWords } from './setBrush.ts';

export interface Data {
  readonly ids: readonly string[];
  readonly change: Partial<Brush>;
}

/** Colour, radius and the rest of kept parts; the strokes stay. Bodies have a colour, and nothing else of a brush. */
export const setPartBrush: CommandKind<'setPartBrush', Data> = {
  type: 'setPartBrush',
  apply: (document, { ids, change }) => changeParts(document, ids, (part) => brushed(part, change)),
  describe: (document, { ids, change }) =>
    `${brushWords(Object.keys(change) as (keyof Brush)[])} of ${nameOf(document, ids)}`,
};

function brushed(part: Part, change: Partial<Brush>): Part {
  if (isBody(part)) {
    const { colour = part.colour } = change;
    return colour === part.colour ? part : { ...part, colour };
  }
  const keys = Object.keys(change) as (keyof Brush)[];
  return keys.every((key) => change[key] === part.brush[key])
    ? part
    : { ...part, brush: { ...part.brush, ...change } };
}
