import { describe, expect, it } from 'vitest';
import { apply } from '../../src/document/command/index.ts';
import { EMPTY_DOCUMENT, isSolid } from '../../src/document/document.ts';
import { middleOfParts, seenParts } from '../../src/document/extent.ts';
import { FileError, parse } from '../../src/document/serialize.ts';
import { groupsOf } from '../../src/document/solid.ts';
import { partsCopied, partsIn, textOf } from '../../src/element/clipboard.ts';
import { figure, solidOf } from '../document/figure.ts';

const document = figure();
const { part, groups } = solidOf(document);

describe('what is copied', () => {
  it('is whole parts, and of groups a solid of those alone', () => {
    expect(partsCopied(document, [part.id])).toEqual([part]);
    const [head, ...others] = partsCopied(document, [groups[1]!.id]);
    expect(others).toEqual([]);
    expect(head?.name).toBe('Head');
    if (!head || !isSolid(head)) throw new Error('a solid');
    expect(groupsOf(head)).toEqual([groups[1]]);
    const [both] = partsCopied(document, [groups[1]!.id, groups[3]!.id]);
    expect(both && isSolid(both) && both.components.length).toBe(2);
    expect(partsCopied(document, [])).toEqual([]);
  });

  it('comes back from its text to the bit, in another drawing', () => {
    const text = textOf(document, [groups[2]!.id]);
    const parts = partsIn(text)!;
    const pasted = apply(EMPTY_DOCUMENT, { type: 'paste', parts, offset: [3, 4, 0] });
    const [copy] = pasted.parts;
    if (!copy || !isSolid(copy)) throw new Error('a solid');
    expect(groupsOf(copy)[0]!.strokes).toEqual(groups[2]!.strokes);
    const [x, y] = middleOfParts(seenParts(pasted, [groupsOf(copy)[0]!.id]))!;
    const [x0, y0] = middleOfParts(seenParts(document, [groups[2]!.id]))!;
    expect([x - x0, y - y0]).toEqual([expect.closeTo(3, 9), expect.closeTo(4, 9)]);
  });

  it('is a command as scripts have them', () => {
    const { document: read } = parse(`[${textOf(document, [part.id])}]`, 'clip.rotund');
    expect(read.parts).toHaveLength(1);
  });

  it('is told from other text, and refused where it is broken', () => {
    for (const other of ['', 'hello', '{"a":1}', '[1,2]', '<svg>']) expect(partsIn(other)).toBeNull();
    for (const broken of ['{"type":"paste"', '{"type":"paste","parts":[{"kind":"solid"}],"offset":[0,0,0]}'])
      expect(() => partsIn(broken)).toThrow(FileError);
  });
});
