import { type Brush, isBody, isSolid, type Part } from '../document.ts';
import { type Group, withGroups } from '../solid.ts';
import { changeParts, nameOf } from './changeParts.ts';
import type { CommandKind } from './index.ts';
import { brushWords } from './setBrush.ts';

export interface Data {
  readonly ids: readonly string[];
  readonly change: Partial<Brush>;
}

/** Colour, radius and the rest of kept parts; the strokes stay. Bodies have a colour, and nothing else of a brush; of a solid all groups are set. */
export const setPartBrush: CommandKind<'setPartBrush', Data> = {
  type: 'setPartBrush',
  apply: (document, { ids, change }) =>
    changeParts(
      document,
      ids,
      (part) => brushed(part, change),
      (group) => groupBrushed(group, change),
    ),
  describe: (document, { ids, change }) =>
    `${brushWords(Object.keys(change) as (keyof Brush)[])} of ${nameOf(document, ids)}`,
};

function brushed(part: Part, change: Partial<Brush>): Part {
  if (isBody(part)) {
    const { colour = part.colour } = change;
    return colour === part.colour ? part : { ...part, colour };
  }
  if (isSolid(part)) return withGroups(part, (group) => [groupBrushed(group, change)]);
  return hasAll(part.brush, change) ? part : { ...part, brush: { ...part.brush, ...change } };
}

const groupBrushed = (group: Group, change: Partial<Brush>): Group =>
  hasAll(group.brush, change) ? group : { ...group, brush: { ...group.brush, ...change } };

const hasAll = (brush: Brush, change: Partial<Brush>): boolean =>
  (Object.keys(change) as (keyof Brush)[]).every((key) => change[key] === brush[key]);
