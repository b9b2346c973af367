/** What a hand or a command does stays within what a file may hold: whatever is drawn can be saved and read again. */
import { describe, expect, it } from 'vitest';
import { apply, type Command } from '../../src/document/command/index.ts';
import { LONGEST_NAME } from '../../src/document/command/renamePart.ts';
import { EMPTY_DOCUMENT } from '../../src/document/document.ts';
import { parse, replay, serialize } from '../../src/document/serialize.ts';
import { FARTHEST } from '../../src/stroke/stroke.ts';
import { Driver } from '../tool/driver.ts';
import { drawingOf } from './files.ts';
import { line } from './strokes.ts';

const kept = replay([{ type: 'addStroke', stroke: line(0) }, { type: 'keep' }]);
const readAgain = (document: typeof kept) => parse(serialize(drawingOf(document)), 'x.rotund').document;

describe('the space there is', () => {
  it.each<Command>([
    {
      type: 'moveParts',
      ids: ['part-1'],
      by: { rotation: [0, 0, 0, 1], translation: [0.6 * FARTHEST, 0, 0] },
    },
    { type: 'duplicateParts', ids: ['part-1'], offset: [0, 0, -0.6 * FARTHEST] },
  ])('is not left by $type', (command) => {
    const once = apply(kept, command);
    expect(once).not.toBe(kept);
    const often = Array.from({ length: 4 }).reduce<typeof kept>((document) => apply(document, command), once);
    expect(readAgain(often)).toEqual(often);
  });

  it('is not left by the pen, however far away one looks', () => {
    const driver = new Driver();
    driver.view = { ...driver.view, height: 8 * FARTHEST };
    driver.draw([
      [400, 300],
      [400, 100],
    ]);
    const { samples } = driver.document.draft!.strokes[0]!;
    expect(samples.length).toBeGreaterThan(2);
    expect(readAgain(driver.document)).toEqual(driver.document);
  });

  it('has no plane outside for the pen', () => {
    const driver = new Driver();
    driver.view = { ...driver.view, pivot: [2 * FARTHEST, 0, 0] };
    driver.draw([
      [400, 300],
      [400, 100],
    ]);
    expect(driver.document).toBe(EMPTY_DOCUMENT);
  });
});

describe('a long name', () => {
  it.each(['n'.repeat(200), '🍐'.repeat(200), `x${'🍐'.repeat(200)}`, `${'n'.repeat(79)} n`])(
    '%s',
    (name) => {
      const renamed = apply(kept, { type: 'renamePart', id: 'part-1', name });
      const cut = renamed.parts[0]!.name;
      expect(cut.length).toBeLessThanOrEqual(LONGEST_NAME);
      expect(cut.length).toBeGreaterThanOrEqual(LONGEST_NAME - 1);
      expect(name.startsWith(cut)).toBe(true);
      expect(cut).not.toMatch(/[\p{Cs}\s]$/u);
      expect(readAgain(renamed)).toEqual(renamed);
    },
  );
});
