/** Finishes: set by commands, one a part, in files only where somebody set one. */
import { describe, expect, it } from 'vitest';
import { solids } from '../../src/document/build.ts';
import { apply, type Command } from '../../src/document/command/index.ts';
import { type Document, EMPTY_DOCUMENT, finishOf } from '../../src/document/document.ts';
import { EMPTY_DRAWING } from '../../src/document/drawing.ts';
import { changedBrush, DEFAULT_FINISH, type Finish } from '../../src/document/finish.ts';
import { FileError, parse, serialize, serializeScript } from '../../src/document/serialize.ts';
import { circle, line } from './strokes.ts';

const SATIN: Finish = { ambient: 0.9, diffuse: 1.1, specular: 0.25, shininess: 10 };

const made = (...commands: readonly Command[]): Document => commands.reduce(apply, EMPTY_DOCUMENT);
const TUBES = made(
  { type: 'addStroke', stroke: line(0) },
  { type: 'keep' },
  { type: 'addStroke', stroke: line(40) },
  { type: 'keep' },
);
const textOf = (document: Document): string => serialize({ ...EMPTY_DRAWING, document });
const readBack = (document: Document): Document => parse(textOf(document), 'x.rotund').document;
const setAll = (finish: Partial<Finish>): Command => ({
  type: 'setPartBrush',
  ids: TUBES.parts.map(({ id }) => id),
  change: { finish },
});

describe('a finish', () => {
  it('is that of the brush when a form is kept', () => {
    const document = made(
      { type: 'setBrush', change: { finish: SATIN } },
      { type: 'addStroke', stroke: line(0) },
      { type: 'keep' },
    );
    expect(finishOf(document.parts[0]!)).toEqual(SATIN);
    expect(solids(document)[0]!.finish).toEqual(SATIN);
  });

  it('is set number by number, and leaves the others of each part', () => {
    const [first] = TUBES.parts;
    const one = apply(TUBES, { type: 'setPartBrush', ids: [first!.id], change: { finish: SATIN } });
    const both = apply(one, setAll({ specular: 0.8 }));
    expect(both.parts.map(finishOf)).toEqual([
      { ...SATIN, specular: 0.8 },
      { ...DEFAULT_FINISH, specular: 0.8 },
    ]);
  });

  it('makes no new mesh, and setting it again changes nothing', () => {
    const changed = apply(TUBES, setAll(SATIN));
    expect(solids(changed).map(({ mesh }) => mesh)).toEqual(solids(TUBES).map(({ mesh }) => mesh));
    expect(apply(changed, setAll(SATIN))).toBe(changed);
    expect(apply(TUBES, setAll(DEFAULT_FINISH))).toBe(TUBES);
    const { brush } = TUBES;
    expect(changedBrush(brush, { finish: {} })).toBe(brush);
  });

  it('is one of all of a solid, whichever form of it is chosen', () => {
    const drawn = made(
      { type: 'addStroke', stroke: circle(40) },
      { type: 'keep' },
      { type: 'addStroke', stroke: circle(20, 45), joins: { solid: 'part-1', component: 'component-2' } },
      { type: 'keep' },
    );
    const [solid] = drawn.parts;
    const groups = solid!.kind === 'solid' ? solid!.components.flatMap((component) => component.groups) : [];
    expect(groups).toHaveLength(2);
    const set = apply(drawn, {
      type: 'setPartBrush',
      ids: [groups[1]!.id],
      change: { colour: '#112233', finish: SATIN },
    });
    expect(finishOf(set.parts[0]!)).toEqual(SATIN);
    const after = set.parts[0]!.kind === 'solid' ? set.parts[0]!.components[0]!.groups : [];
    expect(after.map(({ brush }) => brush.finish)).toEqual([SATIN, SATIN]);
    expect(after.map(({ brush }) => brush.colour)).toEqual([groups[0]!.brush.colour, '#112233']);
  });
});

describe('in files', () => {
  it('it is left out where nobody set one, so that older programs read them', () => {
    expect(textOf(TUBES)).not.toContain('finish');
    expect(JSON.parse(textOf(TUBES)).version).toBe(1);
  });

  it('it comes back to the bit, and asks for a program that knows it', () => {
    const document = apply(TUBES, setAll({ ambient: 0.1 + 0.2, shininess: 33.3 }));
    expect(readBack(document)).toEqual(document);
    expect(JSON.parse(textOf(document)).version).toBe(5);
    const brushed = made({ type: 'setBrush', change: { finish: SATIN } });
    expect(readBack(brushed)).toEqual(brushed);
    expect(JSON.parse(serializeScript([setAll(SATIN)], EMPTY_DRAWING)).version).toBe(5);
  });

  it.each([{ ambient: -0.1 }, { diffuse: 3 }, { specular: 1.5 }, { shininess: 0 }, { metal: 1 }])(
    'is refused with its place where it is none: %o',
    (finish) => {
      const text = textOf(apply(TUBES, setAll(SATIN)));
      const data = JSON.parse(text);
      data.document.parts[0].brush.finish = finish;
      const [key] = Object.keys(finish);
      const read = () => parse(JSON.stringify(data), 'x.rotund');
      expect(read).toThrow(FileError);
      expect(read).toThrow(new RegExp(`finish.*${key}|${key}`));
    },
  );
});
