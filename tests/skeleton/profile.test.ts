import { describe, expect, test } from 'vitest';
import type { Vec3 } from '../../src/math/vec.ts';
import {
  expandProfile,
  type ProfileKey,
  type WeightCurve,
  weightPieces,
} from '../../src/skeleton/profile.ts';
import { random } from '../fixtures/random.ts';
import { curveField, sumField } from './curves.ts';

const weightAt = (curve: WeightCurve, u: number): number => {
  const pieces = weightPieces(curve);
  const { from, to, coefficients } = pieces.find((piece) => u <= piece.to) ?? pieces.at(-1)!;
  const v = (u - from) / (to - from);
  return coefficients.reduceRight((sum, c) => sum * v + c, 0);
};
const slopeAt = (curve: WeightCurve, u: number, direction: 1 | -1): number => {
  const h = direction * 1e-6;
  return (weightAt(curve, u + 2 * h) - weightAt(curve, u + h)) / h;
};
const keys: readonly ProfileKey[] = [
  { at: 0, weight: 1 },
  { at: 0.2, weight: 3, tension: 0.4, bias: -0.3 },
  { at: 0.7, weight: 0.5, bias: 0.6 },
  { at: 1, weight: 2 },
];

describe('weight curves', () => {
  test('pass through their keys, without a kink unless continuity asks for one', () => {
    const curve: WeightCurve = { type: 'keys', keys };
    for (const { at, weight } of keys) expect(weightAt(curve, at)).toBeCloseTo(weight, 13);
    for (const { at } of keys.slice(1, -1)) {
      expect(slopeAt(curve, at + 1e-9, 1)).toBeCloseTo(slopeAt(curve, at - 1e-9, -1), 3);
    }
    const kinked: WeightCurve = { type: 'keys', keys: keys.map((key) => ({ ...key, continuity: -0.8 })) };
    expect(Math.abs(slopeAt(kinked, 0.2 + 1e-9, 1) - slopeAt(kinked, 0.2 - 1e-9, -1))).toBeGreaterThan(1);
  });

  test('even keys without tension, continuity and bias are Catmull and Rom’s', () => {
    const weights = [1, 4, 2, 5];
    const even: WeightCurve = { type: 'keys', keys: weights.map((weight, i) => ({ at: i / 3, weight })) };
    const [, middle] = weightPieces(even);
    expect(middle!.coefficients[1]).toBeCloseTo((2 - 1) / 2, 13);
    const [, c1, c2, c3] = middle!.coefficients;
    expect(c1 + 2 * c2 + 3 * c3).toBeCloseTo((5 - 4) / 2, 13);
  });

  test('keys on a line stay on it, however they are spaced', () => {
    const line: WeightCurve = { type: 'keys', keys: keys.map(({ at }) => ({ at, weight: 1 + 2 * at })) };
    for (let u = 0; u <= 1; u += 0.05) expect(weightAt(line, u)).toBeCloseTo(1 + 2 * u, 13);
  });

  test('tension 1 flattens the keys', () => {
    const flat: WeightCurve = { type: 'keys', keys: keys.map((key) => ({ ...key, tension: 1 })) };
    for (const { coefficients } of weightPieces(flat)) {
      expect(Math.abs(coefficients[1])).toBe(0);
      expect(2 * coefficients[2] + 3 * coefficients[3]).toBeCloseTo(0, 13);
    }
  });

  test('Bézier ordinates are Bernstein’s sums', () => {
    const ordinates = [1, 4, -1, 2, 5, 0, 3];
    const curve: WeightCurve = { type: 'bezier', ordinates };
    for (let u = 0.01; u < 1; u += 0.07) {
      const k = u < 0.5 ? 0 : 3;
      const t = u < 0.5 ? 2 * u : 2 * u - 1;
      const s = 1 - t;
      const [a, b, c, d] = ordinates.slice(k, k + 4) as [number, number, number, number];
      const bernstein = s * s * s * a + 3 * s * s * t * b + 3 * s * t * t * c + t * t * t * d;
      expect(weightAt(curve, u)).toBeCloseTo(bernstein, 13);
    }
  });
});

describe('profiles along a line', () => {
  const points: Vec3[] = [
    [0, 0, 0],
    [4, 0, 3],
    [4, 0, 3],
    [4, 5, 3],
  ];
  const along = (u: number): Vec3 => (u < 0.5 ? [8 * u, 0, 6 * u] : [4, 10 * u - 5, 3]);

  test.each<[string, WeightCurve]>([
    ['keys', { type: 'keys', keys }],
    ['bezier', { type: 'bezier', ordinates: [1, 4, 1, 2, 5, 0.1, 3] }],
  ])('%s: the field is that of the weight curve by quadrature (seed 81)', (_, curve) => {
    const segments = expandProfile({ type: 'profile', points, curve });
    expect(segments.every(({ weights }) => weights.length <= 4)).toBe(true);
    const field = sumField(segments, 'cauchy', { s: 0.7 });
    const truth = { at: along, speed: () => 10, weight: (u: number) => weightAt(curve, u) };
    const next = random(81);
    for (let i = 0; i < 12; i++) {
      const p: Vec3 = [8 * next() - 2, 8 * next() - 2, 6 * next() - 1];
      expect(field(p)).toBeCloseTo(curveField(truth, 'cauchy', { s: 0.7 }, p, 100), 9);
    }
  });

  test('even pieces along even lines leave no crumbs at the vertices (seed 82)', () => {
    const next = random(82);
    for (let i = 0; i < 300; i++) {
      const [corner, step, count] = [2000 * next() - 1000, 0.1 + next(), 1 + Math.floor(7 * next())];
      const even = Array.from({ length: count + 1 }, (_, k): Vec3 => [corner + k * step, corner, -corner]);
      const ordinates = Array.from({ length: 3 * count + 1 }, () => 1);
      const segments = expandProfile({ type: 'profile', points: even, curve: { type: 'bezier', ordinates } });
      expect(segments).toHaveLength(count);
      for (const { a, b } of segments) expect(b[0] - a[0]).toBeCloseTo(step, 9);
    }
  });

  test('pieces follow each other without gaps', () => {
    const segments = expandProfile({ type: 'profile', points, curve: { type: 'keys', keys } });
    expect(segments).toHaveLength(4);
    segments.slice(1).forEach(({ a }, i) => {
      a.forEach((x, k) => {
        expect(segments[i]!.b[k]).toBeCloseTo(x, 13);
      });
    });
  });

  test.each<[WeightCurve, RegExp]>([
    [{ type: 'bezier', ordinates: [1, 2, 3] }, /4, 7, 10 … ordinates, got 3/],
    [{ type: 'keys', keys: [{ at: 0, weight: 1 }] }, /rise from 0 to 1/],
    [{ type: 'keys', keys: [keys[0]!, keys[2]!, keys[1]!, keys[3]!] }, /rise from 0 to 1/],
    [{ type: 'keys', keys: [keys[0]!, { at: 1, weight: 1, tension: 3 }] }, /keys\[1\]: .* got 3/],
    [{ type: 'keys', keys: [keys[0]!, { at: 1, weight: Number.NaN }] }, /keys\[1\]: weight/],
  ])('%j is refused', (curve, message) => {
    expect(() => expandProfile({ type: 'profile', points, curve })).toThrow(message);
  });

  test('a line without length is refused', () => {
    const line = { type: 'profile', curve: { type: 'keys', keys } } as const;
    expect(() => expandProfile({ ...line, points: [[1, 1, 1]] })).toThrow(/apart/);
  });
});
