import { describe, expect, it } from 'vitest';
import {
  compose,
  isUnmoved,
  type Placement,
  place3,
  shortestTurn,
  turnAbout,
  UNMOVED,
} from '../../src/math/placement.ts';
import { length3, sub3 } from '../../src/math/tuple.ts';
import type { Quat, Vec3 } from '../../src/math/vec.ts';
import { random } from '../fixtures/random.ts';

const next = random(31);
const number = () => 2 * next() - 1;
const vector = (): Vec3 => [number(), number(), number()];
const turn = (): Quat => {
  const q = [number(), number(), number(), number()] as const;
  const length = Math.hypot(...q);
  return q.map((value) => value / length) as unknown as Quat;
};
const places = Array.from({ length: 50 }, (): Placement => ({ rotation: turn(), translation: vector() }));
const apart = (a: Vec3, b: Vec3) => length3(sub3(a, b));

describe('placement (seed 31)', () => {
  it('composes: first the inner, then the outer', () => {
    for (const [i, outer] of places.entries()) {
      const inner = places[(i + 7) % places.length]!;
      const p = vector();
      expect(apart(place3(compose(outer, inner), p), place3(outer, place3(inner, p)))).toBeLessThan(1e-14);
    }
  });

  it('keeps distances', () => {
    for (const placement of places) {
      const [p, q] = [vector(), vector()];
      expect(apart(place3(placement, p), place3(placement, q))).toBeCloseTo(apart(p, q), 13);
    }
  });

  it('turns about a point that stays', () => {
    for (const { rotation, translation } of places) {
      expect(apart(place3(turnAbout(translation, rotation), translation), translation)).toBeLessThan(1e-14);
    }
  });

  it('finds the turn from one direction to another, opposite ones too', () => {
    for (const { translation } of places) {
      const from: Vec3 = [1, 0, 0];
      const length = length3(translation);
      const to = translation.map((value) => value / length) as unknown as Vec3;
      const placement = (rotation: Quat): Placement => ({ rotation, translation: [0, 0, 0] });
      expect(apart(place3(placement(shortestTurn(from, to)), from), to)).toBeLessThan(1e-14);
      const back: Vec3 = [-to[0], -to[1], -to[2]];
      expect(apart(place3(placement(shortestTurn(to, back)), to), back)).toBeLessThan(1e-14);
    }
  });

  it('knows what leaves everything where it is, by its numbers', () => {
    expect(isUnmoved(UNMOVED)).toBe(true);
    expect(isUnmoved({ rotation: [-0, 0, 0, -1], translation: [0, -0, 0] })).toBe(true);
    expect(isUnmoved({ rotation: [1e-9, 0, 0, 1], translation: [0, 0, 0] })).toBe(false);
    expect(isUnmoved({ rotation: [0, 0, 0, 1], translation: [0, 1e-300, 0] })).toBe(false);
  });
});
