/** WGSL = TypeScript for sums whose terms have widths of their own. */
import { afterAll, expect, it } from 'vitest';
import { bindField } from '../../src/field/bind.ts';
import { points } from '../field/trees.ts';
import { widths } from '../field/widths.ts';
import { withDevice } from './compute.ts';
import { closeDawn, describeGpu } from './dawn.ts';
import { evaluated } from './everything.ts';

afterAll(closeDawn);

describeGpu('a sum of several widths on the GPU is its twin', () => {
  it.each(['cauchy', 'quartic'])('%s (200 points, seed 5)', async (kernel) => {
    const node = widths(kernel);
    const field = bindField(node);
    const at = points(200, 25, 5);
    const got = await withDevice((device) => evaluated(device, node, 'points', Float32Array.from(at.flat())));
    at.forEach((p, i) => {
      const rounded = p.map(Math.fround) as unknown as typeof p;
      const value = field.value(...rounded);
      expect(Math.abs(got[4 * i]! - value)).toBeLessThan(1e-5 * (1 + Math.abs(value)));
    });
  });
});
