import { describe, expect, it } from 'vitest';
import { solidOf } from '../../src/document/build.ts';
import { copiesOf } from '../../src/document/command/duplicateParts.ts';
import { apply, type Command } from '../../src/document/command/index.ts';
import { type Document, EMPTY_DOCUMENT, strokesOf } from '../../src/document/document.ts';
import { line } from './strokes.ts';

const KEEP: Command = { type: 'keep' };
const three = [line(0), line(10), line(20)]
  .flatMap((stroke): Command[] => [{ type: 'addStroke', stroke }, KEEP])
  .reduce(apply, EMPTY_DOCUMENT);
const copy = (document: Document, ...ids: string[]) =>
  apply(document, { type: 'duplicateParts', ids, offset: [5, -5, 0] });

describe('duplicateParts', () => {
  it('puts copies behind all others, moved by the offset, with ids no part ever had', () => {
    const copied = copy(three, 'part-3', 'part-1');
    expect(copied.parts.slice(0, 3)).toEqual(three.parts);
    expect(copied.parts.slice(3).map(({ id }) => id)).toEqual(copiesOf(three, ['part-1', 'part-3']));
    expect(new Set(copied.parts.map(({ id }) => id)).size).toBe(5);
    for (const part of copied.parts.slice(3)) expect(part.placement.translation).toEqual([5, -5, 0]);
    const emptied = apply(copied, { type: 'removeAll' });
    expect(apply(apply(emptied, { type: 'addStroke', stroke: line(0) }), KEEP).parts[0]!.id).toBe('part-6');
  });

  it('shares the strokes, so that nothing is built anew', () => {
    const copied = copy(three, 'part-2');
    expect(strokesOf(copied.parts[3]!)).toBe(strokesOf(three.parts[1]!));
    expect(solidOf(copied.parts[3]!)!.mesh.indices).toBe(solidOf(three.parts[1]!)!.mesh.indices);
  });

  it('numbers 4,000 copies of one name without counting from the start again', () => {
    const [part] = three.parts;
    const parts = Array.from({ length: 4000 }, (_, i) => ({ ...part!, id: `part-${i + 1}` }));
    const many: Document = { ...three, parts, nextId: 4001 };
    const copied = copy(many, ...parts.map(({ id }) => id));
    expect(new Set(copied.parts.slice(4000).map(({ name }) => name)).size).toBe(4000);
    expect(copied.parts.at(-1)!.name).toMatch(/ 40\d\d$/);
  });

  it('cuts no character in half', () => {
    const named = apply(three, { type: 'renamePart', id: 'part-1', name: `${'x'.repeat(77)}🌷` });
    const { name } = copy(named, 'part-1').parts.at(-1)!;
    expect(name).toBe(`${'x'.repeat(77)} 2`);
  });

  it('numbers names: the first number that is free', () => {
    const named = apply(three, { type: 'renamePart', id: 'part-1', name: 'Stem' });
    const once = copy(named, 'part-1');
    expect(once.parts.at(-1)!.name).toBe('Stem 2');
    expect(copy(once, 'part-4').parts.at(-1)!.name).toBe('Stem 3');
    expect(
      copy(once, 'part-1', 'part-4')
        .parts.slice(4)
        .map(({ name }) => name),
    ).toEqual(['Stem 3', 'Stem 4']);
  });

  it('never makes a name longer than names may be', () => {
    const long = apply(three, { type: 'renamePart', id: 'part-1', name: 'x'.repeat(80) });
    expect(copy(long, 'part-1').parts.at(-1)!.name).toHaveLength(80);
  });

  it('of unknown parts changes nothing', () => {
    expect(copy(three, 'part-9')).toBe(three);
  });
});
