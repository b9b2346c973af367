import { describe, expect, it } from 'vitest';
import { EMPTY_DOCUMENT } from '../../src/document/document.ts';
import { FileError, replay } from '../../src/document/serialize.ts';
import { checkedCommands, checkedIds } from '../../src/element/check.ts';
import { strokeOf } from '../../src/element/strokeInput.ts';

const line = (x: number) => ({
  type: 'addStroke',
  stroke: strokeOf({ points: Array.from({ length: 9 }, (_, i) => [x, 5 * i] as const) }, EMPTY_DOCUMENT),
});

const placeOf = (attempt: () => unknown): string => {
  try {
    attempt();
  } catch (error) {
    if (error instanceof FileError) return `${error.file} ${error.place}`.trim();
    throw error;
  }
  return 'accepted';
};

describe('commands from a page', () => {
  it('are taken alone or as a list, each on the document that the ones before leave', () => {
    const list = [line(-10), line(10), { type: 'keep' }, { type: 'removeParts', ids: ['part-1'] }];
    expect(replay(checkedCommands(list, EMPTY_DOCUMENT)).parts).toEqual([]);
    expect(checkedCommands({ type: 'keep' }, EMPTY_DOCUMENT)).toEqual([{ type: 'keep' }]);
    expect(checkedCommands([], EMPTY_DOCUMENT)).toEqual([]);
  });

  it('are refused with the place', () => {
    const bad = (value: unknown) => placeOf(() => checkedCommands(value, EMPTY_DOCUMENT));
    expect(bad({ type: 'explode' })).toBe('commands [0].type');
    expect(bad([{ type: 'keep' }, { type: 'explode' }])).toBe('commands [1].type');
    expect(bad([{ type: 'removeParts', ids: ['part-7'] }])).toBe('commands [0].ids[0]');
    for (const value of [undefined, null, 'keep', 7, [[]], () => {}]) expect(bad(value)).toMatch(/^commands/);
  });
});

describe('ids from a page', () => {
  it('are a list of texts', () => {
    expect(checkedIds(['part-1', 'none'])).toEqual(['part-1', 'none']);
    for (const value of ['part-1', [1], null, undefined, {}])
      expect(placeOf(() => checkedIds(value))).toBe('selection');
  });
});
