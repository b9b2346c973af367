/** A tap on a step of the meter is one undo step, pinned or not. */
import { expect, test } from 'vitest';
import { readingOf } from '../../src/document/document.ts';
import { EMPTY_DRAWING } from '../../src/document/drawing.ts';
import { stateOf, takeStep } from '../../src/element/meter.ts';
import { Session } from '../../src/element/session.ts';
import { strokeAlong } from '../document/strokes.ts';

const side = (x: number) => strokeAlong((t) => [x + 10 * Math.sin(3 * t), 60 * t - 30]);

function session(): Session {
  const session = new Session({ changed() {}, drawn() {}, committed() {}, selected() {}, moded() {} });
  session.frames.asleep = true;
  session.open(EMPTY_DRAWING, { fresh: true });
  for (const x of [-20, 20]) session.commit([{ type: 'addStroke', stroke: side(x) }]);
  const drawn = { stroke: strokeAlong((t) => [40 * t - 20, 8 * Math.sin(Math.PI * t)]), half: null };
  session.commit([{ type: 'addSection', u: 0.5, drawn }]);
  return session;
}

test('tubes that were pinned become round, or what all strokes make, in one step that undo takes back', () => {
  for (const [step, pinFirst] of [
    ['rotational', true],
    ['crossSection', true],
    ['rotational', false],
  ] as const) {
    const hand = session();
    if (!pinFirst) hand.run({ type: 'setForm', form: 'tube' });
    hand.run({ type: 'setTubesOnly', on: true });
    expect(readingOf(hand.document)).toBe('tube');
    const before = hand.document;
    const steps = hand.history.past.length;
    takeStep(hand, step);
    expect(readingOf(hand.document)).toBe(step);
    expect(hand.document.tubesOnly).toBe(false);
    expect(hand.history.past.length).toBe(steps + 1);
    hand.undo();
    expect(hand.document).toBe(before);
  }
});

test('the pin is let go by its own step, and a step that is missing strokes opens the tool for them', () => {
  const hand = session();
  hand.run({ type: 'setTubesOnly', on: true });
  takeStep(hand, 'tube');
  expect(hand.document.tubesOnly).toBe(false);
  takeStep(hand, 'bspline');
  expect(hand.tool).toBe('section');
});

test('a tube with sections is not round between two sides: that step is still to come, and its tap draws', () => {
  const hand = session();
  hand.run({ type: 'setStroke', index: 1, stroke: null });
  expect(readingOf(hand.document)).toBe('crossSection');
  const rotational = () => stateOf(hand.document, 'rotational');
  expect(rotational()).toBe('next');
  hand.setTool('section');
  const before = hand.document;
  takeStep(hand, 'rotational');
  expect(hand.document).toBe(before);
  expect(hand.tool).toBe('draw');
  hand.undo();
  expect(rotational()).toBe('done');
});
