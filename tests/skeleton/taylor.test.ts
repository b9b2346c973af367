/** Polynomials that stand for skels: against the field of a point source, and under shifts and maps. */
import { expect, test } from 'vitest';
import {
  addMapped,
  addSource,
  evaluateTaylor,
  shiftTaylor,
  TAYLOR,
  taylorAt,
} from '../../src/skeleton/taylor.ts';
import { random } from '../fixtures/random.ts';

const SEED = 57;
const next = random(SEED);
const one = () => 2 * next() - 1;

function anyTaylor() {
  return Float64Array.from({ length: TAYLOR }, one);
}

test(`a source is met to the third order (seed ${SEED})`, () => {
  const c = new Float64Array(TAYLOR);
  const [x, y, z] = [1.5, -0.7, 0.9];
  const f = (q: number) => 1 / (1 + q) ** 2;
  const q = x * x + y * y + z * z;
  addSource(c, f(q), -2 / (1 + q) ** 3, 6 / (1 + q) ** 4, x, y, z);
  const miss = (h: number) => {
    const [u, v, w] = [0.6 * h, -0.48 * h, 0.64 * h];
    return Math.abs(f((x + u) ** 2 + (y + v) ** 2 + (z + w) ** 2) - taylorAt(c, u, v, w));
  };
  expect(miss(1e-2) / miss(5e-3)).toBeCloseTo(8, 0);
  expect(miss(1e-2)).toBeLessThan(1e-6);
});

test(`a shifted polynomial is the same one, and gradients are differences (seed ${SEED})`, () => {
  for (let i = 0; i < 50; i++) {
    const c = anyTaylor();
    const d = [one(), one(), one()] as const;
    const p = [one(), one(), one()] as const;
    const shifted = new Float64Array(TAYLOR);
    shiftTaylor(c, ...d, shifted);
    expect(taylorAt(shifted, ...p)).toBeCloseTo(taylorAt(c, p[0] + d[0], p[1] + d[1], p[2] + d[2]), 12);
    const out = new Float64Array(4);
    evaluateTaylor(c, ...p, out);
    const h = 0.5;
    const slope = (taylorAt(c, p[0] + h, p[1], p[2]) - taylorAt(c, p[0] - h, p[1], p[2])) / (2 * h);
    expect(out[1]).toBeCloseTo(slope, 12);
    expect(out[0]).toBeCloseTo(taylorAt(c, ...p), 14);
  }
});

test(`a mapped polynomial is that of the mapped point (seed ${SEED})`, () => {
  for (let i = 0; i < 50; i++) {
    const local = anyTaylor();
    const rows = Float64Array.from({ length: 9 }, one);
    const out = new Float64Array(TAYLOR);
    addMapped(local, rows, out);
    const p = [one(), one(), one()];
    const row = (k: number) => rows[3 * k]! * p[0]! + rows[3 * k + 1]! * p[1]! + rows[3 * k + 2]! * p[2]!;
    expect(taylorAt(out, p[0]!, p[1]!, p[2]!)).toBeCloseTo(taylorAt(local, row(0), row(1), row(2)), 12);
  }
});
