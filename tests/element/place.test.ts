/** The chip lies clear of the form where there is room, and never over the tools. */
import { describe, expect, it } from 'vitest';
import { chipPlace, type Rect } from '../../src/element/place.ts';

const CHIP = { width: 686, narrow: 304, height: 104, narrowHeight: 156, beside: 60 };
const SIZE = { width: 900, height: 700 };
/** tall: no room above it or below it */
const tall = (left: number, right: number): Rect => ({ left, right, top: 165, bottom: 590 });

const boxOf = (form: Rect, size = SIZE) => {
  const { x, y, narrow } = chipPlace(form, size, CHIP);
  const [width, height] = narrow ? [CHIP.narrow, CHIP.narrowHeight] : [CHIP.width, CHIP.height];
  return { left: x - width / 2, right: x + width / 2, top: y, bottom: y + height };
};

describe('the chip', () => {
  it.each([
    ['in the middle', tall(366, 550), SIZE],
    ['in the middle, beside a panel', tall(366, 550), { width: 564, height: 700 }],
    ['on the right', tall(600, 800), SIZE],
    ['all over', tall(100, 880), SIZE],
  ])('is right of the tools and above the meter: form %s', (_, form, size) => {
    const box = boxOf(form, size);
    expect(box.left).toBeGreaterThanOrEqual(84);
    expect(box.bottom).toBeLessThanOrEqual(size.height - 92);
  });

  it.each([
    ['a panel', { width: 564, height: 700 }],
    ['the edge', SIZE],
  ])(
    'covers less than a quarter of the width of a tall form where there is a little too little room before %s',
    (_, size) => {
      const form = tall(366, 550);
      const { left, right } = boxOf(form, size);
      const over = Math.min(right, form.right) - Math.max(left, form.left);
      expect(over).toBeLessThan((form.right - form.left) / 4);
      expect(right).toBeLessThanOrEqual(size.width - 16);
    },
  );
});
