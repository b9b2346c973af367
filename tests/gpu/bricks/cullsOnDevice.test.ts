/** Which trees the device culls, and how much of its errors each leaf of them may bring. */
import { describe, expect, it } from 'vitest';
import type { FieldNode, Term } from '../../../src/field/node.ts';
import { cullsOnDevice, LARGEST } from '../../../src/gpu/bricks/cullsOnDevice.ts';
import { sharesOf } from '../../../src/gpu/bricks/shares.ts';
import { kernels } from '../../../src/kernel/index.ts';
import { BONE, body, placed, sphere } from '../../field/trees.ts';

const union = (form: 'hard' | 'smooth', parts: readonly FieldNode[]): FieldNode => ({
  type: 'union',
  form,
  parts,
});
const points = (count: number): FieldNode =>
  body(
    Array.from({ length: count }, (_, i): Term => ({ skel: { type: 'point', at: [i, 0, 0], weight: 1 } })),
  );

describe('the device culls', () => {
  it.each(kernels.map(({ name }) => name))(
    'segments and points of %s, and plates if it is not singular',
    (kernel) => {
      const { homogeneity } = kernels.find(({ name }) => name === kernel)!;
      const of = (terms: readonly Term[]) => ({ ...body(terms), kernel, params: {} });
      expect(cullsOnDevice(of(BONE.slice(0, 2)))).toBe(true);
      expect(cullsOnDevice(of(BONE))).toBe(homogeneity === 0);
    },
  );

  it('up to 32 bodies and so many terms', () => {
    expect(
      cullsOnDevice(
        union(
          'hard',
          Array.from({ length: 32 }, () => body()),
        ),
      ),
    ).toBe(true);
    expect(
      cullsOnDevice(
        union(
          'hard',
          Array.from({ length: 33 }, () => body()),
        ),
      ),
    ).toBe(false);
    expect(
      cullsOnDevice(
        union(
          'hard',
          Array.from({ length: 60 }, () => sphere(1)),
        ),
      ),
    ).toBe(true);
    expect(cullsOnDevice(points(LARGEST.terms))).toBe(true);
    expect(cullsOnDevice(points(LARGEST.terms + 1))).toBe(false);
  });

  it('nothing that has no field', () => {
    expect(() => cullsOnDevice(body(BONE, 0))).toThrow('threshold must be above 0');
  });
});

describe('shares', () => {
  const a = sphere(1);

  it('are whole under hard unions, wherever they were put', () => {
    expect(sharesOf(placed(union('hard', [a, union('hard', [a, a])]), 1, 2, 3))).toEqual([1, 1, 1]);
  });

  it('are what is left of the budget after the operations that a part passes', () => {
    // two unions double what the first two parts miss twice, the last one once
    expect(sharesOf(union('smooth', [a, a, a]))).toEqual([1 / 12, 1 / 12, 1 / 6]);
    expect(sharesOf({ type: 'morph', from: a, to: union('hard', [a, a]), t: 0.3 })).toEqual([0.5, 0.5, 0.5]);
    expect(sharesOf({ type: 'blend', a, b: a, a0: -2, a1: 1, a2: 1 })).toEqual([1 / 6.6, 1 / 6.6]);
  });
});
