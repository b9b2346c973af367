/** A thick body and thin limbs, each with its own width of the kernel; an arc becomes pieces by its width, radii weights. */
import type { SkelsNode } from '../../src/field/node.ts';
import { kernelNamed } from '../../src/kernel/index.ts';
import { lineWeight, pointWeight, widthFor } from '../../src/skeleton/weight.ts';

const arc = { type: 'arc', angle: 3, fieldError: 1e-3, distance: 1 } as const;

export function widths(name: string): SkelsNode {
  const kernel = kernelNamed(name)!;
  const [thick, thin] = [widthFor(kernel, {}, 10), widthFor(kernel, {}, 1.5)];
  return {
    type: 'skels',
    kernel: name,
    params: {},
    threshold: 0.5,
    skels: [
      {
        skel: { type: 'point', at: [0, 0, 0], weight: pointWeight(kernel, thick, 10, 0.5) },
        params: thick,
        colour: [1, 0, 0],
      },
      {
        skel: {
          type: 'segment',
          a: [6, 2, 0],
          b: [20, 9, 3],
          weights: [lineWeight(kernel, thin, 1.5, 0.5)],
        },
        params: thin,
        colour: [0, 0, 1],
      },
      { skel: { type: 'segment', a: [-6, 0, 0], b: [-16, 6, 0], weights: [lineWeight(kernel, {}, 2, 0.5)] } },
      {
        skel: { ...arc, centre: [0, 14, 0], start: [0, 8, 0], axis: [0, 0, 1], radii: [1.5, 1] },
        params: thin,
      },
      {
        skel: { ...arc, centre: [0, -12, 0], start: [0, -8, 0], axis: [1, 0, 0], radii: [3, 2] },
        params: thick,
      },
    ],
  };
}
