import { expect, test } from 'vitest';
import { kept } from '../../src/surface/keptSpine.ts';
import type { Spine } from '../../src/surface/sheet.ts';
import { arc, spineOf } from './sheets.ts';

function counted(): { readonly spine: Spine; readonly asked: () => number } {
  const { closed, stops, at } = spineOf(arc(0, 2));
  let count = 0;
  const spine: Spine = {
    closed,
    stops,
    at: (u, side) => {
      count++;
      return at(u, side);
    },
  };
  return { spine, asked: () => count };
}

test('a station is asked for once, of each side', () => {
  const { spine, asked } = counted();
  for (const u of [0, 0.3, 0.3, 1, 0.3, 0]) expect(kept(spine).at(u, 1)).toEqual(spineOf(arc(0, 2)).at(u, 1));
  expect(asked()).toBe(3);
  kept(spine).at(0.3, -1);
  expect(asked()).toBe(4);
});

test('keeping what is kept changes nothing', () => {
  const { spine } = counted();
  expect(kept(kept(spine))).toBe(kept(spine));
});

test('what is forgotten is asked for again', () => {
  const { spine, asked } = counted();
  const places = Array.from({ length: 40_000 }, (_, i) => i / 40_000);
  for (const u of places) kept(spine).at(u, 1);
  expect(kept(spine).at(places[0]!, 1)).toEqual(spineOf(arc(0, 2)).at(places[0]!, 1));
  expect(asked()).toBe(places.length + 1);
});
