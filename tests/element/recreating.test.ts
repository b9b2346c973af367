/** How strokes are taken in hand again. */
import { expect, test } from 'vitest';
import { EMPTY_DRAWING } from '../../src/document/drawing.ts';
import { recreatePart } from '../../src/element/recreating.ts';
import { Session } from '../../src/element/session.ts';
import { WORDS } from '../../src/element/words.ts';
import { strokeAlong } from '../document/strokes.ts';

const line = (x: number) => strokeAlong((t) => [x, 60 * t - 30]);

function sessionWithTube(): Session {
  const session = new Session({ changed() {}, drawn() {}, committed() {}, selected() {}, moded() {} });
  session.frames.asleep = true;
  session.open(EMPTY_DRAWING, { fresh: true });
  session.commit([{ type: 'addStroke', stroke: line(0) }, { type: 'keep' }]);
  session.setTool('select');
  return session;
}

test('the pen draws on at once', () => {
  const session = sessionWithTube();
  recreatePart(session, 'part-1');
  expect(session.document.draft?.recreates?.part).toBe('part-1');
  expect(session.tool).toBe('draw');
});

test('a form that nobody could see is not kept for it', () => {
  const session = sessionWithTube();
  for (let i = 0; i < 2; i++) session.commit([{ type: 'addStroke', stroke: line(40) }]);
  const before = session.document;
  recreatePart(session, 'part-1');
  expect(session.document).toBe(before);
  expect(session.said).toBe(WORDS.cannotKeep);
  expect(session.tool).toBe('select');
});
