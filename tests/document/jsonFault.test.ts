import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { jsonFault } from '../../src/document/jsonFault.ts';

const isJson = (text: string): boolean => {
  try {
    JSON.parse(text);
    return true;
  } catch {
    return false;
  }
};

describe('jsonFault', () => {
  it.each([
    ['', 0, 'a value'],
    ['[1, 2', 5, 'a comma or ]'],
    ['[1, 2,', 6, 'a value'],
    ['[1, 2,]', 6, 'a value'],
    ['[', 1, 'a value or ]'],
    ['{', 1, 'a name in quotation marks or }'],
    ['{"a"', 4, 'a colon'],
    ['{"a":1,', 7, 'a name in quotation marks'],
    ['{"a":1 "b":2}', 7, 'a comma or }'],
    ["{'a':1}", 1, 'a name in quotation marks or }'],
    ['"ab', 3, 'a quotation mark at the end of the text before it'],
    ['"a\nb"', 2, 'a quotation mark at the end of the text before it'],
    ['"a\\x"', 2, 'an escape such as \\n or \\u00e9 after a backslash'],
    ['[NaN]', 1, 'a value or ]'],
    ['[1] [2]', 4, 'the end of the text'],
    ['01', 1, 'the end of the text'],
    ['[-]', 1, 'a value or ]'],
  ])('%j', (text, offset, expected) => {
    expect(jsonFault(text)).toEqual({ offset, expected });
  });

  it('agrees with the engine on texts of JSON’s own characters (seed 11)', () => {
    const token = fc.constantFrom(
      ...'{}[]:,"\\ \n\t0123456789.eE+-/',
      'true',
      'false',
      'null',
      '"a"',
      '1',
      '\\u00e9',
      'é',
      '\u0001',
    );
    const text = fc.array(token, { maxLength: 12 }).map((tokens) => tokens.join(''));
    fc.assert(
      fc.property(text, (json) => (jsonFault(json) === null) === isJson(json)),
      { seed: 11, numRuns: 20_000 },
    );
  });

  it('finds nothing in JSON, and the end of it where it is cut off (seed 12)', () => {
    const json = fc.json().map((text) => `[${text}]`);
    fc.assert(
      fc.property(json, fc.nat(), (text, cut) => {
        expect(jsonFault(text)).toBeNull();
        const part = text.slice(0, cut % text.length);
        // a word, a number or an escape is a fault where it begins
        expect(jsonFault(part)!.offset).toBeGreaterThanOrEqual(part.replace(/[\w.+\\-]*$/, '').length);
      }),
      { seed: 12, numRuns: 500 },
    );
  });

  it('walks any depth', () => {
    expect(jsonFault('['.repeat(1_000_000))?.offset).toBe(1_000_000);
  });
});
