/** How the Bend tool is taken up. */
import { expect, test } from 'vitest';
import { EMPTY_DRAWING } from '../../src/document/drawing.ts';
import { startBend } from '../../src/element/bending.ts';
import { Session } from '../../src/element/session.ts';
import { strokeAlong } from '../document/strokes.ts';

const line = (x: number) => strokeAlong((t) => [x, 60 * t - 30]);

test('strokes in hand go back to their part, and that is bent, whatever was made after it', () => {
  const session = new Session({ changed() {}, drawn() {}, committed() {}, selected() {}, moded() {} });
  session.frames.asleep = true;
  session.open(EMPTY_DRAWING, { fresh: true });
  for (const x of [0, 40]) session.commit([{ type: 'addStroke', stroke: line(x) }, { type: 'keep' }]);
  session.commit([{ type: 'recreate', id: 'part-1' }]);
  startBend(session);
  expect(session.document.draft).toBeNull();
  expect(session.selection).toEqual(['part-1']);
  expect(session.state.bending?.id).toBe('part-1');
});

test('where there is nothing to bend words say so, and the pen draws on', () => {
  const session = new Session({ changed() {}, drawn() {}, committed() {}, selected() {}, moded() {} });
  session.frames.asleep = true;
  session.open(EMPTY_DRAWING, { fresh: true });
  startBend(session);
  expect(session.tool).toBe('draw');
  expect(session.said).toContain('draw a form first');
});
