/** Ids that look like the program's own with numbers of any length: what was read can be saved and read again. */
import { describe, expect, it } from 'vitest';
import { apply } from '../../src/document/command/index.ts';
import { EMPTY_DRAWING } from '../../src/document/drawing.ts';
import { parse, serialize } from '../../src/document/serialize.ts';
import { line } from '../document/strokes.ts';

const TUBE = apply(apply(EMPTY_DRAWING.document, { type: 'addStroke', stroke: line(0) }), { type: 'keep' });

/** The file with this id, and with a number of its own or none. */
function text(id: string, nextId?: number): string {
  const file = JSON.parse(serialize({ ...EMPTY_DRAWING, document: TUBE }));
  file.document.parts[0].id = id;
  file.document.nextId = nextId;
  return JSON.stringify(file);
}

describe('an id with a high number', () => {
  it.each([
    ['part-1732190000000', undefined],
    ['part-999999999999999', undefined],
    ['part-9007199254740993', undefined],
    [`part-${'9'.repeat(60)}`, undefined],
    ['part-7', Number.MAX_SAFE_INTEGER],
  ])('%s, next %s', (id, nextId) => {
    const drawing = parse(text(id, nextId), 'high.rotund');
    const drawn = apply(drawing.document, { type: 'addStroke', stroke: line(20) });
    const kept = apply(drawn, { type: 'keep' });
    const ids = kept.parts.map((part) => part.id);
    expect(new Set(ids).size).toBe(2);
    expect(parse(serialize({ ...drawing, document: kept }), 'again.rotund').document).toEqual(kept);
  });
});
