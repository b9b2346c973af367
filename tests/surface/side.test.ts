import { describe, expect, test } from 'vitest';
import { length2, sub2 } from '../../src/math/tuple.ts';
import { openSide, type Side } from '../../src/surface/side.ts';
import { circle, halfCircle, line, polygon } from './curves.ts';

/** Derivatives against central differences, away from corners. */
function expectDerivatives(side: Side): void {
  for (const u of [0.013, 0.21, 0.43, 0.77, 0.99]) {
    const [a, b] = [side.point(u - 1e-5), side.point(u + 1e-5)];
    const difference = [(b[0] - a[0]) / 2e-5, (b[1] - a[1]) / 2e-5] as const;
    for (const way of [-1, 1] as const) {
      expect(length2(sub2(side.derivative(u, way), difference))).toBeLessThan(1e-4 * side.length);
    }
  }
}

describe('sides', () => {
  test('have derivatives that fit their points, in both directions and from any start', () => {
    for (const curve of [
      halfCircle(30, 1),
      line([0, 0], [10, 0], [10, 30]),
      circle(1, 2, 20, -1),
      polygon([0, 0], [9, 0], [0, 9]),
    ]) {
      for (const reversed of [false, true]) expectDerivatives(openSide(curve, { start: 0.37, reversed }));
    }
  });

  test('a reversed open stroke begins at its end', () => {
    const side = openSide(line([0, 0], [10, 0], [10, 30]), { start: 0, reversed: true });
    expect(side.point(0)).toEqual([10, 30]);
    expect(side.corners[0]).toBeCloseTo(0.75, 12);
    expect(side.derivative(side.corners[0]!, -1)).toEqual([-0, -40]);
    expect(side.derivative(side.corners[0]!, 1)).toEqual([-40, -0]);
  });

  test('a closed stroke opened at a corner has it at both ends', () => {
    const square = polygon([0, 0], [10, 0], [10, 10], [0, 10]);
    for (const reversed of [false, true]) {
      const side = openSide(square, { start: 0.5, reversed });
      expect(side.point(0)).toEqual([10, 10]);
      expect(side.corners.map((u) => Math.round(u * 1e9) / 1e9)).toEqual([0, 0.25, 0.5, 0.75]);
      expect(length2(sub2(side.derivative(0, 1), reversed ? [0, -40] : [-40, 0]))).toBeLessThan(1e-9);
      expect(length2(sub2(side.derivative(1, -1), reversed ? [40, 0] : [0, 40]))).toBeLessThan(1e-9);
    }
  });
});
