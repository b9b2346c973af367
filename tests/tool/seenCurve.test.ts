/** The nearest place on a curve that is seen, and that curves are looked at once a view. */
import { expect, test, vi } from 'vitest';
import type { Vec2 } from '../../src/math/vec.ts';
import { nearestOn, rememberedBy } from '../../src/tool/seenCurve.ts';

const bow = Array.from({ length: 65 }, (_, i): Vec2 => [i, 20 * Math.sin((Math.PI * i) / 64)]);

test('the nearest place is no further than a thousand others, and lies where it says', () => {
  for (const at of [
    [10, 3],
    [40, 60],
    [-5, -5],
    [64, 0],
  ] as const) {
    const { u, distance } = nearestOn(bow, at);
    const place = (v: number): Vec2 => {
      const i = Math.min(63, Math.floor(64 * v));
      const t = 64 * v - i;
      const [a, b] = [bow[i]!, bow[i + 1]!];
      return [a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1])];
    };
    const off = (v: number) => Math.hypot(place(v)[0] - at[0], place(v)[1] - at[1]);
    expect(off(u)).toBeCloseTo(distance, 9);
    for (let k = 0; k <= 1000; k++) expect(distance).toBeLessThanOrEqual(off(k / 1000) + 1e-9);
  }
});

test('what is behind the camera is not near', () => {
  expect(nearestOn([null, null, null], [0, 0]).distance).toBe(Infinity);
  expect(nearestOn([[0, 0], null, [2, 0], [3, 0]], [1, 0]).distance).toBe(1);
});

test('made once for as long as the view is the same', () => {
  const remembered = rememberedBy<object, number>();
  const make = vi.fn(() => 1);
  const owner = {};
  for (const view of [{ height: 1 }, { height: 1 }, { height: 2 }]) remembered(owner, [view], make);
  expect(make).toHaveBeenCalledTimes(2);
});
