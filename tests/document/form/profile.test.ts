import { expect, test } from 'vitest';
import { profileAt } from '../../../src/document/form/profile.ts';

test('factors at even steps, straight in between, and the same beyond the ends', () => {
  const shape = { profile: [1, 3, 2] };
  expect([0, 0.25, 0.5, 0.75, 1].map((u) => profileAt(shape, u))).toEqual([1, 2, 3, 2.5, 2]);
  expect([profileAt(shape, -1), profileAt(shape, 2)]).toEqual([1, 2]);
});

test('one factor is that everywhere, none is 1', () => {
  expect(profileAt({ profile: [0.5] }, 0.7)).toBe(0.5);
  expect(profileAt({ profile: [] }, 0.7)).toBe(1);
});
