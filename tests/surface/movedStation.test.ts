import { expect, test } from 'vitest';
import { cross3, dot3, length3, scale3, sub3 } from '../../src/math/tuple.ts';
import { bezierCurve } from '../../src/stroke/bezierCurve.ts';
import { deform } from '../../src/surface/deform.ts';
import { ellipses, evenly, slope3, wavy } from './sheets.ts';

const sheet = ellipses(wavy(8, 1), () => 5, evenly(8), evenly(4));
const { spine } = deform(sheet, {
  curve: bezierCurve(
    [
      [
        [
          [0, 0],
          [40, 30],
          [30, 70],
          [-10, 100],
        ],
      ],
    ],
    false,
    false,
    () => 0.5,
  ),
  plane: { origin: [0, 0, 0], x: [0.6, 0, -0.8], y: [0, 1, 0] },
  keepsLength: true,
});

test('rate and spin of a bent spine are the derivatives of its centre and its normal', () => {
  for (const u of [0.1, 0.33, 0.5, 0.78]) {
    const { rate, normal, spin } = spine.at(u, 1);
    const moved = slope3((x) => spine.at(x, 1).centre, u);
    expect(length3(sub3(moved, rate))).toBeLessThan(1e-6 * length3(rate));
    expect(Math.abs(dot3(normal, normal) - 1)).toBeLessThan(1e-12);
    const turned = slope3((x) => spine.at(x, 1).normal, u);
    expect(length3(sub3(turned, cross3(spin, normal)))).toBeLessThan(1e-5 * (1 + length3(turned)));
    // a turn about the normal moves nothing, and is left out
    expect(length3(scale3(normal, dot3(spin, normal)))).toBeLessThan(1e-9 * (1 + length3(spin)));
  }
});
