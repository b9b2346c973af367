/** How kernels change within a ball, in float32: as much as src/kernel/change.ts says, and never noticeably less where that bounds. */
import { afterAll, expect, it } from 'vitest';
import { brickModules } from '../../src/gpu/bricks/stages.ts';
import { noIngredients } from '../../src/gpu/ingredients.ts';
import { powerChange, Step } from '../../src/kernel/change.ts';
import { gaussian } from '../../src/kernel/gaussian.ts';
import type { Kernel } from '../../src/kernel/kernel.ts';
import { quartic } from '../../src/kernel/quartic.ts';
import { Lot } from '../field/lot.ts';
import { compute, withDevice } from './compute.ts';
import { closeDawn, describeGpu } from './dawn.ts';

afterAll(closeDawn);

const COUNT = 2000;
/** of bounds: a tenth of the margin that is put on them (shaders/skeleton/look.wgsl) */
const CLOSE = 1e-5;

const main = (body: string) => `#import kernel/change
@group(0) @binding(0) var<storage, read> cases: array<vec4f>;
@group(0) @binding(1) var<storage, read_write> values: array<f32>;
@compute @workgroup_size(64)
fn main(@builtin(global_invocation_id) id: vec3u) {
  let i = id.x;
  if (i >= arrayLength(&cases)) { return; }
  let one = cases[i];
  ${body}
}
`;

/** Four numbers a case. */
const run = (kernel: 'power' | 'cauchy', body: string, cases: Float32Array<ArrayBuffer>) =>
  withDevice((device) => {
    const modules = brickModules({ ...noIngredients(), kernels: new Set([kernel]) });
    const count = cases.length / 4;
    return compute(device, { ...modules, test: main(body) }, cases.buffer, 4 * count, count);
  });

/** core, n, r, by */
const POWERS = `let factors = power_factors(one.x, one.y, one.z, one.w);
  let theta = one.w / sqrt(one.x + one.z * one.z);
  values[4u * i] = factors.x;
  values[4u * i + 1u] = factors.y;
  values[4u * i + 2u] = power_rest(min(theta, 0.99), one.y, 2u);
  values[4u * i + 3u] = power_rest(min(theta, 0.99), one.y, 3u);`;

const SLOPES = `for (var d = 0u; d < 2u; d++) {
    let slopes = select(gaussian_slopes(one.x, d + u32(one.y)), quartic_slopes(one.x, d + u32(one.y)), one.z > 0.5);
    values[4u * i + 2u * d] = slopes.x;
    values[4u * i + 2u * d + 1u] = slopes.y;
  }`;

/** (1 − θ)^−n from that term of its series on, all of them positive. */
function restOf(theta: number, n: number, first: number): number {
  let [term, sum] = [1, 0];
  for (let m = 1; m <= first || term > 1e-12 * sum; m++) {
    term *= (theta * (n + m - 1)) / m;
    if (m >= first) sum += term;
  }
  return sum;
}

describeGpu('kernels within a ball', () => {
  it.each([
    ['cauchy', [1, 2, 3, 4, 5]],
    ['power', [1, 1.5, 2, 4, 4.5, 6, 8]],
  ] as const)(
    `change as in float64, by the pipelines of %s (${COUNT} cases, seed 111)`,
    async (kernel, powers) => {
      const lot = new Lot(111);
      const all = lot.many(COUNT, () => {
        const core = lot.one([0, 1] as const);
        const r = 10 ** lot.between(-2, 2);
        return [core, lot.one(powers), r, Math.sqrt(core + r * r) * 10 ** lot.between(-4, 0.5)].map(
          Math.fround,
        );
      }) as [0 | 1, number, number, number][];
      const values = await run(kernel, POWERS, Float32Array.from(all.flat()));
      all.forEach(([core, n, r, by], i) => {
        const [least, most, second, third] = values.subarray(4 * i, 4 * i + 4);
        const step = Object.assign(new Step(), { r, by, near: Math.max(r - by, 0), exponent: n });
        const change = powerChange(core);
        change.factors(step);
        expect(least! / step.least).toBeLessThan(1 + CLOSE);
        expect(least!).toBeGreaterThan(0.999 * step.least - 1e-30);
        if (step.most < 1e10) expect(Math.abs(most! / step.most - 1)).toBeLessThan(2 * CLOSE);
        else expect(most!).toBeGreaterThan(0.99e10);
        if (!(by / Math.sqrt(core + r * r) < 0.98)) return;
        for (const [first, rest] of [
          [2, second!],
          [3, third!],
        ] as const) {
          const ratio = rest / restOf(by / Math.sqrt(core + r * r), n, first);
          expect(ratio).toBeGreaterThan(1 - 3 * CLOSE);
          expect(ratio).toBeLessThan(1.01);
        }
      });
    },
  );

  it(`bend as in float64 close to where they are largest (${COUNT} cases, seed 113)`, async () => {
    const lot = new Lot(113);
    const all = lot.many(COUNT, () =>
      [1, lot.one([1, 2, 4, 4.5, 6]), lot.between(0, 2.4), lot.between(0.01, 2)].map(Math.fround),
    ) as [1, number, number, number][];
    const bent = 'values[4u * i] = power_bent(one.x, one.y, one.z, one.w);';
    const values = await run('power', bent, Float32Array.from(all.flat()));
    const ratios = all.map(([core, n, r, by], i) => {
      const step = Object.assign(new Step(), { r, by, near: Math.max(r - by, 0), exponent: n });
      powerChange(core).factors(step);
      return values[4 * i]! / step.bend;
    });
    // the generating function may say more
    expect(Math.min(...ratios)).toBeGreaterThan(1 - 3 * CLOSE);
    expect(ratios.filter((ratio) => ratio < 1 + 3 * CLOSE).length).toBeGreaterThan(COUNT / 2);
  });

  it.each([
    ['gaussian', gaussian],
    ['quartic', quartic],
  ] as const)(`have the slopes of %s (${COUNT} cases, seed 112)`, async (name, kernel: Kernel) => {
    const lot = new Lot(112);
    const all = lot.many(COUNT, () => [
      lot.between(0, name === 'quartic' ? 1.1 : 5),
      lot.one([0, 1]),
      Number(name === 'quartic'),
      0,
    ]);
    const values = await run('cauchy', SLOPES, Float32Array.from(all.flat()));
    const { change } = kernel;
    if (change.type !== 'absolute') throw new Error(`${name} changes in proportion`);
    all.forEach(([near, first], i) => {
      for (const d of [0, 1] as const) {
        const step = Object.assign(new Step(), { near: Math.fround(near!) });
        change.slopes(step, (first! + d) as 0 | 1 | 2);
        const [slope, bend] = values.subarray(4 * i + 2 * d, 4 * i + 2 * d + 2);
        expect(Math.abs(slope! - step.slope)).toBeLessThan(2e-5 * (1 + step.slope));
        expect(Math.abs(bend! - step.bend)).toBeLessThan(2e-5 * (1 + step.bend));
      }
    });
  });
});
