/** What was asked for lately: one of each name, and no more than there is room for. */
import { expect, test } from 'vitest';
import { Lately } from '../../src/worker/lately.ts';

const size = (value: number): number => value;

test('the one asked for last comes last, and is the only one of its name', () => {
  const kept = new Lately<number>();
  for (const [i, name] of ['a', 'b', 'a', 'c'].entries()) kept.put(name, i);
  expect(kept.names).toEqual(['b', 'a', 'c']);
  expect(['a', 'b', 'c', 'd'].map((name) => kept.known(name))).toEqual([2, 1, 3, null]);
  kept.drop('a');
  expect(kept.names).toEqual(['b', 'c']);
});

test('what was not asked for longest goes first, and what is spared neither goes nor counts', () => {
  const kept = new Lately<number>();
  for (const name of ['a', 'b', 'c', 'd']) kept.put(name, 10);
  kept.trim(100, size, ['a']);
  expect(kept.names).toEqual(['a', 'b', 'c', 'd']);
  kept.trim(25, size, ['a']);
  expect(kept.names).toEqual(['a', 'c', 'd']);
  kept.trim(5, size);
  expect(kept.names).toEqual([]);
});
