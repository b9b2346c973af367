/** Names: whatever a person calls a part, a file stays readable and no two groups share a name. */
import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { fileName, plainName, wordNames, wordOf } from '../../src/export/names.ts';

describe('names of parts', () => {
  it('become one word each', () => {
    const names = [
      'Stem',
      'left arm',
      '<b>x</b>',
      'a\nf 1 2 3',
      '# note',
      'Größe 3',
      '梨',
      'a\u2028b',
      'x\u202ey',
    ];
    const words = ['Stem', 'left_arm', 'b_x_b', 'a_f_1_2_3', 'note', 'Größe_3', '梨', 'a_b', 'x_y'];
    expect(names.map(wordOf)).toEqual(words);
  });

  it('that are alike or empty are told apart', () => {
    expect(wordNames(['a', 'a', '', 'a_2', 'a', '#', ' '])).toEqual([
      'a',
      'a_2',
      'part',
      'a_2_2',
      'a_3',
      'part_2',
      'part_3',
    ]);
  });

  it('are distinct words for any text (seed 3)', () => {
    const any = fc.array(
      fc.string({ unit: fc.oneof(fc.constantFrom('a', '_', '2', ' ', '#'), fc.string()) }),
    );
    fc.assert(
      fc.property(any, (names) => {
        const words = wordNames(names);
        expect(new Set(words).size).toBe(names.length);
        for (const word of words) expect(word).toMatch(/^[^\s#/\\]+$/);
      }),
      { seed: 3, numRuns: 200 },
    );
  });

  it('stay as they are where any text may stand', () => {
    expect(plainName('<b>\n x', 0)).toBe('<b>\n x');
    expect(plainName('', 2)).toBe('Part 3');
    expect(plainName('a\ud800b', 0)).toBe('a\ufffdb');
  });
});

describe('names of files', () => {
  it('lose what systems forbid', () => {
    expect(fileName('My pear')).toBe('My pear');
    expect(fileName('a/b\\c:d*e?f"g<h>i|j\nk')).toBe('a-b-c-d-e-f-g-h-i-j-k');
    expect(fileName('../../etc')).toBe('-..-etc');
    expect(fileName('con')).toBe('_con');
    expect(fileName('x'.repeat(300))).toHaveLength(60);
  });

  it('are never empty', () => {
    expect(['', '  ', '...', '\u3000'].map(fileName)).toEqual(['rotund', 'rotund', 'rotund', 'rotund']);
  });
});
