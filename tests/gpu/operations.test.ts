/** WGSL = TypeScript for the operations on two values, numbers rounded to float32 before both see them. */
import { afterAll, beforeAll, expect, it } from 'vitest';
import { blendUnion } from '../../src/field/blendUnion.ts';
import { hardUnion } from '../../src/field/hardUnion.ts';
import { morph } from '../../src/field/morph.ts';
import type { Operation } from '../../src/field/operation.ts';
import { smoothUnion } from '../../src/field/smoothUnion.ts';
import { SHADERS } from '../../src/gpu/shaders.ts';
import { random } from '../fixtures/random.ts';
import { compute, withDevice } from './compute.ts';
import { closeDawn, describeGpu } from './dawn.ts';

afterAll(closeDawn);

const COUNT = 20_000;
const SEED = 31;
/** vec4f a case: its numbers, and what comes back */
const IN = 2;
const OUT = 5;
const GRADIENT_A = [0.5, -2, 1];
const GRADIENT_B = [-1, 0.25, 3];

const test = `#import field/hardUnion
#import field/blendUnion
#import field/morph
#import field/combined
@group(0) @binding(0) var<storage, read> cases: array<vec4f>;
@group(0) @binding(1) var<storage, read_write> out: array<vec4f>;
@compute @workgroup_size(64) fn main(@builtin(global_invocation_id) id: vec3u) {
  let i = id.x;
  if (i >= arrayLength(&out) / ${OUT}u) { return; }
  let c = cases[${IN}u * i];
  let d = cases[${IN}u * i + 1u];
  let a = vec4f(c.x, ${GRADIENT_A});
  let b = vec4f(c.y, ${GRADIENT_B});
  let smoothed = smooth_union(a.x, b.x);
  out[${OUT}u * i] = vec4f(hard_union(a.x, b.x), 0.0);
  out[${OUT}u * i + 1u] = vec4f(smoothed, share_of_b(smoothed));
  out[${OUT}u * i + 2u] = vec4f(blend_union(a.x, b.x, d.x, d.y, d.z), 0.0);
  out[${OUT}u * i + 3u] = vec4f(morph(a.x, b.x, c.z), 0.0);
  out[${OUT}u * i + 4u] = -combined(-a, -b, smooth_union(-a.x, -b.x));
}`;

/** a, b, t, -, a0, a1, a2, -: any sign over 1e±15, both alike, opposite, 0. */
function casesOf(seed: number): Float32Array<ArrayBuffer> {
  const next = random(seed);
  const size = (decades: number) => 10 ** (decades * (2 * next() - 1));
  const signed = (decades: number) => (next() < 0.5 ? -1 : 1) * size(decades);
  return Float32Array.from(
    Array.from({ length: COUNT }, (_, i) => {
      const a = i % 10 === 1 ? 0 : signed(15);
      const near = 1 + 1e-3 * signed(3);
      const b = [signed(15), signed(15), 0, a, -a, a * near, -a * near][i % 10] ?? signed(15);
      return [a, b, next(), 0, signed(3), size(3), size(3), 0];
    }).flat(),
  );
}

interface Pair {
  readonly a: number;
  readonly b: number;
  readonly t: number;
  readonly amounts: { readonly a0: number; readonly a1: number; readonly a2: number };
  /** the five results of the device */
  readonly got: readonly (readonly number[])[];
}

interface Truth {
  readonly operation: Operation;
  /** by what the error of the value is divided, where that is not 0 */
  readonly value: number;
  /** and that of a partial derivative */
  slope(derivative: number): number;
}

const one = () => 1;
/** what is left of b²/a² and b/a over 1e±30 is no float32 */
const relative = (derivative: number) => Math.max(Math.abs(derivative), 1e-25);

/** The largest errors of value and partial derivatives, and how often the sign is wrong. */
function worst(
  pairs: readonly Pair[],
  which: number,
  truth: (pair: Pair) => Truth,
): { readonly value: number; readonly slope: number; readonly signs: number } {
  const out = new Float64Array(3);
  let [value, slope, signs] = [0, 0, 0];
  for (const pair of pairs) {
    const { operation, ...scale } = truth(pair);
    operation.evaluate(pair.a, pair.b, out);
    const got = pair.got[which]!;
    value = Math.max(value, Math.abs(got[0]! - out[0]!) / (scale.value || 1));
    for (const i of [1, 2]) {
      slope = Math.max(slope, Math.abs(got[i]! - out[i]!) / scale.slope(out[i]!));
    }
    if (Math.sign(got[0]!) !== Math.sign(out[0]!)) signs++;
  }
  return { value, slope, signs };
}

const size = ({ a, b }: Pair): number => Math.max(Math.abs(a), Math.abs(b));

describeGpu(`operations in WGSL are their twins (${COUNT} pairs, seed ${SEED})`, () => {
  let pairs: readonly Pair[] = [];

  beforeAll(async () => {
    const cases = casesOf(SEED);
    const modules = { ...SHADERS, test };
    const numbers = await withDevice((device) =>
      compute(device, modules, cases.buffer, 4 * OUT * COUNT, COUNT),
    );
    pairs = Array.from({ length: COUNT }, (_, i) => {
      const [a, b, t, , a0, a1, a2] = cases.subarray(4 * IN * i) as unknown as number[];
      const got = Array.from({ length: OUT }, (_, k) => {
        const from = 4 * (OUT * i + k);
        return [...numbers.subarray(from, from + 4)];
      });
      return { a: a!, b: b!, t: t!, amounts: { a0: a0!, a1: a1!, a2: a2! }, got };
    });
  });

  it('hard union: to the bit', () => {
    const { value, slope } = worst(pairs, 0, () => ({ operation: hardUnion, value: 1, slope: one }));
    expect([value, slope]).toEqual([0, 0]);
  });

  it('smooth union: relatively exact, so that its sign is right far below both operands', () => {
    const error = worst(pairs, 1, ({ a, b }) => {
      return { operation: smoothUnion, value: Math.abs(smoothUnion.value(a, b)), slope: relative };
    });
    expect(error.signs).toBe(0);
    expect(error.value).toBeLessThan(1e-6);
    expect(error.slope).toBeLessThan(1e-6);
  });

  it('blending union', () => {
    const error = worst(pairs, 2, (pair) => {
      const { a0, a1, a2 } = pair.amounts;
      const slope = () => 1 + Math.abs(a0) * Math.max(1 / a1, 1 / a2);
      return { operation: blendUnion(pair.amounts), value: Math.max(size(pair), Math.abs(a0)), slope };
    });
    expect(error.value).toBeLessThan(2e-6);
    expect(error.slope).toBeLessThan(2e-6);
  });

  it('morph', () => {
    const error = worst(pairs, 3, (pair) => ({ operation: morph(pair.t), value: size(pair), slope: one }));
    expect(error.value).toBeLessThan(5e-7);
    expect(error.slope).toBeLessThan(2e-7);
  });

  it('an intersection is the union of the complements, with its gradient and colours', () => {
    const out = new Float64Array(3);
    let [value, gradient, colour, signs] = [0, 0, 0, 0];
    for (const pair of pairs) {
      const { a, b, got } = pair;
      smoothUnion.evaluate(-a, -b, out);
      const [v, ...g] = got[4]!;
      value = Math.max(value, Math.abs(v! + out[0]!) / (size(pair) || 1));
      if (Math.sign(v!) !== -Math.sign(out[0]!)) signs++;
      g.forEach((x, i) => {
        gradient = Math.max(gradient, Math.abs(x - out[1]! * GRADIENT_A[i]! - out[2]! * GRADIENT_B[i]!));
      });
      smoothUnion.evaluate(a, b, out);
      colour = Math.max(colour, Math.abs(got[1]![3]! - out[2]! / (out[1]! + out[2]!)));
    }
    expect(signs).toBe(0);
    expect(value).toBeLessThan(2e-6);
    expect(gradient).toBeLessThan(1e-5);
    expect(colour).toBeLessThan(1e-6);
  });
});
