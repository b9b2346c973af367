import { describe, expect, it } from 'vitest';
import { kernels } from '../../../src/kernel/index.ts';
import { thinnest, widthOf } from '../../../src/skeleton/medial/width.ts';

const ball = (radius: number) => ({ nodes: [{ at: [0, 0] as const, radius }], links: [] });
const usual = (kernel: (typeof kernels)[number]) =>
  Object.fromEntries(kernel.params.map(({ name, default: value }) => [name, value]));

describe.each(kernels.map((kernel) => [kernel.name, kernel] as const))('widthOf, %s', (_, kernel) => {
  const unit = (...radii: number[]) => kernel.unit(widthOf(radii.map(ball), kernel, usual(kernel)), 1);
  const hasWidth = kernel.homogeneity === 0;

  it('grows with the form', () => {
    expect(unit(20) / unit(10)).toBeCloseTo(hasWidth ? 2 : 1, 9);
  });

  it('is for the thinnest of several groups, as long as the thickest is reached', () => {
    expect(unit(5, 6)).toBeLessThanOrEqual(unit(6) * (1 + 1e-12));
    if (kernel.support < Infinity) expect(unit(1, 30)).toBeGreaterThan(30);
    if (hasWidth) expect(kernel.value((30 / unit(1e-6, 30)) ** 2, 4)).toBeGreaterThan(0);
  });

  it('leaves what is given where there is nothing', () => {
    expect(widthOf([], kernel, usual(kernel))).toEqual(usual(kernel));
    expect(widthOf([ball(0), ball(Number.NaN)], kernel, usual(kernel))).toEqual(usual(kernel));
  });
});

describe('thinnest', () => {
  it('is not the tip’s', () => {
    const nodes = [0, 10, 11].map((x, i) => ({ at: [x, 0] as const, radius: i === 2 ? 0.1 : 3 }));
    expect(
      thinnest({
        nodes,
        links: [
          [0, 1],
          [1, 2],
        ],
      }),
    ).toBe(3);
    expect(thinnest(ball(4))).toBe(4);
  });
});
