import { expect, test } from 'vitest';
import { Slab } from '../../src/math/slab.ts';

test('short arrays are zeros of their own, also beyond one slab', () => {
  const slab = new Slab();
  const arrays = Array.from({ length: 2000 }, (_, i) => {
    const made = slab.take(1 + (i % 13));
    expect([...made]).toEqual(Array.from({ length: 1 + (i % 13) }, () => 0));
    return made.fill(i);
  });
  arrays.forEach((array, i) => {
    expect(array.every((x) => x === i)).toBe(true);
  });
});
