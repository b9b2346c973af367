import { expect, test } from 'vitest';
import type { Vec2 } from '../../src/math/vec.ts';
import { angle, isSharp, turnAtPoint } from '../../src/stroke/turn.ts';

/** Arms of length 1 with curvature κ that leave the origin along ±x, turned against each other by `jump`. */
function arms(curvature: number, jump: number): readonly [Vec2, Vec2, Vec2, Vec2, Vec2] {
  const along = (s: number): Vec2 => [
    Math.sin(curvature * s) / (curvature || 1) + (curvature === 0 ? s : 0),
    curvature === 0 ? 0 : (1 - Math.cos(curvature * s)) / curvature,
  ];
  const turned = ([x, y]: Vec2): Vec2 => [
    x * Math.cos(jump) - y * Math.sin(jump),
    x * Math.sin(jump) + y * Math.cos(jump),
  ];
  return [along(-1), along(-0.5), [0, 0], turned(along(0.5)), turned(along(1))];
}

test.each([-1, -0.3, 0, 0.2, 0.7])('the jump is told from curvature %f', (curvature) => {
  for (const jump of [-1.2, -0.5, 0, 0.4, 1.5]) {
    const found = turnAtPoint(arms(curvature, jump));
    expect(found.jump).toBeCloseTo(jump, 6);
    expect(found.turn).toBeCloseTo(jump + curvature, 6);
  }
});

test('sharp is far enough and on the spot', () => {
  expect(isSharp(turnAtPoint(arms(0, 1)), 0.87)).toBe(true);
  expect(isSharp(turnAtPoint(arms(0, -1)), 0.87)).toBe(true);
  expect(isSharp(turnAtPoint(arms(0, 0.8)), 0.87)).toBe(false);
  expect(isSharp(turnAtPoint(arms(1.5, 0)), 0.87)).toBe(false);
  expect(angle([1, 0], [0, 1])).toBeCloseTo(Math.PI / 2, 15);
});
