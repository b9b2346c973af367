import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { jsonLine, printable } from '../../src/cli/say.ts';

describe('say', () => {
  it('writes JSON as one line of ASCII that means the same (seed 4)', () => {
    fc.assert(
      fc.property(fc.string({ unit: 'binary' }), (text) => {
        const line = jsonLine({ text });
        expect(line).toMatch(/^[ -~]*$/);
        expect(JSON.parse(line)).toEqual({ text });
      }),
      { seed: 4, numRuns: 500 },
    );
  });

  it('shows letters of any language and no control characters', () => {
    expect(printable('Größe 梨 🍐\nnext')).toBe('Größe 梨 🍐\nnext');
    expect(printable('a\u001b[31mb\u0007\u009b\u202e\r')).toBe('a\\u001b[31mb\\u0007\\u009b\\u202e\\u000d');
  });
});
