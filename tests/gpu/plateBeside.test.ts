/** Beside a plate of a singular kernel, close to its plane, WGSL once gave −2.2 for −3.6, and gradients a thousand times too steep. */
import { afterAll, expect, it } from 'vitest';
import { evaluatePairs } from '../../src/gpu/pairs.ts';
import { kernelNamed } from '../../src/kernel/index.ts';
import type { Vec3 } from '../../src/math/vec.ts';
import { bindSkel } from '../../src/skeleton/index.ts';
import type { PolygonSkel } from '../../src/skeleton/skels.ts';
import { random } from '../fixtures/random.ts';
import { withDevice } from './compute.ts';
import { closeDawn, describeGpu } from './dawn.ts';

afterAll(closeDawn);

const COUNT = 400;
/** A plate with a hole, and a bay. */
const PLATE: PolygonSkel = {
  type: 'polygon',
  origin: [0, 0, 0],
  u: [1, 0, 0],
  v: [0, 1, 0],
  loops: [
    [
      [-10, -10],
      [10, -10],
      [3, 0],
      [10, 10],
      [-10, 10],
    ],
    [
      [-6, -3],
      [-6, 3],
      [-2, 0],
    ],
  ],
  weight: 1,
};

/** In the hole, in the bay, outside, over the plate. */
function places(seed: number): Vec3[] {
  const next = random(seed);
  const middles = [
    [-4.5, 0, 1],
    [9, 0, 1.5],
    [14, 3, 2],
    [0, 7, 2.5],
  ] as const;
  return Array.from({ length: COUNT }, (_, i) => {
    const [x, y, half] = middles[i % 4]!;
    const z = (i % 8 < 4 ? 1 : -1) * 10 ** (-4 * next());
    return [x + half * (2 * next() - 1), y + half * (2 * next() - 1), z].map(Math.fround) as unknown as Vec3;
  });
}

describeGpu(`close to the plane of a plate (${COUNT} places, seed 51)`, () => {
  it.each([
    ['inverse', 1e-6, 1e-5],
    ['inverseSquared', 1e-5, 0.05],
    ['inverseCubic', 5e-3, 0.02],
    ['inverseQuintic', 0.02, 0.3],
  ] as const)('%s is right to %d, its gradient to %d', async (name, valueShare, gradientShare) => {
    const kernel = kernelNamed(name)!;
    const at = places(51);
    const skels = at.map(() => ({ skel: PLATE, kernel, params: {} }));
    const got = await withDevice((device) => evaluatePairs(device, skels, Float32Array.from(at.flat())));
    const field = bindSkel(PLATE, kernel, {});
    const out = new Float64Array(4);
    let [value, gradient] = [0, 0];
    at.forEach((p, i) => {
      out.fill(0);
      field.add(...p, 1, out);
      const slope = Math.hypot(out[1]!, out[2]!, out[3]!);
      const off = Math.hypot(...[1, 2, 3].map((k) => got[4 * i + k]! - out[k]!));
      value = Math.max(value, Math.abs(got[4 * i]! / out[0]! - 1));
      gradient = Math.max(gradient, off / slope);
    });
    console.info(`${name}: value ${value.toExponential(1)}, gradient ${gradient.toExponential(1)}`);
    expect(value).toBeLessThan(valueShare);
    expect(gradient).toBeLessThan(gradientShare);
  });
});
