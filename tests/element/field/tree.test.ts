/** Every preset, kernel, section and operation of the field page has a field; what has none says where and why. */
import { describe, expect, test } from 'vitest';
import { CHOICES, DEFAULT_STATE, type FieldState } from '../../../src/element/field/fieldState.ts';
import { examplesOf, firstWeight, paramsOf, treeOf } from '../../../src/element/field/tree.ts';
import { bindField } from '../../../src/field/bind.ts';
import { polygonize } from '../../../src/field/polygonize.ts';
import { topology } from '../../../src/mesh/check.ts';
import { bounds } from '../../../src/mesh/measure.ts';

const state = (change: Partial<FieldState>) => ({ ...DEFAULT_STATE, ...change }) as FieldState;
const ids = (key: keyof typeof CHOICES) => CHOICES[key].options.map(([id]) => id as string);
const field = (change: Partial<FieldState>) => bindField(treeOf(state(change)));

describe.each(ids('skeleton'))('%s', (skeleton) => {
  test.each(ids('kernel'))('%s has a field, by radius and by weight', (kernel) => {
    for (const by of ids('by')) expect(field({ skeleton, kernel, by }).box).not.toBeNull();
  });

  test.each(ids('section'))('%s section', (section) => {
    for (const profile of ids('profile')) expect(field({ skeleton, section, profile }).box).not.toBeNull();
  });
});

test.each(ids('shape'))('%s: each example under each operation', (shape) => {
  examplesOf(state({ shape })).forEach((_, example) => {
    for (const operation of ids('operation')) {
      for (const form of ids('form')) field({ skeleton: 'segment', shape, example, operation, form });
    }
  });
});

test('the first body is one solid animal', () => {
  const { mesh } = polygonize(field({}), 40);
  expect(topology(mesh)).toMatchObject({ watertight: true, components: 1, genus: 0 });
});

describe('radii', () => {
  test.each(['cauchy', 'gaussian', 'inverse', 'inverseCubic', 'power'])(
    '%s: a segment is as thick as asked',
    (kernel) => {
      const { mesh } = polygonize(field({ skeleton: 'segment', kernel, radiusEnd: 16 }), 48);
      const { max } = bounds(mesh);
      expect(max[1]).toBeCloseTo(16, 0);
      expect(max[2]).toBeCloseTo(16, 0);
    },
  );

  test('going over to weights leaves the body as it is', () => {
    const before = state({ skeleton: 'segment', radiusEnd: 16 });
    const after = { ...before, by: 'weight', weight: firstWeight(before) };
    expect(bindField(treeOf(after)).value(3, 15, 0)).toBeCloseTo(
      bindField(treeOf(before)).value(3, 15, 0),
      9,
    );
  });

  test('ordinates are those of the weight along the segment', () => {
    const tree = treeOf(state({ skeleton: 'segment', by: 'weight', weight: 2, degree: '3', weight3: 3 }));
    if (tree.type !== 'skels') throw new Error('a body was wanted');
    const skel = tree.skels[0]!.skel;
    if (skel.type !== 'segment' || !('weights' in skel)) throw new Error('a segment was wanted');
    const at = (t: number) => skel.weights.reduce((sum, w, k) => sum + w * t ** k, 0);
    const { weight1, weight2 } = DEFAULT_STATE;
    expect(at(0)).toBeCloseTo(2);
    expect(at(100)).toBeCloseTo(6);
    expect(at(50)).toBeCloseTo((2 * (1 + 3 * weight1 + 3 * weight2 + 3)) / 8);
  });

  test('the fitted width follows the smallest radius', () => {
    const { s: wide } = paramsOf(state({ skeleton: 'point', radius: 20 }));
    const { s: narrow } = paramsOf(state({ skeleton: 'point', radius: 5 }));
    expect(narrow! / wide!).toBeCloseTo(4);
  });
});

describe('what has no field', () => {
  test.each<[Partial<FieldState>, RegExp]>([
    [{ T: 0 }, /threshold must be above 0/],
    [{ T: 0, by: 'weight', width: 'own' }, /threshold must be above 0/],
    [{ kernel: 'quartic', width: 'own', R: 10 }, /skels\[\d+\].*beyond its support/],
    [
      { carve: -1, kernel: 'quartic', width: 'own', R: 30, carveRadius: 40 },
      /skels\[\d+\].*beyond its support/,
    ],
  ])('%o', (change, message) => {
    expect(() => field(change)).toThrow(message);
  });
});
