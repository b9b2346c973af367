/** Every registered kernel with parameters to test it at: widths near 1, exponents on and between those with closed forms. */
import { kernels } from '../../src/kernel/index.ts';
import type { Kernel, KernelParams } from '../../src/kernel/kernel.ts';

export interface Variant {
  readonly title: string;
  readonly kernel: Kernel;
  readonly params: KernelParams;
  readonly exponent: number;
}

const VALUES = { s: [0.75], R: [2.5], n: [1.25, 2, 2.5, 3, 4, 5, 6, 7.25, 8] } as const;

export const variants: readonly Variant[] = kernels.flatMap((kernel) =>
  kernel.params
    .reduce<KernelParams[]>(
      (sets, { name }) => sets.flatMap((set) => VALUES[name].map((value) => ({ ...set, [name]: value }))),
      [{}],
    )
    .map((params) => {
      const given = Object.entries(params).map(([name, value]) => `${name} = ${value}`);
      return {
        title: [kernel.name, ...given].join(' '),
        kernel,
        params,
        exponent: params.n ?? 4,
      };
    }),
);
