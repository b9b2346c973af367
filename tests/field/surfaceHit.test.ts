/** From close to a surface along a ray onto it: against spheres, whose hits are known. */
import { describe, expect, it } from 'vitest';
import { surfaceHit } from '../../src/field/surfaceHit.ts';
import { length3, scale3 } from '../../src/math/tuple.ts';
import type { Vec3 } from '../../src/math/vec.ts';
import { bindShape } from '../../src/shape/index.ts';

const RADIUS = 5;
const ball = bindShape({ type: 'sphere', radius: RADIUS });
const along: Vec3 = [0, 0, -1];

describe('surfaceHit', () => {
  it.each([0, 0.3, -0.4, 0.999])('finds the front of a ball from %d mm before it', (off) => {
    for (const x of [0, 2, 4.9]) {
      const z = Math.sqrt(RADIUS ** 2 - x ** 2);
      const hit = surfaceHit(ball, [x, 0, z + off], along, 1)!;
      expect(hit.point[0]).toBe(x);
      expect(hit.point[2]).toBeCloseTo(z, 9);
      const outward = scale3(hit.point, 1 / length3(hit.point));
      for (let axis = 0; axis < 3; axis++) expect(hit.normal[axis]).toBeCloseTo(outward[axis]!, 9);
    }
  });

  it('finds nothing beyond its reach, and where the ray passes by', () => {
    expect(surfaceHit(ball, [0, 0, 8], along, 1)).toBeNull();
    expect(surfaceHit(ball, [5.5, 0, 0], along, 1)).toBeNull();
  });
});
