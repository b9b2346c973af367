import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { layout } from '../../src/document/layout.ts';

describe('layout', () => {
  it('says what JSON says (seed 21)', () => {
    fc.assert(
      fc.property(fc.jsonValue({ noUnicodeString: false }), (value) => {
        expect(JSON.parse(layout(value))).toEqual(value);
      }),
      { seed: 21, numRuns: 500 },
    );
  });

  it('keeps every bit of a number (seed 22)', () => {
    fc.assert(
      fc.property(fc.double({ noNaN: true, noDefaultInfinity: true }), (value) => {
        expect(Object.is(JSON.parse(layout([value]))[0], value)).toBe(true);
      }),
      { seed: 22, numRuns: 2000 },
    );
  });

  it('puts on one line what fits, and packs samples', () => {
    const samples = Array.from({ length: 200 }, (_, i) => [i, -i, 0.5, 0, 0, 8 * i]);
    const lines = layout({ a: { b: [1, 2, 3], c: 'd' }, samples }).split('\n');
    expect(lines[1]).toBe('  "a": { "b": [1, 2, 3], "c": "d" },');
    expect(Math.max(...lines.map((line) => line.length))).toBeLessThanOrEqual(141);
    expect(lines.length).toBeLessThan(60);
  });

  it('has empty lists and objects, and leaves out what is not there', () => {
    expect(layout({ a: [], b: {}, c: null, d: undefined })).toBe('{ "a": [], "b": {}, "c": null }\n');
  });
});
