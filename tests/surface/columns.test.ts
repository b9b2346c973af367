import { describe, expect, test } from 'vitest';
import { dot2, length2 } from '../../src/math/tuple.ts';
import { columnsOf } from '../../src/surface/columns.ts';
import { joined, round } from '../../src/surface/joined.ts';
import { roundHalf, straight } from '../../src/surface/outline.ts';
import { bent, comb, roof, wave } from './outlines.ts';

describe('columns of outlines', () => {
  test('are even in v, from end to end; without corners there are no creases', () => {
    expect(columnsOf(straight, 4)).toMatchObject({
      vs: [0, 0.25, 0.5, 0.75, 1],
      joined: [false, true, true, true, true],
      points: [
        [-1, 0],
        [-0.5, 0],
        [0, 0],
        [0.5, 0],
        [1, 0],
      ],
    });
    const circle = columnsOf(round, 16);
    expect(circle.vs).toEqual(Array.from({ length: 17 }, (_, i) => i / 16));
    expect(circle.joined.slice(1).every(Boolean)).toBe(true);
  });

  test('closed ones end in their first point, and have q_r among them for any number of quads', () => {
    for (const quads of [1, 2, 3, 7, 30]) {
      for (const front of [roundHalf, roof, comb, wave(0.3, 4)]) {
        const { points, vs } = columnsOf(joined(front, 'mirror'), quads);
        expect(points.at(-1)).toBe(points[0]);
        expect(points[vs.indexOf(0.5)]).toEqual([1, 0]);
        expect(points.length).toBeGreaterThanOrEqual(4);
      }
    }
  });

  test('corners are two entries in one place with a tangent each, the seam of closed ones alike', () => {
    const skew = columnsOf(bent([-1, 0], [0.2, 1], [1, 0]), 9);
    const k = skew.joined.lastIndexOf(false);
    expect(k).toBeGreaterThan(1);
    expect(skew.points[k]).toBe(skew.points[k - 1]);
    expect(skew.vs[k]).toBe(skew.vs[k - 1]);
    const cosine = (i: number, j: number) =>
      dot2(skew.rates[i]!, skew.rates[j]!) / length2(skew.rates[i]!) / length2(skew.rates[j]!);
    expect(cosine(k - 1, k)).toBeLessThan(0.5);
    expect(cosine(k, k + 1)).toBeCloseTo(1, 9);
    const lens = columnsOf(joined(roof, 'mirror'), 8);
    expect(lens.vs.filter((v) => v === 0.5)).toHaveLength(2);
    expect(lens.rates[0]![1]).toBeGreaterThan(0);
    expect(lens.rates.at(-1)![1]).toBeGreaterThan(0);
    expect(lens.rates[0]![0]).toBeGreaterThan(0);
    expect(lens.rates.at(-1)![0]).toBeLessThan(0);
  });

  test('corners nearer to each other than rounding are one', () => {
    const { vs } = columnsOf({ ...straight, corners: [0.5, 0.5 + 1e-12, 1 - 1e-12] }, 2);
    expect(vs).toEqual([0, 0.5, 0.5, 1]);
  });
});
