/** How many rays fit into some milliseconds: by what they took, slower at once, faster by and by. */
import { describe, expect, it } from 'vitest';
import { Pace } from '../../src/element/pace.ts';

describe('Pace', () => {
  it('begins with few, and grows by steps to what fits', () => {
    const pace = new Pace();
    expect(pace.milliseconds(1e6)).toBeNull();
    let rays = pace.rays(8);
    expect(rays).toBeLessThan(1e5);
    // a device of 1e6 rays a ms, each of whose answers takes a ms more
    for (let band = 0; band < 20; band++) {
      const before = rays;
      pace.hear(rays, 1 + rays / 1e6);
      rays = pace.rays(8);
      expect(rays).toBeLessThanOrEqual(4 * before);
    }
    expect(1 + rays / 1e6).toBeGreaterThan(6);
    expect(1 + rays / 1e6).toBeLessThan(8.5);
  });

  it('believes at once what takes longer, and by and by what is faster; nothing is learned of no rays', () => {
    const pace = new Pace();
    pace.hear(1000, 1);
    pace.hear(1000, 10);
    expect(pace.milliseconds(1000)).toBeCloseTo(10, 9);
    pace.hear(0, 50);
    expect(pace.milliseconds(1000)).toBeCloseTo(10, 9);
    pace.hear(1000, 1);
    expect(pace.milliseconds(1000)).toBeGreaterThan(5);
    for (let i = 0; i < 20; i++) pace.hear(1000, 1);
    expect(pace.milliseconds(1000)).toBeCloseTo(1, 2);
  });
});
