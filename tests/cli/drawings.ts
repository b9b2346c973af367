/** Drawings as files: solids whose measures are known without the program. */
import { apply, type Command } from '../../src/document/command/index.ts';
import { type Document, EMPTY_DOCUMENT } from '../../src/document/document.ts';
import { EMPTY_DRAWING } from '../../src/document/drawing.ts';
import { serialize, serializeScript } from '../../src/document/serialize.ts';
import type { Stroke } from '../../src/stroke/stroke.ts';
import { circle, halfCircle, line } from '../document/strokes.ts';

export const kept = (...strokes: readonly Stroke[]): Command[] => [
  ...strokes.map((stroke): Command => ({ type: 'addStroke', stroke })),
  { type: 'keep' },
];

/** A ball of radius 50 mm. */
export const BALL: readonly Command[] = kept(halfCircle(50, -1), halfCircle(50, 1));

/** A ring: radius 40 mm, of a tube of 5 mm. */
export const RING: readonly Command[] = [{ type: 'setBrush', change: { radius: 5 } }, ...kept(circle(40))];

/** A tube without ends. */
export const PIPE: readonly Command[] = [
  { type: 'setBrush', change: { radius: 5, caps: false } },
  ...kept(line(80)),
];

export const UNFINISHED: Command = { type: 'addStroke', stroke: halfCircle(20, 1) };

export const documentOf = (commands: readonly Command[]): Document => commands.reduce(apply, EMPTY_DOCUMENT);

export const drawingFile = (commands: readonly Command[], name = 'Drawing'): string =>
  serialize({ ...EMPTY_DRAWING, name, document: documentOf(commands) });

export const scriptFile = (commands: readonly Command[], name = 'Drawing'): string =>
  serializeScript(commands, { ...EMPTY_DRAWING, name });
