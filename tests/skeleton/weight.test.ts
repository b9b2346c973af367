/** Weights from radii: the isosurface is where it was asked for. */
import { describe, expect, it } from 'vitest';
import { kernelNamed } from '../../src/kernel/index.ts';
import { bindSkel } from '../../src/skeleton/index.ts';
import { FieldError } from '../../src/skeleton/skeleton.ts';
import { lineWeight, plateWeight, pointWeight, widthFor } from '../../src/skeleton/weight.ts';
import { variants } from '../kernel/variants.ts';

const RADII = [0.03, 0.4, 1.9];
const T = 0.7;
const close = (found: number, wanted: number, to: number) =>
  expect(Math.abs(found / wanted - 1)).toBeLessThan(to);

describe.each(variants)('with the kernel $title', ({ kernel, params, exponent }) => {
  it('a lone point has its surface at the radius', () => {
    for (const radius of RADII) {
      const weight = pointWeight(kernel, params, radius, T);
      close(
        bindSkel({ type: 'point', at: [1, 2, 3], weight }, kernel, params).value(1, 2 + radius, 3),
        T,
        1e-12,
      );
    }
  });

  it('a segment has its surface at the radius in its middle', () => {
    for (const radius of RADII) {
      const weight = lineWeight(kernel, params, radius, T, 6);
      const field = bindSkel(
        { type: 'segment', a: [-3, 1, 0], b: [3, 1, 0], weights: [weight] },
        kernel,
        params,
      );
      close(field.value(0, 1, radius), T, 1e-12);
      if (!kernel.wholeLine) continue;
      const endless = lineWeight(kernel, params, radius, T);
      expect(endless).toBeLessThanOrEqual(weight * (1 + 1e-14));
      if (exponent >= 3) close(lineWeight(kernel, params, radius, T, 1e7), endless, 1e-6);
    }
  });

  it('a disc has its surface at the radius over its middle', () => {
    const disc = Array.from({ length: 2000 }, (_, i) => {
      const angle = (i * Math.PI) / 1000;
      return [Math.cos(angle), Math.sin(angle)] as const;
    });
    const axes = { type: 'polygon', origin: [0, 0, 0], u: [1, 0, 0], v: [0, 1, 0], loops: [disc] } as const;
    for (const radius of RADII) {
      const weight = plateWeight(kernel, params, radius, T, Math.PI);
      // 2000 sides enclose 2e-6 less than their circle
      close(bindSkel({ ...axes, weight }, kernel, params).value(0, 0, radius), T, 3e-6);
      const whole = kernel.wholePlane?.(1e-2, exponent) ?? Infinity;
      if (whole < Infinity) {
        expect(plateWeight(kernel, params, radius, T)).toBeLessThanOrEqual(weight * (1 + 1e-12));
      } else expect(() => plateWeight(kernel, params, radius, T)).toThrow(FieldError);
    }
  });

  it('a width for a radius makes the kernel half as large where the Cauchy kernel is', () => {
    const width = widthFor(kernel, params, 4);
    if (kernel.homogeneity !== 0) return expect(width).toEqual(params);
    const unit = kernel.unit(width, 1);
    const r = Math.sqrt(Math.SQRT2 - 1) / (0.8 / 4);
    expect(kernel.value((r / unit) ** 2, width.n ?? exponent)).toBeCloseTo(0.5, 12);
    expect(width.n).toBe(params.n);
  });
});

describe('weights', () => {
  const cauchy = kernelNamed('cauchy')!;
  it('are the closed forms', () => {
    const [s, r] = [0.4, 3];
    close(lineWeight(cauchy, { s }, r, T), (2 * s * T * (1 + s * s * r * r) ** 1.5) / Math.PI, 1e-14);
    close(widthFor(cauchy, {}, 4).s!, 0.2, 1e-12);
  });

  it('say what they lack', () => {
    expect(() => lineWeight(kernelNamed('inverse')!, {}, 1, 1)).toThrow(
      /lines of the kernel inverse need their length/,
    );
    expect(() => plateWeight(kernelNamed('inverseSquared')!, {}, 1, 1)).toThrow(/need their area/);
    expect(() => pointWeight(kernelNamed('quartic')!, { R: 2 }, 2.5, 1)).toThrow(/radius of 2.5.*support/);
    expect(() => pointWeight(cauchy, {}, 0, 1)).toThrow(/radius must be above 0, found 0/);
    expect(() => lineWeight(cauchy, {}, 1, Number.NaN)).toThrow(/threshold must be above 0/);
    expect(() => plateWeight(cauchy, { s: -2 }, 1, 1)).toThrow(/s must be from/);
  });
});
