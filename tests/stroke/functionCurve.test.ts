import { expect, test } from 'vitest';
import { functionCurve } from '../../src/stroke/functionCurve.ts';
import { ellipse } from '../fixtures/shapes.ts';

test('a circle: its length, points and tangents', () => {
  const circle = functionCurve(ellipse(10, 10), true);
  expect(circle.length).toBeCloseTo(20 * Math.PI, 9);
  for (const u of [0, 0.1, 0.25, 0.6, 1, -0.4, 3.2]) {
    const a = 2 * Math.PI * u;
    expect(circle.point(u)[0]).toBeCloseTo(10 * Math.cos(a), 6);
    expect(circle.point(u)[1]).toBeCloseTo(10 * Math.sin(a), 6);
    expect(circle.tangent(u)[0]).toBeCloseTo(-Math.sin(a), 6);
    expect(circle.tangent(u)[1]).toBeCloseTo(Math.cos(a), 6);
  }
});

test('an uneven parameter becomes even; open ends clamp, their tangents are one-sided', () => {
  const uneven = functionCurve((t) => [10 * t * t * t, 0], false);
  expect(uneven.length).toBeCloseTo(10, 9);
  for (const u of [0, 0.1, 0.5, 1]) expect(uneven.point(u)[0]).toBeCloseTo(10 * u, 5);
  expect(uneven.point(2)).toEqual(uneven.point(1));
  expect(uneven.tangent(1)[0]).toBe(1);
  const parabola = functionCurve((t) => [t, t * t], false);
  expect(parabola.tangent(0)[1]).toBeCloseTo(0, 9);
  expect(parabola.tangent(1)[1]).toBeCloseTo(2 / Math.sqrt(5), 9);
});

test('equal steps of u on an ellipse are equal lengths, to 2e-4 of a step', () => {
  const curve = functionCurve(ellipse(50, 20), true);
  const chords = Array.from({ length: 2000 }, (_, i) => {
    const [p, q] = [curve.point(i / 2000), curve.point((i + 1) / 2000)];
    return Math.hypot(q[0] - p[0], q[1] - p[1]);
  });
  expect(Math.max(...chords) / Math.min(...chords)).toBeCloseTo(1, 3);
});
