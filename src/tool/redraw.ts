/**
 * Redraw (thesis 6.2): what is drawn takes the place of the part of a cross section, or of a construction curve in the view it was drawn
 * in, that it was drawn over. What would be drawn over is lit while the pen hovers, and from the first contact on.
 */
import { apply, type Command } from '../document/command/index.ts';
import { FRONT_VIEW } from '../document/drawing.ts';
import { ontoSection } from '../document/sectionLoops.ts';
import { distance2 } from '../math/tuple.ts';
import { splice } from '../stroke/splice.ts';
import type { Mark } from './marks.ts';
import { previewed } from './previewed.ts';
import { type EdgeOn, type Lit, litAt, type NotLit } from './redrawTarget.ts';
import { tipped } from './sideView.ts';
import type { Bench, Pen, State } from './tool.ts';
import { isClosing, strokeOf, type Trace, traced, traceFrom } from './trace.ts';

/** How far a redrawn section reaches: over the whole form, or it fades to what was there. */
export interface Redrawing {
  readonly local: boolean;
  /** what is lit */
  readonly over: 'section' | 'side' | null;
}

/** Where the pen hovers. */
interface Over {
  readonly lit: Lit;
  readonly pen: Pen;
}

/** px that the pen may land from where it hovered: what was lit there is what is drawn over */
const LANDS = 24;

export const redrawing = (local: boolean, over: Over | null = null, isEdgeOn = false): State => {
  const lit = over?.lit ?? null;
  const state: State = {
    name: lit ? 'redraw.lit' : 'redraw.idle',
    waits: true,
    redrawing: { local, over: lit?.kind ?? null },
    ...(lit && { marks: marksOf(lit) }),
    hover(pen, bench) {
      const found = pen && litAt(pen, bench, local);
      if (pen && isLit(found)) return redrawing(local, { lit: found, pen });
      const edge = isLit(found) || typeof found === 'string' ? null : found;
      // said once, not at every move
      if (edge && !isEdgeOn) sayEdgeOn(edge, bench);
      return lit || (edge !== null) !== isEdgeOn ? redrawing(local, null, edge !== null) : undefined;
    },
    down(pen, bench) {
      const isThere = over && distance2([pen.x, pen.y], [over.pen.x, over.pen.y]) <= LANDS;
      const found = isThere ? over.lit : litAt(pen, bench, local);
      return begun(found, pen, bench, local, (on) => redrawing(local, on && { lit: on, pen }));
    },
    // Nothing is under way: cancelling it is no deed.
    cancel: () => state,
  };
  return state;
};

const isLit = (found: Lit | NotLit | null): found is Lit =>
  found !== null && typeof found === 'object' && found.kind !== 'edge-on';

const sayEdgeOn = ({ plane }: EdgeOn, bench: Bench): void =>
  bench.notify('section-edge-on', [], tipped(plane, bench.viewport.view));

/** With the other end of a pen: one stroke, and back to the tool in hand. */
export const redrawOnce = (back: State): State => ({
  name: 'redraw.once',
  still: true,
  down: (pen, bench) => begun(litAt(pen, bench, false), pen, bench, false, () => back) ?? back,
  cancel: () => back,
});

function begun(
  found: Lit | NotLit,
  pen: Pen,
  bench: Bench,
  local: boolean,
  back: (lit: Lit | null) => State,
): State | undefined {
  if (typeof found === 'string') bench.notify(found);
  else if (found.kind === 'edge-on') sayEdgeOn(found, bench);
  else return drawing({ lit: found, local, back, trace: traceFrom(pen, bench.viewport.view) });
  return undefined;
}

interface Drawn {
  readonly lit: Lit;
  readonly local: boolean;
  readonly trace: Trace;
  back(lit: Lit | null): State;
}

function drawing(drawn: Drawn): State {
  const { lit, local, trace } = drawn;
  return {
    name: 'redraw.drawing',
    redrawing: { local, over: lit.kind },
    wet: { pens: trace.pens, on: null, closing: isLoop(lit, trace) },
    marks: marksOf(lit),
    preview: previewed((bench) => {
      const command = commandOf(drawn, bench);
      return command && apply(bench.document, command);
    }),
    move: (pens) => drawing({ ...drawn, trace: traced(trace, pens) }),
    up(bench) {
      const command = commandOf(drawn, bench);
      if (command) bench.commit([command]);
      else bench.notify('too-short');
      return drawn.back(null);
    },
    cancel: () => drawn.back(lit),
  };
}

/** All round, where it is closed itself. */
const isLoop = (lit: Lit, trace: Trace): boolean => lit.closed && isClosing(trace);

function commandOf({ lit, local, trace }: Drawn, { viewport }: Bench): Command | null {
  const stroke = strokeOf(lit.plane, trace, viewport.size, isLoop(lit, trace));
  if (!stroke) return null;
  if (lit.kind === 'side') {
    const over = { ...stroke, plane: lit.old.plane };
    const grain = stroke.view.height / FRONT_VIEW.height;
    const next = splice(lit.old, over, grain);
    return next === lit.old ? null : { type: 'setStroke', ...lit.whose, index: lit.index, stroke: next };
  }
  const { u, half } = lit.loop;
  const drawn = { stroke: ontoSection(stroke, lit.loop), half };
  return { type: 'redrawSection', ...lit.whose, u, drawn, ...(local && { local: true as const }) };
}

function marksOf(lit: Lit): readonly Mark[] {
  return [
    {
      kind: 'line',
      style: 'lit',
      points: lit.points,
      ...(lit.kind === 'section' && lit.closed && { closed: true as const }),
    },
  ];
}
