/** What forms are made from: strokes as pens draw them, filtered. */
import { curveOfStroke } from '../../../src/document/curves.ts';
import { DEFAULT_BRUSH } from '../../../src/document/document.ts';
import type { Ink } from '../../../src/document/form/index.ts';
import { DEFAULT_SHAPE } from '../../../src/document/solid.ts';
import type { Vec2 } from '../../../src/math/vec.ts';
import { along } from '../../../src/skeleton/medial/outline.ts';
import { strokeAlong } from '../strokes.ts';

/** Closed strokes along loops, a sample a millimetre. */
export function loopInk(loops: readonly (readonly Vec2[])[], change: Partial<Ink> = {}): Ink {
  return inkOf(
    loops.map((loop) => along([loop], 1)),
    true,
    change,
  );
}

/** An open stroke through places. */
export const lineInk = (places: readonly Vec2[], change: Partial<Ink> = {}): Ink =>
  inkOf([places], false, change);

function inkOf(lines: readonly (readonly Vec2[])[], closed: boolean, change: Partial<Ink>): Ink {
  const brush = change.brush ?? DEFAULT_BRUSH;
  const curves = lines.flatMap((line) => curveOfStroke(strokeThrough(line, closed), brush) ?? []);
  return { curves, brush, shape: DEFAULT_SHAPE, skeleton: null, isRough: false, ...change };
}

const strokeThrough = (line: readonly Vec2[], closed: boolean) =>
  strokeAlong((t) => line[Math.round(t * (line.length - 1))]!, { closed }, line.length);
