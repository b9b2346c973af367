import { expect, test } from 'vitest';
import { factorAt, pointsOf, yOf } from '../../src/element/profileEditor.ts';

test.each([0.25, 0.5, 1, 1.6, 4])('a factor of %d is where it is read off', (factor) => {
  expect(factorAt(yOf(factor))).toBeCloseTo(factor, 2);
});

test('what is beyond the picture stays in it, and 1 is easy to meet', () => {
  expect([factorAt(-1000), factorAt(1000)]).toEqual([4, 0.25]);
  expect(yOf(0.001)).toBe(yOf(0.25));
  expect(factorAt(yOf(1.03))).toBe(1);
});

test('a plain profile has five points, a longer one its own', () => {
  expect(pointsOf([2])).toEqual([2, 2, 2, 2, 2]);
  expect(pointsOf([1, 2])).toEqual([1, 1.25, 1.5, 1.75, 2]);
  const own = [1, 2, 1, 2, 1, 2, 1];
  expect(pointsOf(own)).toBe(own);
});
