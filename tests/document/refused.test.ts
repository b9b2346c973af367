/** Files that are refused, and the sentence that says why. */
import { describe, expect, it } from 'vitest';
import { type Document, EMPTY_DOCUMENT } from '../../src/document/document.ts';
import { LIMITS } from '../../src/document/limits.ts';
import { FileError, parse, serialize } from '../../src/document/serialize.ts';
import { COMMANDS, drawingOf, historyOf } from './files.ts';
import { line } from './strokes.ts';

const drawing = drawingOf(historyOf(COMMANDS).present);

/** The message, and that it is the only kind of error. */
function refusal(text: string, file = 'Pear.rotund'): FileError {
  try {
    parse(text, file);
  } catch (error) {
    if (error instanceof FileError) return error;
    throw error;
  }
  throw new Error('was read');
}

const part = (fields: string) =>
  `{"format":"rotund","version":1,"document":{"parts":[{"kind":"tube","strokes":[{"samples":[[0,0],[0,9]]}],${fields}}]}}`;
const stroke = (fields: string) => `[{"type":"addStroke","stroke":{"samples":[[0,0],[0,9]],${fields}}}]`;
const samples = (rows: string) => `[{"type":"addStroke","stroke":{"samples":${rows}}}]`;
const draw = '{"type":"addStroke","stroke":{"samples":[[0,0],[0,9]]}}';

describe('what is wrong is said in one sentence', () => {
  it.each([
    ['', 'Pear.rotund: the file is empty; expected a Rotund document or script'],
    ['\ufeff \n', 'Pear.rotund: the file is empty; expected a Rotund document or script'],
    [
      '\ufffdPNG\r\n\u001a\n\0\0\0\rIHDR',
      'Pear.rotund: not a Rotund file: expected a Rotund document or script, which begins with { or [, found "\ufffdPNG\\r\\n\\u001a\\n\\u0000\\u0000\\u0000\\r"',
    ],
    [
      '# Blender\no Cube\nv 1 1 1\n',
      'Pear.rotund: not a Rotund file: expected a Rotund document or script, which begins with { or [, found "# Blender\\no "',
    ],
    [
      'null',
      'Pear.rotund: not a Rotund file: expected a Rotund document or script, which begins with { or [, found "null"',
    ],
    [
      '42',
      'Pear.rotund: not a Rotund file: expected a Rotund document or script, which begins with { or [, found "42"',
    ],
    ['{}', 'Pear.rotund, format: not a Rotund file: expected "rotund" or "rotund-script", found nothing'],
    [
      '{"format":"tldraw"}',
      'Pear.rotund, format: not a Rotund file: expected "rotund" or "rotund-script", found "tldraw"',
    ],
    ['{"format":"rotund","version":9}', 'Pear.rotund is version 9; this program reads up to 5.'],
    [
      '{"format":"rotund-script","version":6,"new":[]}',
      'Pear.rotund is version 6; this program reads up to 5.',
    ],
    [
      '{"format":"rotund","version":"1"}',
      'Pear.rotund, version: expected version 1, 2, 3, 4 or 5, found "1"',
    ],
    ['{"format":"rotund","version":0}', 'Pear.rotund, version: expected version 1, 2, 3, 4 or 5, found 0'],
    [
      '{"format":"rotund","document":{}}',
      'Pear.rotund, version: expected version 1, 2, 3, 4 or 5, found nothing',
    ],
    ['{"format":"rotund","version":1}', 'Pear.rotund, document: expected an object, found nothing'],
    [
      '{"format":"rotund","version":1,"document":{"parts":[',
      'Pear.rotund, line 1, column 53: expected a value or ], found the end: the file is cut off',
    ],
    [
      '{\n  "format": "rotund",\r\n  "version": 1,,\n}',
      'Pear.rotund, line 3, column 16: expected a name in quotation marks, found ",\\n}"',
    ],
    ['[{"type":"keep"}, nan]', 'Pear.rotund, line 1, column 19: expected a value, found "nan]"'],
    [
      part('"brush":{"radius":"thick"}'),
      'Pear.rotund, document.parts[0].brush.radius: expected a number from 0.1 to 200, found "thick"',
    ],
    [
      part('"brush":{"radius":0}'),
      'Pear.rotund, document.parts[0].brush.radius: expected a number from 0.1 to 200, found 0',
    ],
    [
      part('"brush":{"levels":2.5}'),
      'Pear.rotund, document.parts[0].brush.levels: expected a whole number from 0 to 6, found 2.5',
    ],
    [
      part('"brush":{"colour":"red"}'),
      'Pear.rotund, document.parts[0].brush.colour: expected a colour #rrggbb, found "red"',
    ],
    [
      part('"brush":{"caps":1}'),
      'Pear.rotund, document.parts[0].brush.caps: expected true or false, found 1',
    ],
    [
      part('"brush":[]'),
      'Pear.rotund, document.parts[0].brush: expected an object with colour, radius, pressure, caps, filter, levels, finish, found an empty list',
    ],
    [
      part('"brush":{"radus":3}'),
      'Pear.rotund, document.parts[0].brush: expected only the fields colour, radius, pressure, caps, filter, levels, finish, found "radus"',
    ],
    [
      part('"__proto__":{"hidden":true}'),
      'Pear.rotund, document.parts[0]: expected only the fields id, name, kind, strokes, sections, back, between, bends, detail, brush, placement, hidden, found "__proto__"',
    ],
    [
      part('"constructor":0'),
      'Pear.rotund, document.parts[0]: expected only the fields id, name, kind, strokes, sections, back, between, bends, detail, brush, placement, hidden, found "constructor"',
    ],
    [
      part('"name":""'),
      'Pear.rotund, document.parts[0].name: expected a text of 1 to 80 characters, found ""',
    ],
    [
      part(`"name":"${'n'.repeat(81)}"`),
      `Pear.rotund, document.parts[0].name: expected a text of 1 to 80 characters, found "${'n'.repeat(40)}…`,
    ],
    [
      part('"name":"<b>\\u0007\\u202e</b>\\n\\u2028" ,"id":7'),
      'Pear.rotund, document.parts[0].id: expected a text of 1 to 80 characters, found 7',
    ],
    [
      part('"kind":"<b>\\u202e\\u2028"'),
      'Pear.rotund, document.parts[0].kind: expected one of "tube", "rotational", "crossSection", "bspline", "body", "solid", found "<b>\\u{202e}\\u{2028}"',
    ],
    [
      part('"kind":"rotational"'),
      'Pear.rotund, document.parts[0].strokes: expected 2 strokes, which "rotational" is made of, found a list of 1',
    ],
    [
      part('"placement":{"rotation":[1,1,0,0]}'),
      'Pear.rotund, document.parts[0].placement.rotation: expected a unit quaternion, four numbers, found [1, 1, 0, 0]',
    ],
    [
      part('"placement":{"translation":[0,0]}'),
      'Pear.rotund, document.parts[0].placement.translation[2]: expected a number from -1000000 to 1000000, found nothing',
    ],
    [
      part('"placement":{"translation":[0,0,0,0]}'),
      'Pear.rotund, document.parts[0].placement.translation[3]: expected three numbers from -1000000 to 1000000, found 0',
    ],
    [
      '{"format":"rotund","version":1,"document":{"draft":{"strokes":[]}}}',
      'Pear.rotund, document.draft.strokes: expected 1 to 2 strokes, else null for the whole draft, found an empty list',
    ],
    [
      stroke('"plane":{"y":[1,0,0]}'),
      'Pear.rotund, commands[0].stroke.plane.y: expected a unit vector at right angles to x, found [1, 0, 0]',
    ],
    [
      stroke('"plane":{"x":[0,0,0]}'),
      'Pear.rotund, commands[0].stroke.plane.x: expected a unit vector, found [0, 0, 0]',
    ],
    [
      stroke('"view":{"height":0}'),
      'Pear.rotund, commands[0].stroke.view.height: expected a number from 1e-9 to 1000000000, found 0',
    ],
    [
      stroke('"view":{"fov":0.5}'),
      'Pear.rotund, commands[0].stroke.view.fov: expected 0 (orthographic) or a number from 1 to 120, found 0.5',
    ],
    [
      stroke('"pointer":"finger"'),
      'Pear.rotund, commands[0].stroke.pointer: expected one of "pen", "touch", "mouse", found "finger"',
    ],
    [
      samples('[]'),
      'Pear.rotund, commands[0].stroke.samples: expected 1 to 100000 samples [x, y, pressure, tiltX, tiltY, time], found an empty list',
    ],
    [
      samples('[[0,0],[1e308,0]]'),
      'Pear.rotund, commands[0].stroke.samples[1][0]: expected x, a number from -1000000 to 1000000, found 1e+308',
    ],
    [
      samples('[[0,0],[1e999,0]]'),
      'Pear.rotund, commands[0].stroke.samples[1][0]: expected x, a number from -1000000 to 1000000, found Infinity',
    ],
    [
      samples('[[0,0],[0,"NaN"]]'),
      'Pear.rotund, commands[0].stroke.samples[1][1]: expected y, a number from -1000000 to 1000000, found "NaN"',
    ],
    [
      samples('[[0,0,null]]'),
      'Pear.rotund, commands[0].stroke.samples[0][2]: expected pressure, a number from 0 to 1, found null',
    ],
    [
      samples('[[0]]'),
      'Pear.rotund, commands[0].stroke.samples[0]: expected 2 to 6 numbers [x, y, pressure, tiltX, tiltY, time], found [0]',
    ],
    [
      samples('[{"x":0,"y":0,"z":0}]'),
      'Pear.rotund, commands[0].stroke.samples[0]: expected a sample with only x, y, pressure, tiltX, tiltY, time, found an object',
    ],
    [
      samples('[7]'),
      'Pear.rotund, commands[0].stroke.samples[0]: expected a sample [x, y, pressure, tiltX, tiltY, time], found 7',
    ],
    [
      '[[]]',
      expect.stringMatching(
        /^Pear.rotund, commands\[0\].type: expected one of addStroke, addBody, setBody, keep, .*, found nothing$/,
      ),
    ],
    [
      '["keep"]',
      expect.stringMatching(
        /^Pear.rotund, commands\[0\]: expected one of addStroke, addBody, setBody, keep, .*, found "keep"$/,
      ),
    ],
    [
      '[{"type":"explode"}]',
      expect.stringMatching(
        /^Pear.rotund, commands\[0\].type: expected one of addStroke, addBody, setBody, keep, .*, found "explode"$/,
      ),
    ],
    ['[{"type":"constructor"}]', expect.stringMatching(/^Pear.rotund, commands\[0\].type: expected one of/)],
    [
      `[${draw},{"type":"keep","now":true}]`,
      'Pear.rotund, commands[1]: expected only the fields type, found "now"',
    ],
    [
      `[${draw},{"type":"removeParts","ids":["part-1"]}]`,
      'Pear.rotund, commands[1].ids[0]: expected the id of a part that is there by then, found "part-1"',
    ],
    [
      `[${draw},{"type":"keep"},{"type":"renamePart","id":"part-2","name":"x"}]`,
      'Pear.rotund, commands[2].id: expected the id of a part that is there by then, found "part-2"',
    ],
    [
      '[{"type":"load","document":{"parts":7}}]',
      'Pear.rotund, commands[0].document.parts: expected a list of at most 10000 parts, found 7',
    ],
    [
      '[{"type":"load","document":{"version":2}}]',
      'Pear.rotund, commands[0].document.version: expected 1, found 2',
    ],
  ])('%j', (text, message) => {
    expect(refusal(text).message).toEqual(message);
  });

  it('keeps file and place apart', () => {
    const { file, place } = refusal(part('"brush":{"radius":"thick"}'));
    expect({ file, place }).toEqual({ file: 'Pear.rotund', place: 'document.parts[0].brush.radius' });
  });

  it('refuses ids that two parts share, and a next number that is in use', () => {
    const { parts } = drawing.document;
    const twins = { ...drawing.document, parts: [parts[0]!, parts[1]!, parts[0]!] };
    const refused = (document: Document) => refusal(serialize({ ...drawing, document }));
    expect(refused(twins).message).toBe(
      'Pear.rotund, document.parts[2].id: expected an id that nothing else has, found "part-1"',
    );
    expect(refused({ ...drawing.document, nextId: 4 }).message).toBe(
      'Pear.rotund, document.nextId: expected a whole number above 26, which is in use, found 4',
    );
  });

  it('refuses strokes of one form on different planes', () => {
    const second = { ...line(20), plane: { ...line(20).plane, origin: [0, 0, 1] as const } };
    const document = { ...EMPTY_DOCUMENT, draft: { strokes: [line(0), second] } };
    expect(refusal(serialize({ ...drawing, document })).message).toBe(
      'Pear.rotund, document.draft.strokes[1]: expected a stroke on the very plane of strokes[0], open or closed like it, found an object',
    );
  });
});

describe('too much is refused at once', { timeout: 30_000 }, () => {
  it('a million samples in a stroke', () => {
    const { message } = refusal(samples(`[${'[0,0],'.repeat(999_999)}[0,0]]`));
    expect(message).toMatch(
      /^Pear.rotund, commands\[0\].stroke.samples: expected 1 to 100000 samples .*, found a list of 1000000$/,
    );
  });

  it('more strokes than a document may have, however they come', () => {
    const strokes = `${draw},`.repeat(LIMITS.strokes);
    expect(refusal(`[${strokes}${draw}]`).message).toBe(
      `Pear.rotund, commands[${LIMITS.strokes}].type: expected a document of at most 10000 strokes and bodies and 400000 samples and values of bodies and solids in all after this, found "addStroke"`,
    );
    const kept = '{"kind":"tube","strokes":[{"samples":[[0,0]]}]}';
    const parts = Array.from({ length: LIMITS.strokes }, () => kept).join();
    const draft = '{"strokes":[{"samples":[[0,0]]}]}';
    const text = `{"format":"rotund","version":1,"document":{"parts":[${parts}],"draft":${draft}}}`;
    expect(refusal(text).message).toBe(
      'Pear.rotund, document.parts: expected at most 10000 strokes and bodies and 400000 samples and values of bodies and solids in all, found a list of 10000',
    );
  });

  it('more samples than a document may have, also by copies', () => {
    const many = `{"samples":[${'[0,0],'.repeat(LIMITS.samples - 1)}[0,0]]}`;
    const parts = Array.from({ length: 4 }, () => `{"kind":"tube","strokes":[${many}]}`).join();
    const load = `{"type":"load","document":{"parts":[${parts}]}}`;
    expect(parse(`[${load}]`, 'x').document.parts).toHaveLength(4);
    expect(refusal(`[${load},{"type":"duplicateParts","ids":["part-1"],"offset":[0,0,1]}]`).message).toBe(
      'Pear.rotund, commands[1].type: expected a document of at most 10000 strokes and bodies and 400000 samples and values of bodies and solids in all after this, found "duplicateParts"',
    );
  });

  it.each([440, 100_000, 5_000_000])('%i brackets', (depth) => {
    expect(refusal('['.repeat(depth)).message).toBe(
      'Pear.rotund, line 1, column 421: expected at most 420 brackets inside each other',
    );
    expect(refusal(`{"format":${'{"a":'.repeat(depth)}`).place).toBe('line 1, column 2106');
  });

  it('more text than a file may have', () => {
    expect(refusal(' '.repeat(LIMITS.text + 1)).message).toBe(
      'Pear.rotund: expected at most 64 MiB of text, found 65 MiB',
    );
  });
});
