import { expect, test } from 'vitest';
import { MARK_WORDS } from '../../src/element/words.ts';

test('a radius is told in the tenths that it is set in', () => {
  expect(MARK_WORDS.value(0.5, 'mm')).toBe('0.5 mm');
  expect(MARK_WORDS.value(12, 'mm')).toBe('12 mm');
  expect(MARK_WORDS.value(57.6, '%')).toBe('58 %');
});
