import { describe, expect, it } from 'vitest';
import { RESOLUTION } from '../../src/document/build.ts';
import { COMMAND_TYPES } from '../../src/document/command/index.ts';
import { EMPTY_DOCUMENT, strokesOf } from '../../src/document/document.ts';
import { EMPTY_DRAWING, FRONT_VIEW } from '../../src/document/drawing.ts';
import { scriptOf } from '../../src/document/history.ts';
import { LIMITS } from '../../src/document/limits.ts';
import { DEFAULT_LOOK } from '../../src/document/look.ts';
import { parse, replay, serialize, serializeScript } from '../../src/document/serialize.ts';
import { bytesOf, COMMANDS, drawingOf, historyOf, meshesOf, NAMES } from './files.ts';
import { line } from './strokes.ts';

const history = historyOf(COMMANDS);
const drawing = drawingOf(history.present);

describe('a .rotund file', () => {
  it('holds everything to the bit', () => {
    expect(parse(serialize(drawing), 'x.rotund')).toEqual(drawing);
    expect(parse(serialize(EMPTY_DRAWING), 'x.rotund')).toEqual(EMPTY_DRAWING);
  });

  it('gives the same meshes byte for byte', { timeout: 30_000 }, () => {
    const back = parse(serialize(drawing), 'x.rotund').document;
    expect(bytesOf(meshesOf(back, RESOLUTION))).toEqual(bytesOf(meshesOf(history.present, RESOLUTION)));
  });

  it('is the same text again', () => {
    const text = serialize(drawing);
    expect(serialize(parse(text, 'x.rotund'))).toBe(text);
  });

  it.each(NAMES)('keeps the name %j as it is', (name) => {
    const [part] = drawing.document.parts;
    const named = { ...drawing, name, document: { ...drawing.document, parts: [{ ...part!, name }] } };
    expect(parse(serialize(named), 'x.rotund')).toEqual(named);
  });

  it('keeps numbers that decimal notation hardly holds', () => {
    const values = [0.1 + 0.2, 1 / 3, -0, 5e-324, 2 ** -1074, 123456.78901234567, 1e-7, 999999.9999999999];
    const stroke = { ...line(0), samples: values.map((x) => ({ ...line(0).samples[0]!, x, y: -x })) };
    const document = { ...EMPTY_DOCUMENT, draft: { strokes: [stroke] } };
    const back = parse(serialize({ ...EMPTY_DRAWING, document }), 'x').document.draft!.strokes[0]!;
    back.samples.forEach(({ x, y }, i) => {
      expect(Object.is(x, values[i])).toBe(true);
      expect(Object.is(y, -values[i]!)).toBe(true);
    });
  });

  it('takes its name from the file where it has none', () => {
    const { name: _, ...nameless } = JSON.parse(serialize(drawing));
    expect(parse(JSON.stringify(nameless), 'C:\\drawings\\My pear.rotund').name).toBe('My pear');
    expect(parse('[]', '/home/x.y/little.demon.json').name).toBe('little.demon');
    expect(parse('[]', `${'n'.repeat(300)}.rotund`).name).toHaveLength(LIMITS.drawingName);
  });

  it('needs no more than what cannot be guessed', () => {
    const text =
      '{"format":"rotund","version":1,"document":{"parts":[{"kind":"tube","strokes":[{"samples":[[0,0],[0,9]]}]}]}}';
    const { document, view, look } = parse(text, 'x.rotund');
    expect({ view, look }).toEqual({ view: FRONT_VIEW, look: DEFAULT_LOOK });
    expect(document.nextId).toBe(2);
    expect(document.parts[0]).toMatchObject({ id: 'part-1', name: 'Tube 1', hidden: false });
    expect(strokesOf(document.parts[0]!)[0]).toMatchObject({ pointer: 'pen', closed: false });
  });
});

describe('a version below what is in the file', () => {
  const node = { type: 'shape', shape: { type: 'sphere', radius: 5 } };
  const document = { parts: [{ kind: 'body', node }] };
  const add = { type: 'addBody', node };

  it.each<readonly [string, object]>([
    ['a drawing', { format: 'rotund', document }],
    ['a script', { format: 'rotund-script', commands: [add] }],
    ['a script that loads', { format: 'rotund-script', commands: [{ type: 'load', document }] }],
  ])('is refused: bodies in %s of version 1', (_, file) => {
    const text = (version: number) => JSON.stringify({ ...file, version });
    expect(() => parse(text(1), 'x.rotund')).toThrow(
      'x.rotund, version: expected 2, because there are bodies in it, found 1',
    );
    expect(parse(text(2), 'x.rotund').document.parts).toHaveLength(1);
  });
});

describe('a script', () => {
  it('makes the same document and the same meshes', () => {
    const back = parse(serializeScript(scriptOf(history), drawing), 'x.rotund');
    expect(back).toEqual(drawing);
    expect(bytesOf(meshesOf(back.document))).toEqual(bytesOf(meshesOf(history.present)));
    expect(replay(COMMANDS)).toEqual(history.present);
  });

  it('is tried here with every command there is', () => {
    const types = new Set<string>([...COMMANDS.map(({ type }) => type), 'removeAll', 'load']);
    expect([...types].sort()).toEqual([...COMMAND_TYPES].sort());
    const commands = [
      ...COMMANDS,
      { type: 'removeAll' },
      { type: 'load', name: 'a', document: drawing.document },
    ];
    const text = serializeScript(commands as typeof COMMANDS, drawing);
    expect(parse(text, 'x').document).toEqual(drawing.document);
  });

  it('may be a bare list, with strokes as short as a hand writes them', () => {
    const { document } = parse('[{"type":"addStroke","stroke":{"samples":[[1,2],[3,4,0.25]]}}]', 'a/b.json');
    expect(document.draft?.strokes).toEqual([
      {
        samples: [
          { x: 1, y: 2, pressure: 0.5, tiltX: 0, tiltY: 0, time: 0 },
          { x: 3, y: 4, pressure: 0.25, tiltX: 0, tiltY: 0, time: 8 },
        ],
        plane: { origin: [0, 0, 0], x: [1, 0, 0], y: [0, 1, 0] },
        view: FRONT_VIEW,
        pointer: 'pen',
        closed: false,
      },
    ]);
  });

  it('reads the form the program has in hand, too', () => {
    expect(parse(JSON.stringify(COMMANDS), 'x').document).toEqual(history.present);
  });
});
