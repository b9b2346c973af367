import { describe, expect, test } from 'vitest';
import { length3, sub3 } from '../../src/math/tuple.ts';
import type { Vec3 } from '../../src/math/vec.ts';
import { sideView, within } from '../../src/surface/sideView.ts';
import { FLAT, TILTED } from './curves.ts';

describe('side views', () => {
  test('there and back', () => {
    const view = sideView(TILTED);
    const v: Vec3 = [3, -1, 2];
    expect(length3(sub3(view.out(view.into(v)), v))).toBeLessThan(1e-12);
    expect(view.point(TILTED.origin)).toEqual([0, 0]);
  });

  test('a plane in its own coordinates is the flat one; places keep their coordinates on it', () => {
    const own = within(TILTED, TILTED);
    for (const key of ['origin', 'x', 'y'] as const)
      expect(length3(sub3(own[key], FLAT[key]))).toBeLessThan(1e-12);
  });
});
