import { describe, expect, test } from 'vitest';
import type { Ends } from '../../src/surface/bspline.ts';
import { limitOf, type Net, subdivided } from '../../src/surface/net.ts';
import { normal } from '../fixtures/random.ts';
import { basis } from './basis.ts';

function random(rows: number, columns: number, seed: number): Net {
  const next = normal(seed);
  return { rows, columns, points: Float64Array.from({ length: 3 * rows * columns }, () => next()) };
}

/** Σ Σ P N N (equation 3.4). */
function truth(net: Net, rows: readonly number[], columns: readonly number[], axis: number): number {
  let sum = 0;
  rows.forEach((a, i) => {
    columns.forEach((b, j) => {
      sum += a * b * net.points[3 * (i * net.columns + j) + axis]!;
    });
  });
  return sum;
}

interface Case {
  readonly u: Ends;
  readonly v: Ends;
  readonly rows: number;
  readonly columns: number;
}

const CASES: readonly Case[] = [
  { u: 'clamped', v: 'clamped', rows: 4, columns: 4 },
  { u: 'clamped', v: 'clamped', rows: 5, columns: 9 },
  { u: 'clamped', v: 'clamped', rows: 7, columns: 6 },
  { u: 'clamped', v: 'periodic', rows: 4, columns: 3 },
  { u: 'clamped', v: 'periodic', rows: 6, columns: 8 },
  { u: 'periodic', v: 'clamped', rows: 5, columns: 6 },
  { u: 'periodic', v: 'periodic', rows: 3, columns: 4 },
];
/** how often along u and along v */
const TIMES = [
  [0, 0],
  [1, 3],
  [2, 2],
  [5, 0],
  [0, 5],
] as const;

for (const { u, v, rows, columns } of CASES) {
  describe(`${rows} × ${columns}, ${u} in u and ${v} in v (seed ${rows * columns})`, () => {
    const net = random(rows, columns, rows * columns);
    for (const [a, b] of TIMES) {
      test(`subdivided ${a} and ${b} times: points, derivatives and normals are the basis functions'`, () => {
        const fine = subdivided(subdivided(net, 'u', u, a), 'v', v, b);
        const limit = limitOf(fine, { u, v });
        const us = Array.from({ length: limit.points.rows }, (_, i) => basis(rows, u, i / 2 ** a));
        const vs = Array.from({ length: limit.points.columns }, (_, j) => basis(columns, v, j / 2 ** b));
        let most = 0;
        us.forEach((atU, i) => {
          vs.forEach((atV, j) => {
            for (const axis of [0, 1, 2]) {
              const k = 3 * (i * vs.length + j) + axis;
              const errors = [
                limit.points.points[k]! - truth(net, atU.at, atV.at, axis),
                limit.du.points[k]! * 2 ** a - truth(net, atU.slope, atV.at, axis),
                limit.dv.points[k]! * 2 ** b - truth(net, atU.at, atV.slope, axis),
                limit.duv.points[k]! * 2 ** (a + b) - truth(net, atU.slope, atV.slope, axis),
              ];
              most = Math.max(most, ...errors.map(Math.abs));
            }
          });
        });
        expect(most).toBeLessThan(1e-9);
      });
    }

    test('subdividing along u first or along v first is the same', () => {
      const one = subdivided(subdivided(net, 'u', u, 2), 'v', v, 1);
      const other = subdivided(subdivided(net, 'v', v, 1), 'u', u, 2);
      for (let i = 0; i < one.points.length; i++) expect(other.points[i]!).toBeCloseTo(one.points[i]!, 12);
    });
  });
}
