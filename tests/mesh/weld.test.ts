import fc from 'fast-check';
import { describe, expect, test } from 'vitest';
import { weld } from '../../src/mesh/weld.ts';

describe('weld', () => {
  test('same places get the same id, in the order of first appearance', () => {
    const { ids, count } = weld(Float32Array.from([1, 2, 3, 0, 0, 0, 1, 2, 3, -0, 0, -0]));
    expect([...ids]).toEqual([0, 1, 0, 1]);
    expect(count).toBe(2);
  });

  test('agrees with a map of strings on crowded grids (seed 7)', () => {
    const points = fc.array(fc.integer({ min: -3, max: 3 }), { minLength: 0, maxLength: 300 });
    fc.assert(
      fc.property(points, (numbers) => {
        const positions = Float32Array.from(numbers.slice(0, numbers.length - (numbers.length % 3)));
        const seen = new Map<string, number>();
        const { ids, count } = weld(positions);
        ids.forEach((id, i) => {
          const key = [...positions.subarray(3 * i, 3 * i + 3)].map((x) => x + 0).join();
          if (!seen.has(key)) seen.set(key, seen.size);
          expect(id).toBe(seen.get(key));
        });
        expect(count).toBe(seen.size);
      }),
      { seed: 7 },
    );
  });

  test('no float next to another is taken for it', () => {
    const positions = Float32Array.from([1, 1, 1, 1 + 2 ** -23, 1, 1]);
    expect(weld(positions).count).toBe(2);
  });
});
