import { describe, expect, test } from 'vitest';
import { kernelNamed } from '../../src/kernel/index.ts';
import { cos, PI, sin } from '../../src/math/trig.ts';
import type { Vec3 } from '../../src/math/vec.ts';
import { type ArcSkel, expandArc } from '../../src/skeleton/arc.ts';
import { random } from '../fixtures/random.ts';
import { type Curve, curveField, PARAMS, sumField } from './curves.ts';

const arc: ArcSkel = {
  type: 'arc',
  centre: [1, 2, 0],
  start: [6, 2, 0],
  axis: [0, 0, 2],
  angle: 4,
  weights: [2, 0.5],
  fieldError: 1e-3,
  distance: 0,
};
const truth: Curve = {
  at: (t) => [1 + 5 * cos(4 * t), 2 + 5 * sin(4 * t), 0],
  speed: () => 20,
  weight: (t) => 2 - 1.5 * t,
};

/** On the arc, beside it and away. */
function* points(count: number, seed: number): Generator<Vec3> {
  const next = random(seed);
  for (let i = 0; i < count; i++) {
    const [x, y] = truth.at(next());
    yield [x + 2 * (next() - 0.5), y + 2 * (next() - 0.5), 2 * (next() - 0.5)];
  }
  yield truth.at(0.3);
  yield truth.at(0);
  yield [1, 2, 0];
}

describe('arcs', () => {
  test.each(PARAMS)('%s: the error of the field is below what was asked for (seed 91)', (name, params) => {
    for (const fieldError of [0.1, 1e-2, 1e-3]) {
      const segments = expandArc({ ...arc, fieldError }, kernelNamed(name)!, params);
      const field = sumField(segments, name, params);
      const errors = [...points(12, 91)].map((p) => Math.abs(field(p) - curveField(truth, name, params, p)));
      expect(Math.max(...errors)).toBeLessThan(fieldError);
      // and not wasted
      expect(Math.max(...errors)).toBeGreaterThan(0.01 * fieldError);
    }
  });

  test('inverse cubic: from the distance on (seed 92)', () => {
    const near = { ...arc, fieldError: 0.1, distance: 1 };
    const segments = expandArc(near, kernelNamed('inverseCubic')!, {});
    const field = sumField(segments, 'inverseCubic', {});
    const next = random(92);
    for (let i = 0; i < 20; i++) {
      const [x, y] = truth.at(next());
      const p: Vec3 = [x, y, 1 + next()];
      expect(Math.abs(field(p) - curveField(truth, 'inverseCubic', {}, p))).toBeLessThan(0.1);
    }
    expect(() => expandArc({ ...near, distance: 0 }, kernelNamed('inverseCubic')!, {})).toThrow(
      /distance above 0/,
    );
  });

  test('four times the error, half the chords', () => {
    const count = (fieldError: number) =>
      expandArc({ ...arc, fieldError }, kernelNamed('cauchy')!, { s: 0.8 }).length;
    expect(count(1e-4) / count(4e-4)).toBeCloseTo(2, 1);
    expect(count(1e3)).toBeLessThan(8);
  });

  test('a whole circle closes; turned the other way it is its mirror', () => {
    const circle = expandArc({ ...arc, angle: 2 * PI }, kernelNamed('cauchy')!, { s: 1 });
    circle.at(-1)!.b.forEach((x, i) => {
      expect(x).toBeCloseTo(circle[0]!.a[i]!, 12);
    });
    const [there, back] = [1, -1].map((sign) =>
      expandArc({ ...arc, angle: sign }, kernelNamed('cauchy')!, { s: 1 }),
    );
    there!.forEach(({ b }, i) => {
      expect(back![i]!.b[1] - 2).toBeCloseTo(2 - b[1], 13);
      expect(back![i]!.b[0]).toBeCloseTo(b[0], 13);
    });
  });

  test.each<[Partial<ArcSkel>, RegExp]>([
    [{ start: [1, 2, 0] }, /radius above 0/],
    [{ axis: [3, 0, 0] }, /axis must not point along/],
    [{ angle: 0 }, /angle/],
    [{ angle: 7 }, /angle/],
    [{ fieldError: 0 }, /fieldError must be above 0/],
    [{ fieldError: 1e-12 }, /more than 4096 chords/],
    [{ distance: -1 }, /distance/],
    [{ distance: Infinity }, /distance must be/],
    [{ weights: [1, Number.NaN] }, /weights of an arc must be numbers within ±1e\+60, found NaN/],
    [{ weights: [1] as never }, /2 weights, found 1/],
    [{ centre: [0, Number.NaN, 0] }, /places.* found NaN/],
  ])('%j is refused', (change, message) => {
    expect(() => expandArc({ ...arc, ...change }, kernelNamed('cauchy')!, { s: 1 })).toThrow(message);
  });
});
