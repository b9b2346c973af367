import { expect, test } from 'vitest';
import { bezierCurve } from '../../src/stroke/bezierCurve.ts';

const flat = () => 0.5;

test('a parabola has the length of the closed form', () => {
  // y = x² from 0 to 1
  const curve = bezierCurve(
    [
      [
        [
          [0, 0],
          [0.5, 0],
          [1, 1],
        ],
      ],
    ],
    false,
    false,
    flat,
  );
  expect(curve.length).toBeCloseTo(Math.sqrt(5) / 2 + Math.asinh(2) / 4, 11);
  const half = curve.point(0.5)[0];
  expect((half * Math.sqrt(1 + 4 * half * half)) / 2 + Math.asinh(2 * half) / 4).toBeCloseTo(
    curve.length / 2,
    11,
  );
});

test('a cubic that stands still inside still moves evenly', () => {
  // x = t³ forwards from a stop
  const curve = bezierCurve(
    [
      [
        [
          [0, 0],
          [0, 0],
          [0, 0],
          [8, 0],
        ],
      ],
    ],
    false,
    false,
    flat,
  );
  for (const u of [0, 1e-6, 0.1, 0.5, 1]) expect(curve.point(u)[0]).toBeCloseTo(8 * u, 9);
  expect(curve.tangent(0)).toEqual([1, 0]);
});

test('u never runs backwards', () => {
  const curve = bezierCurve(
    [
      [
        [
          [0, 0],
          [30, 1],
          [-20, 1],
          [10, 0],
        ],
      ],
    ],
    false,
    false,
    flat,
  );
  let before = 0;
  for (let i = 1; i <= 1000; i++) {
    const [p, q] = [curve.point((i - 1) / 1000), curve.point(i / 1000)];
    before += Math.hypot(q[0] - p[0], q[1] - p[1]);
    expect(Math.hypot(q[0] - p[0], q[1] - p[1])).toBeLessThan((1.001 * curve.length) / 1000);
  }
  expect(before / curve.length).toBeCloseTo(1, 3);
});

test('corners: where pieces meet, and the start of a closed curve unless it is smooth', () => {
  const pieces = [
    [
      [
        [0, 0],
        [3, 0],
      ],
    ],
    [
      [
        [3, 0],
        [3, 4],
      ],
    ],
    [
      [
        [3, 4],
        [0, 0],
      ],
    ],
  ] as const;
  expect(bezierCurve(pieces, false, false, flat).corners).toEqual([3 / 12, 7 / 12]);
  expect(bezierCurve(pieces, true, false, flat).corners).toEqual([0, 3 / 12, 7 / 12]);
  expect(bezierCurve(pieces, true, true, flat).corners).toEqual([3 / 12, 7 / 12]);
  const triangle = bezierCurve(pieces, true, false, flat);
  expect(triangle.tangent(0, 1)).toEqual([1, 0]);
  expect(triangle.tangent(0, -1)).toEqual([-0.6, -0.8]);
  expect(triangle.tangent(1, -1)).toEqual([-0.6, -0.8]);
});
