/** Select: a tap takes the part under the pen, a tap on the paper lets go. */
import type { Pen, State } from './tool.ts';

/** Pixels a tap may move. */
const STILL = 6;

export const selecting: State = {
  name: 'select.idle',
  down: (pen) => pressed(pen, pen),
  cancel: () => selecting,
};

function pressed(start: Pen, last: Pen): State {
  return {
    name: 'select.pressed',
    move: (pens) => pressed(start, pens.at(-1) ?? last),
    up(bench) {
      const moved = Math.max(Math.abs(last.x - start.x), Math.abs(last.y - start.y));
      if (moved <= STILL) tap(start, bench);
      return selecting;
    },
    cancel: () => selecting,
  };
}

function tap(pen: Pen, bench: Parameters<NonNullable<State['up']>>[0]): void {
  const hit = bench.viewport.pick(pen.x, pen.y);
  const part = bench.document.parts.find(({ id }) => id === hit?.id);
  bench.select(part ? [part.id] : []);
}
