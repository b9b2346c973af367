/** What a session does without a picture. */
import { describe, expect, it } from 'vitest';
import { DEFAULT_BRUSH, type Document, EMPTY_DOCUMENT } from '../../src/document/document.ts';
import { EMPTY_DRAWING } from '../../src/document/drawing.ts';
import { LIMITS } from '../../src/document/limits.ts';
import { parse, serialize } from '../../src/document/serialize.ts';
import { Session } from '../../src/element/session.ts';
import { WORDS } from '../../src/element/words.ts';
import { UNMOVED } from '../../src/math/placement.ts';
import { strokeAlong } from '../document/strokes.ts';

const STROKE = strokeAlong((t) => [30 * t, 10 * t], {}, 2);

function sessionWith(document: Document): Session {
  const session = new Session({ changed() {}, drawn() {}, committed() {}, selected() {}, moded() {} });
  session.frames.asleep = true;
  session.open({ ...EMPTY_DRAWING, document }, { fresh: true });
  return session;
}

function tubes(count: number): Document {
  const part = {
    kind: 'tube',
    strokes: [STROKE],
    brush: DEFAULT_BRUSH,
    placement: UNMOVED,
    hidden: false,
  } as const;
  const parts = Array.from({ length: count }, (_, i) => ({
    ...part,
    id: `part-${i + 1}`,
    name: `Tube ${i + 1}`,
  }));
  return { ...EMPTY_DOCUMENT, parts, nextId: count + 1 };
}

describe('a drawing that is full', () => {
  it('takes the last stroke a file can hold, and says so at the next', () => {
    const session = sessionWith(tubes(LIMITS.strokes - 1));
    session.commit([{ type: 'addStroke', stroke: STROKE }]);
    expect(session.document.draft?.strokes).toHaveLength(1);
    const full = session.document;
    session.commit([{ type: 'keep' }, { type: 'addStroke', stroke: STROKE }]);
    expect(session.document).toBe(full);
    expect(session.said).toBe(WORDS.full);
    expect(session.notice?.text).toBe(WORDS.full);
    expect(parse(serialize(session.drawing), 'full.rotund').document).toEqual(full);
  });

  it('still takes what makes it no larger', () => {
    const session = sessionWith(tubes(LIMITS.strokes));
    session.commit([{ type: 'removeParts', ids: ['part-1'] }]);
    expect(session.document.parts).toHaveLength(LIMITS.strokes - 1);
    expect(session.notice).toBeNull();
  });
});

describe('a radius slider', () => {
  it('shows what it would do, and is one undo step when it is let go', () => {
    const session = sessionWith(EMPTY_DOCUMENT);
    session.holdSlider();
    session.setRadius(7, false);
    session.setRadius(9, false);
    expect(session.radius).toBe(9);
    expect(session.document.brush.radius).toBe(DEFAULT_BRUSH.radius);
    session.setRadius(12, true);
    expect(session.document.brush.radius).toBe(12);
    session.undo();
    expect(session.radius).toBe(DEFAULT_BRUSH.radius);
  });

  it('is put back by Escape, and ignored until it is taken hold of again', () => {
    const session = sessionWith(EMPTY_DOCUMENT);
    session.holdSlider();
    session.setRadius(9, false);
    expect(session.cancel()).toBe(true);
    session.setRadius(11, false);
    session.setRadius(11, true);
    expect(session.radius).toBe(DEFAULT_BRUSH.radius);
    session.holdSlider();
    session.setRadius(11, true);
    expect(session.radius).toBe(11);
  });
});
