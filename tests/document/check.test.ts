/** What pages hand to the element. */
import { describe, expect, it } from 'vitest';
import {
  checkCommand,
  checkCommands,
  checkDocument,
  checkDrawing,
  checkStroke,
} from '../../src/document/check.ts';
import { EMPTY_DOCUMENT } from '../../src/document/document.ts';
import { EMPTY_DRAWING } from '../../src/document/drawing.ts';
import { FileError, shown } from '../../src/document/fileError.ts';
import { serialize } from '../../src/document/serialize.ts';
import { COMMANDS, drawingOf, historyOf } from './files.ts';
import { line } from './strokes.ts';

const document = historyOf(COMMANDS).present;

function refused(task: () => unknown): string {
  try {
    task();
  } catch (error) {
    if (error instanceof FileError) return error.message;
    throw error;
  }
  throw new Error('was taken');
}

describe('data in hand', () => {
  it('comes back as it is when it is sound', () => {
    expect(checkStroke(line(3))).toEqual(line(3));
    expect(checkDocument(document)).toEqual(document);
    expect(checkDrawing(drawingOf(document))).toEqual(drawingOf(document));
    expect(checkDrawing(JSON.parse(serialize(drawingOf(document))))).toEqual(drawingOf(document));
    expect(checkDrawing({ document: EMPTY_DOCUMENT })).toEqual(EMPTY_DRAWING);
    expect(checkCommands(COMMANDS, EMPTY_DOCUMENT)).toEqual(COMMANDS);
    for (const command of COMMANDS) expect(checkCommand(command)).toEqual(command);
  });

  it('is a copy: what the page does to its own changes nothing', () => {
    const samples = [
      [0, 0],
      [0, 9],
    ];
    const stroke = checkStroke({ samples });
    samples[0]![0] = 7;
    expect(stroke.samples[0]?.x).toBe(0);
  });

  it.each([
    [
      () => checkStroke({ samples: [[0, NaN]] }),
      'stroke, samples[0][1]: expected y, a number from -1000000 to 1000000, found NaN',
    ],
    [
      () => checkStroke(undefined),
      'stroke: expected an object with samples, plane, view, pointer, closed, found nothing',
    ],
    [
      () => checkStroke(() => 1),
      'stroke: expected an object with samples, plane, view, pointer, closed, found a function',
    ],
    [() => checkStroke({}), /^stroke, samples: expected 1 to 100000 samples .*, found nothing$/],
    [() => checkCommand(Symbol('x')), /^command: expected one of addStroke, .*, found Symbol\(x\)$/],
    [() => checkCommand(10n), /^command: expected one of addStroke, .*, found 10$/],
    [
      () => checkCommand({ type: 'setBrush', change: { radius: undefined } }),
      'command, change.radius: expected a number from 0.1 to 200, found nothing',
    ],
    [
      () => checkCommand({ type: 'showParts', ids: ['part-9'], visible: true }, document),
      'command, ids[0]: expected the id of a part that is there by then, found "part-9"',
    ],
    [
      () => checkCommands({ type: 'keep' }),
      'commands: expected a list of at most 50000 commands, found an object',
    ],
    [
      () => checkCommands([{ type: 'keep' }, { type: 'renamePart', id: 'x', name: '' }], document),
      'commands, [1].id: expected the id of a part that is there by then, found "x"',
    ],
    [
      () => checkDrawing({ document: { parts: {} } }),
      'drawing, document.parts: expected a list of at most 10000 parts, found an object',
    ],
    [() => checkDocument([]), /^document: expected an object with version, parts, .*, found an empty list$/],
  ])('is refused with its place: %#', (task, message) => {
    expect(refused(task)).toMatch(message);
  });
});

describe('a found value', () => {
  it.each([
    ['a'.repeat(99), `"${'a'.repeat(40)}…`],
    ['🍐'.repeat(99), `"${'🍐'.repeat(20)}…`],
    ['"\n\u0000\u202e\ud83d', '"\\"\\n\\u0000\\u{202e}\\ud83d"'],
    [[1, 2], '[1, 2]'],
    [[1, '2'], 'a list of 2'],
    [{ a: 1 }, 'an object'],
    [-0, '0'],
  ])('%j', (value, text) => expect(shown(value)).toBe(text));
});
