import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { apply, type Command } from '../../src/document/command/index.ts';
import { colourOf, EMPTY_DOCUMENT, readingOf } from '../../src/document/document.ts';
import { commit, newHistory, redo, redoable, undo, undoable } from '../../src/document/history.ts';
import { circle, halfCircle, line } from './strokes.ts';

const add = (stroke = line(-10)): Command => ({ type: 'addStroke', stroke });
const KEEP: Command = { type: 'keep' };

describe('commands', () => {
  it('reads the number of strokes: one a tube, two rotational, or tubes when they shall stay tubes', () => {
    const one = apply(EMPTY_DOCUMENT, add());
    const two = apply(one, add(line(10)));
    expect(readingOf(EMPTY_DOCUMENT)).toBeNull();
    expect(readingOf(one)).toBe('tube');
    expect(readingOf(two)).toBe('rotational');
    expect(readingOf(apply(two, { type: 'setTubesOnly', on: true }))).toBe('tube');
  });

  it('keeps two strokes as one part, or as two while every stroke stays a tube', () => {
    const two = [add(), add(line(10))].reduce(apply, EMPTY_DOCUMENT);
    expect(apply(two, KEEP).parts).toHaveLength(1);
    const tubes = apply(apply(two, { type: 'setTubesOnly', on: true }), KEEP);
    expect(tubes.parts.map(({ kind }) => kind)).toEqual(['tube', 'tube']);
    expect(new Set(tubes.parts.map(({ id }) => id)).size).toBe(2);
    expect(tubes.draft).toBeNull();
  });

  it('gives a part its own brush: the next colour does not repaint it', () => {
    const kept = [add(), KEEP].reduce(apply, EMPTY_DOCUMENT);
    const repainted = apply(kept, { type: 'setBrush', change: { colour: '#7d5238' } });
    expect(colourOf(repainted.parts[0]!)).toBe(EMPTY_DOCUMENT.brush.colour);
    expect(repainted.brush.colour).toBe('#7d5238');
  });

  it('shares what it does not touch', () => {
    const kept = [add(), KEEP, add(circle(20)), KEEP].reduce(apply, EMPTY_DOCUMENT);
    expect(apply(kept, { type: 'removeLast' }).parts[0]).toBe(kept.parts[0]);
  });
});

describe('history', () => {
  it('makes one step of one form after the other, in words of the last; going back to the first makes none', () => {
    const two = [add(), add(line(10))].reduce(commit, newHistory());
    const forms = [
      { type: 'setForm', form: 'tube' },
      { type: 'setForm', form: 'rotational' },
    ] as const;
    const both = forms.reduce(commit, two);
    expect(undo(both).present).toBe(two.present);
    expect(undoable(both)).toBe('rotational from the strokes');
    const back = commit(commit(two, forms[0]), { type: 'setForm', form: null });
    expect(back.past).toHaveLength(2);
    expect(back.present).toBe(two.present);
    expect(undoable(commit(commit(two, forms[0]), { type: 'setForm', carves: true }))).toBe('carving');
  });

  it('does not melt choices between which something else was done', () => {
    const two = [add(), add(line(10)), { type: 'setForm', form: 'tube' } as const].reduce(
      commit,
      newHistory(),
    );
    const later = commit(two, { type: 'setBrush', change: { radius: 9 } });
    const again = commit(later, { type: 'setForm', form: null });
    expect(undo(again).present).toBe(later.present);
    expect(undoable(again)).toBe('rotational from the strokes');
  });

  it('makes no step of a command that changes nothing', () => {
    const start = newHistory();
    for (const command of [
      KEEP,
      { type: 'drop' },
      { type: 'removeLast' },
      { type: 'removeAll' },
    ] as Command[])
      expect(commit(start, command)).toBe(start);
    expect(commit(start, { type: 'setBrush', change: { radius: EMPTY_DOCUMENT.brush.radius } })).toBe(start);
  });

  it('says what it would take back', () => {
    const history = [add(), { type: 'setBrush', change: { colour: '#123456' } } as Command].reduce(
      commit,
      newHistory(),
    );
    expect(undoable(history)).toBe('colour');
    expect(redoable(undo(history))).toBe('colour');
    expect(undoable(undo(history))).toBe('stroke 1');
    expect(undoable(undo(undo(history)))).toBeNull();
  });

  it('forgets the future when something new is done', () => {
    const history = commit(undo(commit(newHistory(), add())), { type: 'setTubesOnly', on: true });
    expect(redoable(history)).toBeNull();
  });

  const command: fc.Arbitrary<Command> = fc.oneof(
    fc.constantFrom(add(), add(line(12)), add(halfCircle(20, 1)), add(circle(15))),
    fc.constantFrom<Command>(KEEP, { type: 'drop' }, { type: 'removeLast' }, { type: 'removeAll' }),
    fc.boolean().map((on): Command => ({ type: 'setTubesOnly', on })),
    fc.integer({ min: 1, max: 20 }).map((radius): Command => ({ type: 'setBrush', change: { radius } })),
  );

  it('undo and redo walk through the very same documents (seed 7)', () => {
    fc.assert(
      fc.property(fc.array(command, { maxLength: 60 }), (commands) => {
        const end = commands.reduce(commit, newHistory());
        let back = end;
        while (undoable(back) !== null) back = undo(back);
        expect(back.present).toBe(EMPTY_DOCUMENT);
        let forth = back;
        while (redoable(forth) !== null) forth = redo(forth);
        expect(forth.present).toBe(end.present);
      }),
      { seed: 7, numRuns: 200 },
    );
  });
});
