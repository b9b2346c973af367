import { describe, expect, test } from 'vitest';
import { slope } from '../../src/surface/slope.ts';

describe('slopes', () => {
  test('exact for quartics, inside and at breaks', () => {
    const f = (u: number): number => 3 * u ** 4 - u ** 3 + 2 * u - 5;
    const df = (u: number): number => 12 * u ** 3 - 3 * u ** 2 + 2;
    for (const u of [0, 1e-4, 0.3, 0.5, 0.7771, 1]) {
      expect(slope(f, u, u === 1 ? -1 : 1, [0, 0.5, 1])).toBeCloseTo(df(u), 9);
    }
  });

  test('looks at one side of a break only', () => {
    const f = (u: number, side: -1 | 1): number =>
      u < 0.5 || (u === 0.5 && side === -1) ? 2 * u : 7 - 3 * u;
    expect(slope(f, 0.5, -1, [0, 0.5, 1])).toBeCloseTo(2, 9);
    expect(slope(f, 0.5, 1, [0, 0.5, 1])).toBeCloseTo(-3, 9);
    expect(slope(f, 0.4995, 1, [0, 0.5, 1])).toBeCloseTo(2, 9);
  });

  test('jumps by a period do not count', () => {
    const f = (u: number): number => 40 * u - 3 * Math.floor((40 * u) / 3);
    for (const u of [0.3, 0.1503, 0.98]) expect(slope(f, u, 1, [0, 1], 3)).toBeCloseTo(40, 8);
  });

  test('nor where it is steep: up to half a period in two steps', () => {
    const f = (u: number): number => 700 * u - 3 * Math.floor((700 * u) / 3);
    for (const u of [0.3, 0.1503, 0.98]) expect(slope(f, u, 1, [0, 1], 3)).toBeCloseTo(700, 6);
  });
});
