/** The state in the address: there and back, and nothing unchecked. */
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
  type NumberSpec,
  toSlider,
} from '../../../src/element/field/fieldState.ts';
import { fromHash, toHash } from '../../../src/element/field/hash.ts';

/** Any state that sliders and buttons can make. */
const states = fc.record({
  ...Object.fromEntries(
    NUMBER_KEYS.map((key) => [
      key,
      fc.integer({ min: 0, max: 200 }).map((i) => fromSlider(NUMBERS[key], i / 200)),
    ]),
  ),
  ...Object.fromEntries(
    CHOICE_KEYS.map((key) => [key, fc.constantFrom(...CHOICES[key].options.map(([id]) => id as string))]),
  ),
}) as unknown as fc.Arbitrary<FieldState>;

describe('address', () => {
  test('the default state has none', () => {
    expect(toHash(DEFAULT_STATE)).toBe('');
    expect(fromHash('')).toEqual({ state: DEFAULT_STATE, problem: null });
  });

  test('any state comes back (seed 1)', () => {
    fc.assert(
      fc.property(states, (state) => {
        expect(fromHash(toHash(state))).toEqual({ state, problem: null });
      }),
      { seed: 1 },
    );
  });

  test.each([
    ['#kernel=foo', /kernel is one of cauchy, .*found “foo”/],
    ['#radius=1000', /radius is a number from 2 to 60; found “1000”/],
    ['#radius=', /radius is a number/],
    ['#T=NaN', /T is a number/],
    ['#toString=1', /nothing here is called “toString”/],
    ['#__proto__=1', /nothing here is called “__proto__”/],
    [`#radius=${'9'.repeat(9999)}`, /found “9{24}…”/],
  ])('%# %s is told in words, and the defaults stay', (hash, problem) => {
    expect(fromHash(hash)).toEqual({ state: DEFAULT_STATE, problem: expect.stringMatching(problem) });
  });
});

describe('sliders', () => {
  test.each(NUMBER_KEYS)('%s: the default is on the slider and comes back from it', (key) => {
    const spec: NumberSpec = NUMBERS[key];
    const place = toSlider(spec, spec.default);
    expect(place).toBeGreaterThanOrEqual(0);
    expect(place).toBeLessThanOrEqual(1);
    expect(fromSlider(spec, place)).toBeCloseTo(spec.default, 6);
    expect([fromSlider(spec, 0), fromSlider(spec, 1)]).toEqual([spec.min, spec.max]);
  });
});
