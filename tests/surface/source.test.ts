import { expect, test } from 'vitest';
import { alongOf } from '../../src/surface/along.ts';
import { sourceOf } from '../../src/surface/source.ts';
import { line } from './curves.ts';

const curves = [line([-1, 0], [-1, 5]), line([1, 0], [1, 5])];
const brush = { radius: 1, pressure: false };

test('sources are found again by their curves, and by nothing else', () => {
  const first = sourceOf({ ...brush, curves });
  expect(sourceOf({ ...brush, curves: [...curves] })).toBe(first);
  expect(sourceOf({ ...brush, curves: [...curves].reverse() })).not.toBe(first);
  expect(sourceOf({ ...brush, curves: curves.slice(0, 1) })).not.toBe(first);
  expect(sourceOf({ ...brush, radius: 2, curves })).not.toBe(first);
  expect(() => sourceOf({ ...brush, curves: [...curves, curves[0]!] })).toThrow(RangeError);
  expect(() => sourceOf({ ...brush, curves: [] })).toThrow(RangeError);
});

test('rows along them are found again by the places of sections', () => {
  const source = sourceOf({ ...brush, curves });
  const along = alongOf(source, [0.3, 0.7], null);
  expect(alongOf(source, [0.3, 0.7], null)).toBe(along);
  expect(alongOf(source, [0.3, 0.6], null)).not.toBe(along);
  expect(alongOf(source, [0.3, 0.6], 40)).not.toBe(along);
});
