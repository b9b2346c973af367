/** What an edit made anew, for the device that has the bricks before it (liveLists.ts). */
import { hasCreases } from '../../field/bricks.ts';
import type { LiveStep } from '../../field/liveField.ts';
import type { FieldNode } from '../../field/node.ts';
import type { PackedEdit } from '../../field/packedBricks.ts';
import { programOf } from '../program.ts';
import { packLists } from './lists.ts';

/** Of an edit in place, to that tree. */
export function packEdit(
  node: FieldNode,
  { bricks, numbers, renewed }: Pick<LiveStep, 'bricks' | 'numbers' | 'renewed'>,
): PackedEdit {
  const places = numbers.flatMap((number, place) => (renewed.has(number) ? [place] : []));
  const lists = packLists(
    programOf(node),
    places.map((place) => bricks.active[place]!),
  );
  return {
    grid: bricks.grid,
    hasCreases: hasCreases(bricks.active),
    renewed: Uint32Array.from(places),
    lists,
  };
}
