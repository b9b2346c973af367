/** Crossings of outlines, where they are, of solids only. */
import { expect, it } from 'vitest';
import { apply } from '../../src/document/command/index.ts';
import { draftCrossings } from '../../src/document/crossings.ts';
import { EMPTY_DOCUMENT } from '../../src/document/document.ts';
import { strokeAlong } from './strokes.ts';

const loop = (at: (angle: number) => [number, number]) =>
  strokeAlong((t) => at(2 * Math.PI * t), { closed: true });
/** Crosses itself in (0, 0), which is neither its start nor its end. */
const EIGHT = loop((a) => [40 * Math.sin(a + 0.5), 25 * Math.sin(2 * a + 1)]);
const RING = loop((a) => [30 * Math.cos(a), 20 * Math.sin(a)]);

const drawn = (...strokes: readonly ReturnType<typeof loop>[]) =>
  strokes.reduce((document, stroke) => apply(document, { type: 'addStroke', stroke }), EMPTY_DOCUMENT);

it('finds where an outline crosses itself, in space', () => {
  const [at, ...others] = draftCrossings(drawn(EIGHT));
  expect(others).toEqual([]);
  expect(Math.hypot(...at!)).toBeLessThan(0.5);
  expect(draftCrossings(drawn(RING))).toEqual([]);
});

it('is of no matter for tubes and rings', () => {
  for (const form of ['tube', 'ring'] as const)
    expect(draftCrossings(apply(drawn(EIGHT), { type: 'setForm', form }))).toEqual([]);
  expect(draftCrossings(apply(drawn(EIGHT), { type: 'setForm', form: 'plate' }))).toHaveLength(1);
});
