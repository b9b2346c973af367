/** Models for exporters: documents as people make them, and parts made to be difficult. */
import { apply, type Command } from '../../src/document/command/index.ts';
import { type Document, EMPTY_DOCUMENT } from '../../src/document/document.ts';
import { DEFAULT_FINISH } from '../../src/document/finish.ts';
import { type Model, modelOf } from '../../src/export/index.ts';
import type { Mesh } from '../../src/mesh/mesh.ts';
import type { Stroke } from '../../src/stroke/stroke.ts';
import { halfCircle, line } from '../document/strokes.ts';
import { box } from '../mesh/solids.ts';

const kept = (strokes: readonly Stroke[], colour: string): Command[] => [
  { type: 'setBrush', change: { colour, radius: 5 } },
  ...strokes.map((stroke): Command => ({ type: 'addStroke', stroke })),
  { type: 'keep' },
];

/** A ball of radius 50, a tube beside it, another ball drawn but not kept. */
export const BALL_AND_TUBE: Document = [
  ...kept([halfCircle(50, -1), halfCircle(50, 1)], '#c83c28'),
  ...kept([line(80)], '#2b59c3'),
  // turned by 120° about the diagonal, and moved
  { type: 'moveParts', ids: ['part-2'], by: { rotation: [0.5, 0.5, 0.5, 0.5], translation: [70, 0, 0] } },
  { type: 'addStroke', stroke: halfCircle(20, 1) } as Command,
].reduce<Document>((document, command) => apply(document, command as Command), EMPTY_DOCUMENT);

export const ballAndTube = (): Model => modelOf(BALL_AND_TUBE, 'ball and tube');

export const solidOf = (name: string, mesh: Mesh = box(1, 2, 3), colour = '#808080', id = name) => ({
  id,
  name,
  kind: 'tube' as const,
  colour,
  finish: DEFAULT_FINISH,
  mesh,
});

/** Boxes with these names, side by side. */
export const namedBoxes = (names: readonly string[]): Model => ({
  name: 'boxes',
  solids: names.map((name, i) => solidOf(name, box(1, 2, 3, [5 * i, 0, 0]), '#808080', `box-${i}`)),
});

/** Colours of the painted box, light, by vertex. */
export const PAINT: readonly (readonly number[])[] = [
  [1, 0, 0],
  [0, 0.5, 0.002],
  [0.25, 1, 0.75],
];

/** A box of one colour and a box painted by vertex, as bodies are. */
export function painted(): Model {
  const mesh = box(1, 2, 3, [9, 0, 0]);
  const count = mesh.positions.length / 3;
  const colours = new Float32Array(Array.from({ length: count }, (_, i) => PAINT[i % 3]!).flat());
  return { name: 'painted', solids: [solidOf('plain'), solidOf('painted', { ...mesh, colours }, '#123456')] };
}

export const EMPTY: Model = { name: 'nothing', solids: [] };
