/** One closed stroke in hand while every stroke stays a tube: written as of version 1, it was read as a side of a round form (walk 9). */
import { expect, it } from 'vitest';
import { apply } from '../../src/document/command/index.ts';
import { readingOf } from '../../src/document/document.ts';
import { EMPTY_DRAWING } from '../../src/document/drawing.ts';
import { parse, serialize } from '../../src/document/serialize.ts';
import { PLANE, strokeAlong } from '../document/strokes.ts';

const circle = strokeAlong(
  (t) => [20 * Math.cos(6.2 * t), 15 * Math.sin(6.2 * t)],
  { closed: true, plane: PLANE },
  10,
);

it('is a silhouette after saving and loading, when strokes may be more than tubes again', () => {
  const tubes = apply(EMPTY_DRAWING.document, { type: 'setTubesOnly', on: true });
  const document = apply(tubes, { type: 'addStroke', stroke: circle });
  const read = parse(serialize({ ...EMPTY_DRAWING, document }), 'tube.rotund').document;
  expect(read).toEqual(document);
  expect(readingOf(apply(read, { type: 'setTubesOnly', on: false }))).toBe('solid');
});
