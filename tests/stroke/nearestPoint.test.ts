import { describe, expect, test } from 'vitest';
import { functionCurve, polylineCurve } from '../../src/stroke/arcLength.ts';
import { nearestParameter } from '../../src/stroke/nearestPoint.ts';

describe('nearest parameter', () => {
  const ring = functionCurve((t) => [Math.cos(2 * Math.PI * t), Math.sin(2 * Math.PI * t)], true);
  test('on a circle it is the angle, over the seam too', () => {
    for (const t of [0.1, 0.43, 0.77, 0.999, 0.001]) {
      const place = [3 * Math.cos(2 * Math.PI * t), 3 * Math.sin(2 * Math.PI * t)] as const;
      expect(nearestParameter(ring.point, ring.tangent, place, true)).toBeCloseTo(t, 6);
    }
  });

  test('on a line it is the foot, or an end; on a corner the corner', () => {
    const elbow = polylineCurve(
      [
        [0, 0],
        [10, 0],
        [10, 10],
      ],
      false,
    );
    const at = (x: number, y: number): number => nearestParameter(elbow.point, elbow.tangent, [x, y], false);
    expect(at(4, -2)).toBeCloseTo(0.2, 12);
    expect(at(-3, 5)).toBe(0);
    expect(at(9, 40)).toBe(1);
    expect(at(13, -4)).toBeCloseTo(0.5, 12);
    expect(at(Number.NaN, 0)).toBe(0);
  });
});
