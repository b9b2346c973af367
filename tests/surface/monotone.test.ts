import { describe, expect, test } from 'vitest';
import { ascending } from '../../src/surface/monotone.ts';
import { random } from '../fixtures/random.ts';

describe('an ascending map (seed 7)', () => {
  const next = random(7);
  for (const count of [2, 3, 4, 9]) {
    test(`passes through ${count} places, rises everywhere, and its slope is the derivative`, () => {
      const steps = Array.from({ length: 2 * count }, () => 0.05 + next());
      let [x, y] = [0, 0];
      const places = Array.from({ length: count }, (_, i) => {
        x += steps[i]!;
        y += steps[count + i]!;
        return [x, y] as const;
      });
      const map = ascending(
        places.map(([a]) => a),
        places.map(([, b]) => b),
      );
      for (const [a, b] of places) expect(map.at(a)).toBe(b);
      let before = -Infinity;
      const [from, to] = [places[0]![0] - 0.5, x + 0.5];
      for (let i = 0; i <= 500; i++) {
        const at = from + ((to - from) * i) / 500;
        expect(map.at(at)).toBeGreaterThan(before);
        before = map.at(at);
        const h = 1e-6;
        expect(map.slope(at)).toBeCloseTo((map.at(at + h) - map.at(at - h)) / (2 * h), 4);
      }
    });
  }

  test('through places on a line is that line', () => {
    const map = ascending([0, 1, 3, 4], [2, 2.5, 3.5, 4]);
    for (const x of [-1, 0.3, 1, 2.9, 5]) {
      expect(map.at(x)).toBeCloseTo(2 + x / 2, 14);
      expect(map.slope(x)).toBeCloseTo(0.5, 14);
    }
  });
});
