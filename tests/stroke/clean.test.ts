import { describe, expect, test } from 'vitest';
import { clean } from '../../src/stroke/clean.ts';
import { penStroke, samplesAt } from '../fixtures/pen.ts';

const line = samplesAt([
  [0, 0],
  [1, 0],
  [2, 0],
  [3, 0],
]);

describe('clean', () => {
  test('dots are no strokes: nothing, one sample, equal samples, nothing sound', () => {
    expect(clean([], 0.2)).toBeNull();
    expect(clean(samplesAt([[3, 4]]), 0.2)).toBeNull();
    expect(
      clean(
        samplesAt([
          [3, 4],
          [3, 4],
        ]),
        0.2,
      ),
    ).toBeNull();
    expect(clean(samplesAt(new Array(500).fill([3, 4])), 0.2)).toBeNull();
    expect(
      clean(
        samplesAt([
          [NaN, 0],
          [Infinity, 1],
          [0, -Infinity],
        ]),
        0.2,
      ),
    ).toBeNull();
  });

  test('a clean stroke stays as it is, sample for sample', () => {
    expect(clean(line, 0.2)).toEqual({ samples: line, broken: 0, resting: 0 });
  });

  test('broken samples go, and are counted', () => {
    const broken = samplesAt([
      [0, 0],
      [NaN, 1],
      [1, 0],
      [1, Infinity],
      [1e300, 0],
      [2, 0],
    ]);
    const left = clean(broken, 0.2)!;
    expect(left.samples).toEqual([broken[0], broken[2], broken[5]]);
    expect(left.broken).toBe(3);
  });

  test('pressure is brought into 0–1, tilt and time stay', () => {
    const odd = line.map((s, i) => ({ ...s, pressure: [NaN, -1, 7, 0.3][i]!, tiltX: i }));
    const { samples } = clean(odd, 0.2)!;
    expect(samples.map((s) => s.pressure)).toEqual([0.5, 0, 1, 0.3]);
    expect(samples.map((s) => s.tiltX)).toEqual([0, 1, 2, 3]);
    expect(samples.map((s) => s.time)).toEqual(line.map((s) => s.time));
  });

  test('a resting pen leaves one place; the end is where it was lifted (seed 11)', () => {
    const samples = penStroke((t) => [100 * t, 0], { seed: 11, rest: 200, jitter: 0.03 });
    const { samples: left, resting } = clean(samples, 0.2)!;
    expect(resting).toBeGreaterThan(380);
    expect(left[0]).toEqual(samples[0]);
    expect(left.at(-1)).toEqual(samples.at(-1));
    for (let i = 1; i < left.length - 1; i++) {
      expect(Math.hypot(left[i]!.x - left[i - 1]!.x, left[i]!.y - left[i - 1]!.y)).toBeGreaterThan(0.2);
    }
  });

  for (const scale of [1e-9, 1, 1e6]) {
    test(`a drawing keeps its detail at scale ${scale}`, () => {
      const shape = Array.from({ length: 100 }, (_, i) => [i * scale, (i % 2) * scale] as const);
      expect(clean(samplesAt(shape), 0.2)!.samples).toHaveLength(100);
    });
  }

  test('100,000 samples', () => {
    const many = samplesAt(Array.from({ length: 100_000 }, (_, i) => [i / 100, Math.sin(i / 1000)] as const));
    const { samples, resting } = clean(many, 0.2)!;
    expect(samples.length + resting).toBe(100_000);
    expect(samples.length).toBeGreaterThan(4000);
  });
});
