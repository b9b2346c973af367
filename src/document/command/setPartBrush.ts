import { type Brush, type Document, isBody, isSolid, type Part } from '../document.ts';
import { type BrushChange, changedBrush } from '../finish.ts';
import { type Group, withGroups } from '../solid.ts';
import { changeParts, nameOf } from './changeParts.ts';
import type { CommandKind } from './index.ts';
import { isInHand } from './recreate.ts';
import { brushWords, setBrush } from './setBrush.ts';

export interface Data {
  readonly ids: readonly string[];
  readonly change: BrushChange;
}

/** Colour, radius, finish and the rest of kept parts; the strokes stay. Bodies have a colour, and nothing else of a brush; of a solid all groups are set. */
export const setPartBrush: CommandKind<'setPartBrush', Data> = {
  type: 'setPartBrush',
  apply(document, { ids, change: { finish, ...change } }) {
    const some = set(document, ids, change);
    const next = finish ? set(some, wholeIds(document, ids), { finish }) : some;
    if (!isInHand(document, ids)) return next;
    // its strokes are seen with the brush in hand, and come back with it
    return setBrush.apply(next, { change: finish ? { ...change, finish } : change });
  },
  describe: (document, { ids, change }) =>
    `${brushWords(Object.keys(change) as (keyof Brush)[])} of ${nameOf(document, ids)}`,
};

const set = (document: Document, ids: readonly string[], change: BrushChange): Document =>
  changeParts(
    document,
    ids,
    (part) => brushed(part, change),
    (group) => groupBrushed(group, change),
  );

/** A solid has one finish: that of some of its forms is set of all. */
function wholeIds({ parts }: Document, ids: readonly string[]): readonly string[] {
  const chosen = new Set(ids);
  const has = (part: Part): boolean =>
    chosen.has(part.id) ||
    (isSolid(part) &&
      part.components.some(
        ({ id, groups }) => chosen.has(id) || groups.some((group) => chosen.has(group.id)),
      ));
  return parts.filter(has).map(({ id }) => id);
}

function brushed(part: Part, change: BrushChange): Part {
  if (isBody(part)) {
    const { colour = part.colour } = change;
    return colour === part.colour ? part : { ...part, colour };
  }
  if (isSolid(part)) return withGroups(part, (group) => [groupBrushed(group, change)]);
  const brush = changedBrush(part.brush, change);
  return brush === part.brush ? part : { ...part, brush };
}

function groupBrushed(group: Group, change: BrushChange): Group {
  const brush = changedBrush(group.brush, change);
  return brush === group.brush ? group : { ...group, brush };
}
