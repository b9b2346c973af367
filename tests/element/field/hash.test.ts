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
    ['#T=NaN', /T is a multiple/],
    ['#T=Infinity', /T is a multiple of 0.25 from 0.25 to 20; found “Infinity”/],
    ['#example=0.5', /example is a multiple of 1 from 0 to 9; found “0.5”/],
    ['#example=-1', /example is a multiple of 1 from 0 to 9/],
    ['#resolution=33', /resolution is a multiple of 8 from 16 to 256/],
    ['#carve=-0.12', /carve is a multiple of 0.05/],
    ['#radius=2,5', /radius is a number/],
    ['#kernel=', /kernel is one of/],
    ['#kernel=Cauchy', /kernel is one of/],
    ['#toString=1', /nothing here is called “toString”/],
    ['#__proto__=1', /nothing here is called “__proto__”/],
    [`#radius=${'9'.repeat(9999)}`, /found “9{24}…”/],
  ])('%# %s is told in words, and the default stays', (hash, problem) => {
    expect(fromHash(hash)).toEqual({ state: DEFAULT_STATE, problem: expect.stringMatching(problem) });
  });

  test('what is understood holds, whatever is wrong beside it', () => {
    const { state, problem } = fromHash('#radius=20&kernel=foo&skeleton=ring&s=&x=1');
    expect(state).toEqual({ ...DEFAULT_STATE, radius: 20, skeleton: 'ring' });
    expect(problem).toMatch(/^kernel is one of .*found “foo”, and 2 more$/);
  });
});

test.each(NUMBER_KEYS)('%s: no number, however odd, gets past its slider', (key) => {
  const { min, max, step }: NumberSpec = NUMBERS[key];
  const odd = [-0, 0.1 + 0.2, 1 / 3, 1e-300, 1e300, (min + max) / 2 + 1e-9, Math.PI, min, max];
  for (const value of odd) {
    const { state, problem } = fromHash(`#${key}=${value}`);
    expect(state[key]).toBe(problem ? NUMBERS[key].default : value + 0);
    expect(state[key]).toBeGreaterThanOrEqual(min);
    expect(state[key]).toBeLessThanOrEqual(max);
    if (step) expect(Math.abs(state[key] / step - Math.round(state[key] / step))).toBeLessThan(1e-9);
  }
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
