/** A stroke in hand is lit while its number is pointed at, and until the strokes change. */
import { expect, it } from 'vitest';
import { EMPTY_DRAWING } from '../../src/document/drawing.ts';
import { Session } from '../../src/element/session.ts';
import { lightStroke, litStroke } from '../../src/element/strokeLight.ts';
import { strokeAlong } from '../document/strokes.ts';

function session(): Session {
  const session = new Session({ changed() {}, drawn() {}, committed() {}, selected() {}, moded() {} });
  session.frames.asleep = true;
  session.size = { width: 800, height: 600 };
  session.open(EMPTY_DRAWING, { fresh: true });
  const line = (x: number) => strokeAlong((t) => [x, 60 * t - 30]);
  session.commit([
    { type: 'addStroke', stroke: line(-20) },
    { type: 'addStroke', stroke: line(20) },
  ]);
  return session;
}

it('is lit by its number, and put out', () => {
  const hand = session();
  expect(litStroke(hand)).toBeNull();
  lightStroke(hand, 2);
  expect(litStroke(hand)).toBe(2);
  lightStroke(hand, 1);
  expect(litStroke(hand)).toBe(1);
  lightStroke(hand, null);
  expect(litStroke(hand)).toBeNull();
});

it('goes out when a stroke goes: others have its number then', () => {
  const hand = session();
  lightStroke(hand, 2);
  hand.run({ type: 'setStroke', index: 0, stroke: null });
  expect(litStroke(hand)).toBeNull();
});
