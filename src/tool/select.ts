/**
 * Select: a tap takes the part under the pen, a further one the group of a solid there, a tap on the paper lets go, a drag over the paper takes what its
 * rectangle takes in, and a drag from a part moves it at once. Shift or Ctrl adds and takes away. The unfinished form
 * is no part yet: it cannot be selected, and a tap on it changes nothing.
 */
import { groupAt, groupsIn, partsWith } from '../document/chosen.ts';
import { isSolid } from '../document/document.ts';
import { seenParts } from '../document/extent.ts';
import { partsIn } from './band.ts';
import { pickBeside } from './beside.ts';
import { carry } from './move.ts';
import type { Bench, Pen, State } from './tool.ts';
import type { Hit } from './viewport.ts';

/** Pixels a tap may move. */
const STILL = 6;
/** Pixels around the pen in which a thin part is found, too. */
const REACH = { touch: 12, pen: 4, mouse: 4 } as const;
/** ms between the two taps of a double tap */
const DOUBLE = 400;

interface Tap {
  readonly id: string;
  readonly time: number;
}

interface Press {
  readonly start: Pen;
  readonly last: Pen;
  /** null: on the paper */
  readonly hit: Hit | null;
  /** the tap before this one */
  readonly before: Tap | null;
}

export const selecting: State = waiting(null);

function waiting(before: Tap | null): State {
  const state: State = {
    name: 'select.idle',
    down: (pen, { viewport }) =>
      pressed({ start: pen, last: pen, hit: pickBeside(pen, viewport, [REACH[pen.pointer]]), before }),
    // Nothing is under way: cancelling it is no deed.
    cancel: () => state,
  };
  return state;
}

function pressed(press: Press): State {
  return {
    name: 'select.pressed',
    still: true,
    move(pens, bench) {
      const last = pens.at(-1) ?? press.last;
      const { x, y } = press.start;
      if (Math.max(Math.abs(last.x - x), Math.abs(last.y - y)) <= STILL) return pressed({ ...press, last });
      return dragged(press, pens, bench);
    },
    up: (bench) => tap(press, bench),
    cancel: () => selecting,
  };
}

function dragged({ start, hit }: Press, pens: readonly Pen[], bench: Bench): State | undefined {
  const id = partOf(hit, bench);
  if (!hit || id === null) return banding(start, pens.at(-1) ?? start);
  const isHeld = partsWith(bench.document, bench.selection).some((part) => part.id === id);
  if (!isHeld) choose(start.adds ? [...bench.selection, id] : [id], bench);
  const ids = seenParts(bench.document, bench.selection).map((part) => part.id);
  return carry('view', ids, hit.point, start, bench, selecting).move?.(pens, bench);
}

function banding(from: Pen, to: Pen): State {
  return {
    name: 'select.banding',
    still: true,
    band: { from, to },
    move: (pens) => banding(from, pens.at(-1) ?? to),
    up(bench) {
      const found = partsIn({ from, to }, bench.document, bench.viewport);
      choose(from.adds ? [...bench.selection, ...found] : found, bench);
      return selecting;
    },
    cancel: () => selecting,
  };
}

function tap({ start, hit, before }: Press, bench: Bench): State {
  const id = partOf(hit, bench);
  if (id === null) {
    if (!hit && !start.adds) choose([], bench);
    return selecting;
  }
  if (start.adds) {
    const { selection } = bench;
    choose(selection.includes(id) ? selection.filter((other) => other !== id) : [...selection, id], bench);
    return selecting;
  }
  if (before?.id === id && start.time - before.time < DOUBLE) {
    bench.focus([id]);
    return selecting;
  }
  choose([within(id, hit, bench) ?? id], bench);
  return waiting({ id, time: start.time });
}

/** The group under the pen of a solid that is selected, or that a group is selected of; null: there is none, or no other one. */
function within(id: string, hit: Hit | null, { document, selection }: Bench): string | null {
  const part = document.parts.find((other) => other.id === id);
  if (!part || !isSolid(part) || !hit?.skel || groupsIn(part).length < 2) return null;
  const [only, ...others] = selection;
  const isIn = only === id || groupsIn(part).some(({ group }) => group.id === only);
  return isIn && others.length === 0 ? (groupAt(part, hit.skel.path)?.id ?? null) : null;
}

function choose(ids: readonly string[], bench: Bench): void {
  bench.select(ids);
  bench.notify('selected');
}

const partOf = (hit: Hit | null, { document }: Bench): string | null =>
  document.parts.find(({ id }) => id === hit?.id)?.id ?? null;
