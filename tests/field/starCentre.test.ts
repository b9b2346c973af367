import { describe, expect, test } from 'vitest';
import { starCentre } from '../../src/field/starCentre.ts';
import type { Vec2 } from '../../src/math/vec.ts';

const rectangle: Vec2[] = [
  [1, 1],
  [5, 1],
  [5, 3],
  [1, 3],
];
/** its corner region sees all, its centroid (1.6, 1.6) does not lie in it */
const angle: Vec2[] = [
  [0, 0],
  [6, 0],
  [6, 1],
  [1, 1],
  [1, 6],
  [0, 6],
];
const horseshoe: Vec2[] = [
  [0, 0],
  [6, 0],
  [6, 6],
  [5, 6],
  [5, 1],
  [1, 1],
  [1, 6],
  [0, 6],
];

describe('the centre of a profile', () => {
  test('is the centroid where that sees all, for both orientations', () => {
    for (const loop of [rectangle, [...rectangle].reverse()]) {
      const { at, seesAll } = starCentre(loop);
      expect(at[0]).toBeCloseTo(3, 14);
      expect(at[1]).toBeCloseTo(2, 14);
      expect(seesAll).toBe(true);
    }
  });

  test('else a point of the kernel', () => {
    const { at, seesAll } = starCentre(angle);
    expect(seesAll).toBe(true);
    expect(at.every((x) => x > 0 && x < 1)).toBe(true);
  });

  test('else it says that parts are hidden, and lies inside', () => {
    const { at, seesAll } = starCentre(horseshoe);
    expect(seesAll).toBe(false);
    expect(at[1] < 1 || at[0] < 1 || at[0] > 5).toBe(true);
  });

  test('a loop without area is refused', () => {
    expect(() =>
      starCentre([
        [0, 0],
        [1, 1],
      ]),
    ).toThrow(/loop with an area/);
    expect(() =>
      starCentre([
        [0, 0],
        [1, 1],
        [2, 2],
      ]),
    ).toThrow(/loop with an area/);
  });
});
