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
export const RING: readonly Command[] = [
  { type: 'setBrush', change: { radius: 5 } },
  { type: 'addStroke', stroke: circle(40), form: 'tube' },
  { type: 'keep' },
];

/** A tube without ends. */
export const PIPE: readonly Command[] = [
  { type: 'setBrush', change: { radius: 5, caps: false } },
  ...kept(line(80)),
];

/** A ring of 20 mm, its tube of 6 mm, that is no strokes. */
export const TORUS: Command = {
  type: 'addBody',
  name: 'Torus',
  node: { type: 'shape', shape: { type: 'torus', ring: 20, tube: 6 }, colour: [0.8, 0.1, 0.05] },
};

/** Two balls that blend, and a box beside them: a sum of two points, which has no hole. */
export const BLOBS: Command = {
  type: 'addBody',
  name: 'Blobs',
  node: {
    type: 'union',
    form: 'hard',
    parts: [
      {
        type: 'skels',
        kernel: 'gaussian',
        params: { s: 0.1 },
        threshold: 0.5,
        skels: [
          { skel: { type: 'point', at: [-8, 0, 0], radius: 8 }, colour: [1, 0, 0] },
          { skel: { type: 'point', at: [8, 0, 0], radius: 8 }, colour: [0, 0, 1] },
          { skel: { type: 'segment', a: [0, 0, 0], b: [0, 20, 0], radii: [3, 3] } },
        ],
      },
      { type: 'shape', shape: { type: 'box', half: [4, 30, 4] } },
    ],
  },
};

export const UNFINISHED: Command = { type: 'addStroke', stroke: halfCircle(20, 1) };

export const documentOf = (commands: readonly Command[]): Document => commands.reduce(apply, EMPTY_DOCUMENT);

export const drawingFile = (commands: readonly Command[], name = 'Drawing'): string =>
  serialize({ ...EMPTY_DRAWING, name, document: documentOf(commands) });

export const scriptFile = (commands: readonly Command[], name = 'Drawing'): string =>
  serializeScript(commands, { ...EMPTY_DRAWING, name });
