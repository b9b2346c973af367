/** Which file a drawing came from, through opening, undo and redo: Save must never reach another drawing's file. */
import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest';
import { EMPTY_DOCUMENT, type Part } from '../../src/document/document.ts';
import { type Drawing, EMPTY_DRAWING } from '../../src/document/drawing.ts';
import { PLAIN } from '../../src/document/surfacePart.ts';
import type { Origin } from '../../src/element/origins.ts';
import { Origins } from '../../src/element/origins.ts';
import { Session } from '../../src/element/session.ts';
import type { Stroke } from '../../src/stroke/stroke.ts';

const part = { ...PLAIN, id: 'p1', name: 'Body', kind: 'tube', strokes: [] as readonly Stroke[] } as Part;

const drawing = (name: string): Drawing => ({
  ...EMPTY_DRAWING,
  name,
  document: { ...EMPTY_DOCUMENT, parts: [part] },
});

const file = (name: string): Origin => ({ name: `${name}.rotund`, handle: null });

let session: Session;
let origins: Origins;
let replaced: string[];

beforeEach(() => {
  vi.stubGlobal('requestAnimationFrame', () => 1);
  replaced = [];
  session = new Session({
    changed: () => {},
    drawn: () => {},
    selected: () => {},
    moded: () => {},
    committed: (commands, cause) => {
      origins.changed({ commands, cause, document: session.document });
    },
  });
  origins = new Origins(session, ({ name }) => replaced.push(name));
});

afterEach(() => void vi.unstubAllGlobals());

/** As a person does it, with an update of the controls after it. */
function open(name: string, from: Origin | null, where: 'file' | 'sample' | null = from && 'file'): void {
  origins.next = from;
  session.open(drawing(name));
  origins.next = null;
  if (where) origins.mark(session.document, session.name, where);
  origins.remember();
}

function edit(): void {
  session.run({ type: 'setTubesOnly', on: !session.document.tubesOnly });
  origins.remember();
}

const undo = () => {
  session.undo();
  origins.remember();
};
const redo = () => {
  session.redo();
  origins.remember();
};

const here = () => [session.name, origins.current?.name ?? null];

describe('the file of a drawing', () => {
  it('goes with undo and comes back with redo', () => {
    open('Pear', file('Pear'));
    open('Candle', file('Candle'));
    expect(here()).toEqual(['Candle', 'Candle.rotund']);
    undo();
    expect(here()).toEqual(['Pear', 'Pear.rotund']);
    undo();
    expect(here()).toEqual(['', null]);
    redo();
    redo();
    expect(here()).toEqual(['Candle', 'Candle.rotund']);
  });

  it('comes back by the name it was given since', () => {
    open('Pear', file('Pear'));
    session.name = 'Apple';
    origins.current = file('Apple');
    origins.remember();
    open('Candle', file('Candle'));
    undo();
    expect(here()).toEqual(['Apple', 'Apple.rotund']);
    redo();
    expect(here()).toEqual(['Candle', 'Candle.rotund']);
  });

  it('is none for a sample, for what a page loads, and for a new drawing', () => {
    open('Pear', file('Pear'));
    open('Candle', null, 'sample');
    expect(here()).toEqual(['Candle', null]);
    open('Pear', file('Pear'));
    session.open(drawing('Loaded'));
    expect(origins.current).toBeNull();
    open('Pear', file('Pear'));
    session.clear();
    expect(here()).toEqual(['', null]);
    undo();
    expect(here()).toEqual(['Pear', 'Pear.rotund']);
  });
});

describe('what was replaced', () => {
  it('is set aside only when no file has it', () => {
    open('Pear', file('Pear'));
    open('Candle', null, 'sample');
    expect(replaced).toEqual([]);
    edit();
    open('Flower', null, 'sample');
    expect(replaced).toEqual(['Candle']);
  });

  it('is set aside when everything is deleted, too', () => {
    open('Pear', null, null);
    session.run({ type: 'removeAll' });
    expect(replaced).toEqual(['Pear']);
  });

  it('is unchanged again when all changes are undone', () => {
    open('Pear', file('Pear'));
    edit();
    expect(origins.where(session.drawing)).toBeNull();
    expect(origins.fact).toMatchObject({ unchanged: false });
    undo();
    expect(origins.where(session.drawing)).toBe('file');
    expect(origins.fact).toEqual({ name: 'Pear.rotund', unchanged: true });
  });

  it('is changed when only its name is', () => {
    open('Pear', file('Pear'));
    session.name = 'Apple';
    expect(origins.where(session.drawing)).toBeNull();
  });
});
