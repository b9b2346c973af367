/** What a session does without a picture. */

import { describe, expect, it, vi } from 'vitest';
import { DEFAULT_BRUSH, type Document, EMPTY_DOCUMENT } from '../../src/document/document.ts';
import { EMPTY_DRAWING } from '../../src/document/drawing.ts';
import { LIMITS } from '../../src/document/limits.ts';
import { parse, serialize } from '../../src/document/serialize.ts';
import { PLAIN } from '../../src/document/surfacePart.ts';
import { Session } from '../../src/element/session.ts';
import { TIMINGS } from '../../src/element/timing.ts';
import { WORDS } from '../../src/element/words.ts';
import { UNMOVED } from '../../src/math/placement.ts';
import type { State } from '../../src/tool/tool.ts';
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
    ...PLAIN,
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

describe('an outline that crosses itself', () => {
  const EIGHT = strokeAlong((t) => [40 * Math.sin(6.28 * t + 0.5), 25 * Math.sin(12.56 * t + 1)], {
    closed: true,
  });

  it('is told of and marked; either way on leaves the strokes, or takes back only this one', () => {
    const session = sessionWith(EMPTY_DOCUMENT);
    session.commit([{ type: 'addStroke', stroke: EIGHT }]);
    expect(session.notice).toMatchObject({ text: 'The outline crosses itself.', passing: true });
    expect(session.notice!.marks).toHaveLength(1);
    const [redraw, join] = session.notice!.actions;
    join!.run();
    expect(session.document.draft!.strokes).toHaveLength(1);
    redraw!.run();
    expect(session.document.draft).toBeNull();
  });

  it('is not as a tube', () => {
    const session = sessionWith({ ...EMPTY_DOCUMENT, tubesOnly: true });
    session.commit([{ type: 'addStroke', stroke: EIGHT }]);
    expect(session.notice).toBeNull();
  });
});

describe('a solid', () => {
  const RING = strokeAlong((t) => [30 * Math.cos(6.2 * t), 30 * Math.sin(6.2 * t)], { closed: true });

  it('leaves in the timeline of the page when it was there coarsely and finely', async () => {
    performance.clearMeasures();
    const session = sessionWith(EMPTY_DOCUMENT);
    session.commit([{ type: 'addStroke', stroke: RING }]);
    await session.bodies.settled();
    const times = Object.values(TIMINGS).map((name) => performance.getEntriesByName(name));
    expect(times.map(({ length }) => length)).toEqual([1, 1]);
    expect(times[0]![0]!.duration).toBeLessThanOrEqual(times[1]![0]!.duration);
  });

  it('is rough while a slider moves, and only then', () => {
    const session = sessionWith(EMPTY_DOCUMENT);
    session.commit([{ type: 'addStroke', stroke: RING, form: 'plate' }]);
    session.holdSlider();
    session.setRadius(12, false);
    expect(session.shown().draft!.isRough).toBe(true);
    expect(session.shown()).toBe(session.shown());
    expect(session.shown().brush.radius).toBe(12);
    session.setRadius(12, true);
    expect(session.shown()).toBe(session.document);
    expect(session.document.draft!.isRough).toBeUndefined();
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

describe('a section guide that a finger left', () => {
  it('goes when the sides go', () => {
    const session = sessionWith(EMPTY_DOCUMENT);
    session.size = { width: 800, height: 600 };
    const side = (x: number) => strokeAlong((t) => [x, 60 * t - 30]);
    for (const x of [-30, 30]) session.commit([{ type: 'addStroke', stroke: side(x) }]);
    session.setTool('section');
    const finger = { x: 310, y: 300, pressure: 0.5, tiltX: 0, tiltY: 0, time: 0, pointer: 'touch' } as const;
    session.down(finger);
    session.up();
    expect(session.state.guide?.u).toBeCloseTo(0.5, 1);
    session.undo();
    expect(session.document.draft!.strokes).toHaveLength(1);
    expect(session.state.guide).toBeUndefined();
    expect(session.state.marks).toBeUndefined();
  });
});

describe('what the pen would do', () => {
  it('is spoken once when it rests, not at every place it passes, and is over when it leaves', () => {
    vi.useFakeTimers();
    try {
      const session = sessionWith(EMPTY_DOCUMENT);
      const at = (u: number): State => ({ name: 'x', guide: { u, side: 'front' }, cancel: () => at(u) });
      const spoken: string[] = [];
      for (const u of [0.1, 0.2, 0.3]) {
        session.begin(at(u));
        vi.advanceTimersByTime(100);
        spoken.push(session.hintAtRest);
      }
      expect(spoken).toEqual(['', '', '']);
      vi.advanceTimersByTime(2000);
      expect(session.hintAtRest).toBe(session.hint);
      expect(session.hintAtRest).toContain('30 %');
      session.begin(session.idle);
      expect(session.hintAtRest).toBe('');
    } finally {
      vi.useRealTimers();
    }
  });

  it('is over when the tool is laid down, and the form no longer steps back', () => {
    vi.useFakeTimers();
    try {
      const session = sessionWith(EMPTY_DOCUMENT);
      const faint = vi.fn();
      session.scene = { setFaint: faint } as unknown as Session['scene'];
      const shown: State = { name: 'x', guide: { u: 0.1, side: 'front' }, faint: true, cancel: () => shown };
      session.begin(shown);
      session.setTool('select');
      expect(session.hint).toBe('');
      vi.advanceTimersByTime(2000);
      expect(session.hintAtRest).toBe('');
      expect(faint.mock.lastCall).toEqual([false]);
    } finally {
      vi.useRealTimers();
    }
  });
});

describe('the notice to turn the view', () => {
  it('goes when a section is lit, and no other does', () => {
    const session = sessionWith(tubes(1));
    const lit: State = {
      name: 'redraw.lit',
      redrawing: { local: false, over: 'section' },
      cancel: () => lit,
    };
    const unlit: State = {
      name: 'redraw.idle',
      redrawing: { local: false, over: null },
      cancel: () => unlit,
    };
    session.notify('section-edge-on', [], STROKE.view);
    session.begin(unlit);
    const side: State = { ...lit, redrawing: { local: false, over: 'side' }, cancel: () => side };
    session.begin(side);
    expect(session.notice?.actions.map(({ label }) => label)).toEqual([WORDS.turn]);
    session.begin(lit);
    expect(session.notice).toBeNull();
    session.notify('edge-on');
    session.begin(lit);
    expect(session.notice?.text).toBe(WORDS.edgeOn);
  });
});
