import { describe, expect, test } from 'vitest';
import {
  add3,
  cross2,
  cross3,
  dot3,
  length2,
  length3,
  mix2,
  rotate3,
  unrotate3,
} from '../../src/math/tuple.ts';
import { type Quat, quat, type Vec3, vec3 } from '../../src/math/vec.ts';
import { normal } from '../fixtures/random.ts';

describe('tuple', () => {
  test('turning by a quaternion agrees with gl-matrix, keeps lengths and is undone (seed 3)', () => {
    const n = normal(3);
    for (let i = 0; i < 200; i++) {
      const q = quat.normalize([0, 0, 0, 1], [n(), n(), n(), n()]) as unknown as Quat;
      const v: Vec3 = [n(), n(), n()];
      const turned = rotate3(q, v);
      const theirs = vec3.transformQuat([0, 0, 0], [...v], [...q]);
      for (let k = 0; k < 3; k++) expect(turned[k]).toBeCloseTo(theirs[k]!, 12);
      expect(length3(turned)).toBeCloseTo(length3(v), 12);
      for (let k = 0; k < 3; k++) expect(unrotate3(q, turned)[k]).toBeCloseTo(v[k]!, 12);
    }
  });

  test('cross products stand upright and follow the right hand', () => {
    expect(cross3([1, 0, 0], [0, 1, 0])).toEqual([0, 0, 1]);
    expect(dot3(cross3([1, 2, 3], [4, 5, 6]), add3([1, 2, 3], [4, 5, 6]))).toBe(0);
    expect(cross2([1, 0], [0, 1])).toBe(1);
    expect(length2([3, 4])).toBe(5);
  });

  test('mix2 meets both ends exactly', () => {
    expect(mix2([0.1, 1e17], [0.3, 1], 0)).toEqual([0.1, 1e17]);
    expect(mix2([0.1, 1e17], [0.3, 1], 1)).toEqual([0.3, 1]);
  });
});
