import { afterAll, expect, it } from 'vitest';
import { BATCH } from '../../src/gpu/dispatch.ts';
import { evaluatePairs } from '../../src/gpu/pairs.ts';
import { kernelNamed } from '../../src/kernel/index.ts';
import { bindSkel } from '../../src/skeleton/index.ts';
import type { Skel } from '../../src/skeleton/skels.ts';
import { withDevice } from './compute.ts';
import { closeDawn, describeGpu } from './dawn.ts';

afterAll(closeDawn);

const LINE: Skel = { type: 'segment', a: [-2, 0, 1], b: [2, 1, 0], weights: [1, 0.25] };
const DOT: Skel = { type: 'point', at: [0, 2, 0], weight: 1.5 };
const SKELS = [
  { skel: LINE, kernel: kernelNamed('inverse')!, params: {} },
  { skel: DOT, kernel: kernelNamed('inverse')!, params: {} },
  { skel: LINE, kernel: kernelNamed('quartic')!, params: { R: 3 } },
];

describeGpu('pairs', () => {
  it('give each skel, of whatever kernel, its own point', async () => {
    await withDevice(async (device) => {
      const at = [0.5, 1, 1.5, 0.25, 0.5, 0.75, -1, 0.5, 0.5];
      const values = await evaluatePairs(device, SKELS, Float32Array.from(at));
      SKELS.forEach(({ skel, kernel, params }, i) => {
        const truth = new Float64Array(4);
        const [x, y, z] = at.slice(3 * i, 3 * i + 3) as [number, number, number];
        bindSkel(skel, kernel, params).add(x, y, z, 1, truth);
        truth.forEach((number, k) => {
          expect(Math.abs(values[4 * i + k]! - number)).toBeLessThan(1e-5 * (1 + Math.abs(number)));
        });
      });
    });
  });

  it('want as many points as skels, and may be none', async () => {
    await withDevice(async (device) => {
      await expect(evaluatePairs(device, SKELS, new Float32Array(3))).rejects.toThrow('1 points for 3 skels');
      expect(await evaluatePairs(device, [], new Float32Array())).toEqual(new Float32Array());
      const many = new Array(BATCH + 1).fill(SKELS[0]);
      await expect(evaluatePairs(device, many, new Float32Array(3 * many.length))).rejects.toThrow(
        'more than',
      );
    });
  });
});
