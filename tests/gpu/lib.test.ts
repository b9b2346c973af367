/** The functions that WGSL leaves loose, against the float64 ones of the engine. */
import { afterAll, expect, it } from 'vitest';
import { SHADERS } from '../../src/gpu/shaders.ts';
import { random } from '../fixtures/random.ts';
import { compute, withDevice } from './compute.ts';
import { closeDawn, describeGpu } from './dawn.ts';

afterAll(closeDawn);

const COUNT = 20_000;

/** `call` of (x, y) for each pair. */
async function apply(module: string, call: string, pairs: Float32Array<ArrayBuffer>): Promise<Float32Array> {
  const test = `#import ${module}
    @group(0) @binding(0) var<storage, read> pairs: array<vec2f>;
    @group(0) @binding(1) var<storage, read_write> out: array<f32>;
    @compute @workgroup_size(64) fn main(@builtin(global_invocation_id) id: vec3u) {
      if (id.x >= arrayLength(&out)) { return; }
      let p = pairs[id.x];
      out[id.x] = ${call};
    }`;
  const count = pairs.length / 2;
  return withDevice((device) => compute(device, { ...SHADERS, test }, pairs.buffer, count, count));
}

/** Signed, over ±`decades` powers of ten. */
function wide(seed: number, decades: number): Float32Array<ArrayBuffer> {
  const uniform = random(seed);
  return Float32Array.from({ length: 2 * COUNT }, () => {
    const size = 10 ** (decades * (2 * uniform() - 1));
    return uniform() < 0.5 ? -size : size;
  });
}

function worst(got: Float32Array, wanted: (x: number, y: number) => number, pairs: Float32Array): number {
  let largest = 0;
  got.forEach((value, i) => {
    const truth = wanted(pairs[2 * i]!, pairs[2 * i + 1]!);
    const error = truth === 0 ? Math.abs(value) : Math.abs(value / truth - 1);
    largest = error <= largest ? largest : error;
  });
  return largest;
}

describeGpu('WGSL’s mathematics of our own', () => {
  it('angle_of is atan2 (seed 1)', async () => {
    const pairs = wide(1, 6);
    pairs.set([0, 0, 0, 1, 0, -1, 1, 0, -1, 0, 1, 1, -1, -1, 1, -1]);
    const angles = await apply('lib/atan', 'angle_of(p.x, p.y)', pairs);
    expect(worst(angles, Math.atan2, pairs)).toBeLessThan(3e-7);
  });

  it('log_1p keeps its digits down to 0 (seed 2)', async () => {
    const pairs = wide(2, 12).map(Math.abs);
    const logs = await apply('lib/log', 'log_1p(p.x)', pairs);
    expect(worst(logs, Math.log1p, pairs)).toBeLessThan(3e-7);
  });

  it('arsinh is odd and keeps its digits (seed 3)', async () => {
    const pairs = wide(3, 8);
    const values = await apply('lib/log', 'arsinh(p.x)', pairs);
    expect(worst(values, Math.asinh, pairs)).toBeLessThan(5e-7);
  });

  it('tan_of keeps its digits up to a right angle (seed 4)', async () => {
    const uniform = random(4);
    const pairs = Float32Array.from({ length: 2 * COUNT }, () => 3.14 * (uniform() - 0.5));
    const values = await apply('lib/tan', 'tan_of(p.x)', pairs);
    // near π/2 the rounding of π itself counts: 1e-7 over the distance from it
    const allowed = (x: number) => 5e-7 + 1e-7 / (Math.PI / 2 - Math.abs(x));
    values.forEach((value, i) => {
      const x = pairs[2 * i]!;
      expect(Math.abs(value / Math.tan(x) - 1)).toBeLessThan(allowed(x));
    });
  });
});
