import fc from 'fast-check';
import { afterEach, describe, expect, it, vi } from 'vitest';
import { jsonLine, printable, progress } from '../../src/cli/say.ts';

afterEach(() => vi.restoreAllMocks());

describe('say', () => {
  it('writes JSON as one line of ASCII that means the same (seed 4)', () => {
    fc.assert(
      fc.property(fc.string({ unit: 'binary' }), (text) => {
        const line = jsonLine({ text });
        expect(line).toMatch(/^[ -~]*$/);
        expect(JSON.parse(line)).toEqual({ text });
      }),
      { seed: 4, numRuns: 100 },
    );
  });

  it('shows letters of any language and no control characters', () => {
    expect(printable('Größe 梨 🍐\nnext')).toBe('Größe 梨 🍐\nnext');
    expect(printable('a\u001b[31mb\u0007\u009b\u202e\r')).toBe('a\\u001b[31mb\\u0007\\u009b\\u202e\\u000d');
  });

  it('says how far long work is, every two seconds, and nothing of short work', () => {
    const said: string[] = [];
    vi.spyOn(process.stderr, 'write').mockImplementation((text) => said.push(String(text)) > 0);
    let time = 0;
    const done = progress('parts meshed', 10, () => time);
    for (let i = 1; i <= 10; i++) {
      time += 900;
      done(i);
    }
    expect(said).toEqual([3, 6, 9].map((i) => `rotund: parts meshed: ${i} of 10\n`));
  });
});
