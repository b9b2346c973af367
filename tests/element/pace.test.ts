/** How many rays fit into some milliseconds: by what they took, slower at once, faster by and by. */
import { describe, expect, it } from 'vitest';
import { Pace } from '../../src/element/pace.ts';

/** Bands of 8 ms, one after the other, on a device of so many rays a ms, each of whose answers takes `way` ms more. Returns the rays of each. */
function bands(pace: Pace, speed: number, way: number, count: number): readonly number[] {
  pace.answered(way);
  return Array.from({ length: count }, () => {
    const rays = pace.rays(8);
    pace.hear(rays, way + rays / speed);
    return rays;
  });
}

describe('Pace', () => {
  for (const [speed, way] of [
    [1e6, 1],
    [1e6, 30],
    [2e4, 20],
    [100, 0.1],
  ] as const)
    it(`grows by steps to what fits, or shrinks: ${speed} rays a ms, ${way} ms there and back`, () => {
      const pace = new Pace();
      expect(pace.milliseconds(1e6)).toBeNull();
      const all = bands(pace, speed, way, 60);
      expect(all[0]).toBeLessThan(1e5);
      for (const [i, rays] of all.entries())
        if (i > 0) expect(rays).toBeLessThanOrEqual(4 * Math.max(all[i - 1]!, all[0]!));
      const took = all.at(-1)! / speed;
      expect(took).toBeCloseTo(8, 1);
      expect(pace.milliseconds(speed)).toBeCloseTo(1, 2);
    });

  it('a way that took long once was no way; and rays take a share of any answer', () => {
    const pace = new Pace();
    for (const way of [2, 100]) pace.answered(way);
    for (let i = 0; i < 20; i++) pace.answered(2);
    pace.hear(1000, 12);
    expect(pace.milliseconds(1000)).toBeCloseTo(10, 9);
    const other = new Pace();
    other.answered(100);
    other.hear(1000, 50);
    expect(other.milliseconds(1000)).toBeGreaterThan(5);
  });

  it('believes at once what takes longer, and by and by what is faster; nothing is learned of no rays', () => {
    const pace = new Pace();
    pace.answered(1);
    pace.hear(1000, 2);
    pace.hear(1000, 10);
    const slow = pace.milliseconds(1000)!;
    expect(slow).toBeCloseTo(9, 9);
    pace.hear(0, 50);
    expect(pace.milliseconds(1000)).toBe(slow);
    pace.hear(1000, 2);
    expect(pace.milliseconds(1000)).toBeGreaterThan(slow / 2);
    for (let i = 0; i < 20; i++) pace.hear(1000, 2);
    expect(pace.milliseconds(1000)).toBeCloseTo(1, 2);
  });
});
