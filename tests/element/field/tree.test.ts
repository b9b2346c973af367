/** Every preset, kernel, section and operation of the field page has a field; what has none says where and why. */
import fc from 'fast-check';
import { describe, expect, test } from 'vitest';
import {
  CHOICE_KEYS,
  CHOICES,
  DEFAULT_STATE,
  type FieldState,
  fromSlider,
  NUMBER_KEYS,
  NUMBERS,
} from '../../../src/element/field/fieldState.ts';
import { examplesOf, firstWeight, paramsOf, treeOf } from '../../../src/element/field/tree.ts';
import { bindField } from '../../../src/field/bind.ts';
import { expanded } from '../../../src/field/expand.ts';
import type { SkelsNode } from '../../../src/field/node.ts';
import { polygonize } from '../../../src/field/polygonize.ts';
import { kernelNamed } from '../../../src/kernel/index.ts';
import { topology } from '../../../src/mesh/check.ts';
import { bounds } from '../../../src/mesh/measure.ts';
import type { ProfileSkel } from '../../../src/skeleton/profile.ts';
import { FieldError } from '../../../src/skeleton/skeleton.ts';

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

test.each(ids('kernel'))('%s with the default width has a field of every skeleton', (kernel) => {
  for (const skeleton of ids('skeleton'))
    expect(field({ skeleton, kernel, width: 'own' }).box).not.toBeNull();
});

test.each(ids('shape'))('%s: each example under each operation', (shape) => {
  examplesOf(state({ shape })).forEach((_, example) => {
    for (const operation of ids('operation')) {
      for (const form of ids('form')) field({ skeleton: 'segment', shape, example, operation, form });
    }
  });
});

test('every kind of skel is on the page', () => {
  const kinds = ids('skeleton').flatMap((skeleton) => {
    const tree = treeOf(state({ skeleton }));
    return tree.type === 'skels' ? tree.skels.map(({ skel }) => skel.type) : [];
  });
  const all = ['arc', 'nurbs', 'point', 'polygon', 'polyline', 'profile', 'quadratic', 'segment'];
  expect([...new Set(kinds)].sort()).toEqual(all);
});

test.each(['arc', 'spline', 'profile'])('%s: one solid body', (skeleton) => {
  const { mesh } = polygonize(field({ skeleton }), 32);
  expect(topology(mesh)).toMatchObject({ watertight: true, components: 1, genus: 0 });
});

/** Any state that the address lets in. */
const states = fc.record({
  ...Object.fromEntries(
    NUMBER_KEYS.map((key) => [
      key,
      fc.oneof(
        fc.constantFrom(0, 1).map((place) => fromSlider(NUMBERS[key], place)),
        fc.double({ min: 0, max: 1, noNaN: true }).map((place) => fromSlider(NUMBERS[key], place)),
      ),
    ]),
  ),
  ...Object.fromEntries(CHOICE_KEYS.map((key) => [key, fc.constantFrom(...ids(key))])),
}) as unknown as fc.Arbitrary<FieldState>;

test('any state has a field, or says in words why not (seed 2)', () => {
  let fields = 0;
  fc.assert(
    fc.property(states, (any) => {
      try {
        bindField(treeOf(any));
        fields++;
      } catch (error) {
        expect(error).toBeInstanceOf(FieldError);
      }
    }),
    { seed: 2, numRuns: 300 },
  );
  expect(fields).toBeGreaterThan(200);
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

  const even = ['point', 'segment', 'crossed', 'ring', 'arc', 'profile', 'concave', 'holed'];
  test.each(even)('%s: going over to weights leaves the body as it is', (skeleton) => {
    const before = state({ skeleton, radiusEnd: 16, weight1: 1, weight2: 1, weight3: 1 });
    const after = state({ ...before, by: 'weight', weight: firstWeight(before) });
    const values = [before, after].map((of) => {
      const body = bindField(treeOf(of));
      return [body.value(-50, 3, 2), body.value(3, 15, 0), body.value(46, 10, 5)];
    });
    expect(values[1]).toEqual(values[0]!.map((value) => expect.closeTo(value, 6)));
  });

  // how a spline is cut goes by all of its weights
  const cutAlike = ids('skeleton').filter((id) => id !== 'spline');
  test.each(cutAlike)('%s: by weight the first weight stays', (skeleton) => {
    const before = state({ skeleton });
    const after = state({ ...before, by: 'weight', weight: firstWeight(before) });
    const [old, now] = [before, after].map((of) => {
      const { params, threshold, skels } = treeOf(of) as SkelsNode;
      const [first] = expanded(skels[0]!.skel, kernelNamed('cauchy')!, params, threshold);
      return 'weight' in first! ? first.weight : first!.weights[0]!;
    });
    expect(now! / old!).toBeCloseTo(1, 6);
  });

  test.each([
    ['ring', 'polyline'],
    ['curve', 'nurbs'],
    ['arc', 'arc'],
    ['point', 'point'],
  ])('%s: radii are left to the body', (skeleton, type) => {
    const { skels } = treeOf(state({ skeleton })) as SkelsNode;
    expect(skels[0]!.skel).toMatchObject({ type });
    expect('radii' in skels[0]!.skel || 'radius' in skels[0]!.skel).toBe(true);
  });

  test('a drawn weight is that of its sliders', () => {
    const drawn = { skeleton: 'profile', by: 'weight', weight: 2, weight1: 0.5, weight2: 3, weight3: 0 };
    const { skels } = treeOf(state(drawn)) as SkelsNode;
    expect(skels[0]!.skel).toMatchObject({ curve: { type: 'bezier', ordinates: [2, 1, 6, 0] } });
    const { skels: byRadius } = treeOf(state({ ...drawn, by: 'radius' })) as SkelsNode;
    const { curve } = byRadius[0]!.skel as ProfileSkel;
    if (curve.type !== 'bezier') throw new Error('ordinates were wanted');
    const [first] = curve.ordinates;
    expect(curve.ordinates.map((w) => w / first!)).toEqual([1, 0.5, 3, 0].map((x) => expect.closeTo(x, 9)));
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
