import { describe, expect, it } from 'vitest';
import { countsOf, leftOut, nothingBecause, withoutEnd } from '../../src/cli/report.ts';
import { EMPTY_DOCUMENT } from '../../src/document/document.ts';
import { BALL, BLOBS, documentOf, RING, TORUS, UNFINISHED } from './drawings.ts';

const TWO = documentOf([...BALL, ...RING, UNFINISHED]);
const hidden = (count: number) => ({
  ...TWO,
  draft: null,
  parts: Array.from({ length: count }, (_, i) => ({ ...TWO.parts[0]!, name: `n${i}`, hidden: true })),
});

describe('report', () => {
  it('counts parts, and strokes of the unfinished form too', () => {
    expect(countsOf(TWO)).toEqual({ parts: 2, strokes: 4, components: 0, groups: 0, skels: 0 });
    expect(countsOf(EMPTY_DOCUMENT)).toEqual({ parts: 0, strokes: 0, components: 0, groups: 0, skels: 0 });
  });

  it('counts what is in bodies; shapes are no skels', () => {
    const counts = { parts: 3, strokes: 2, components: 1, groups: 1, skels: 3 };
    expect(countsOf(documentOf([BLOBS, TORUS, ...BALL]))).toEqual(counts);
  });

  it('tells of bodies that are cut off', () => {
    const half = (name: string) => ({
      ...TORUS,
      name,
      node: { type: 'shape', shape: { type: 'halfSpace', normal: [0, 1, 0], offset: 0 } } as const,
    });
    expect(withoutEnd(documentOf([TORUS]))).toEqual([]);
    expect(withoutEnd(documentOf([half('Sea'), TORUS]))[0]).toMatch(
      /^1 part is without end.*±100 mm: .Sea.$/,
    );
  });

  it('names what is left out, but not a thousand names', () => {
    expect(leftOut(TWO)).toEqual(['the unfinished form (1 stroke) is left out']);
    expect(leftOut(hidden(1))).toEqual(['1 hidden part is left out: “n0”']);
    const [many] = leftOut(hidden(1000));
    expect(many).toBe('1000 hidden parts are left out: “n0”, “n1”, “n2”, “n3”, “n4” and 995 more');
  });

  it('knows why there is nothing', () => {
    expect(nothingBecause(EMPTY_DOCUMENT)).toContain('no parts');
    expect(nothingBecause(documentOf([UNFINISHED]))).toContain('unfinished');
    expect(nothingBecause(hidden(2))).toContain('hidden');
    expect(nothingBecause(TWO)).toContain('no surface');
  });
});
