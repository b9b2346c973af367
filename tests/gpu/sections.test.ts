/** WGSL = TypeScript for cross sections and the warp by them, numbers rounded to float32 before both see them. */
import { afterAll, beforeAll, expect, it } from 'vitest';
import { extrusion } from '../../src/field/extrusion.ts';
import { polarProfile } from '../../src/field/polarProfile.ts';
import type { Section } from '../../src/field/section.ts';
import { superQuadric } from '../../src/field/superQuadric.ts';
import { bindWarped } from '../../src/field/warp.ts';
import { SHADERS } from '../../src/gpu/shaders.ts';
import type { Vec3 } from '../../src/math/vec.ts';
import type { SkelField } from '../../src/skeleton/skeleton.ts';
import { random } from '../fixtures/random.ts';
import { compute, withDevice } from './compute.ts';
import { closeDawn, describeGpu } from './dawn.ts';

afterAll(closeDawn);

const COUNT = 20_000;
const SEED = 32;
const OUT = 4;
/** An m below it is as good as 0: |y|^100 is no float32. */
const LEAST_STRETCH = 1e-12;
const EXPONENTS = [0.3, 0.5, 1, 2, 4, 50, 100].map(Math.fround);
const PROFILES = profiles(3, 33);

/** The warp: a point with an extruded section, of which the plain field is linear. */
const ORIGIN: Vec3 = [5, -3, 2];
const AXES: readonly Vec3[] = [
  [0.6, 0.8, 0],
  [0, 0, 1],
  [0.8, -0.6, 0],
];
const SCALE = [1.5, 0.75] as const;
const LINEAR = [0.5, -2, 1] as const;
const WARP_EXPONENT = 4;
/** of the points along z of the skel's frame */
const HEIGHT = 1.25;

const vec3f = (v: Iterable<number>) => `vec3f(${[...v]})`;

const heldProfiles = `const PROFILES = array<array<vec2f, 12>, ${PROFILES.length}>(${PROFILES.map((radii) => {
  const pairs = Array.from({ length: 12 }, (_, k) => `vec2f(${radii[2 * k]!}, ${radii[2 * k + 1]!})`);
  return `array<vec2f, 12>(${pairs})`;
})});
fn profile_radii(profile: u32, k: u32) -> vec2f { return PROFILES[profile][k]; }`;

const test = `#import field/superQuadric
#import field/extrusion
#import field/polarProfile
#import field/warp
@group(0) @binding(0) var<storage, read> cases: array<vec4f>;
@group(0) @binding(1) var<storage, read_write> out: array<vec4f>;
const AXES = mat3x3f(${AXES.map(vec3f)});
const SCALE = vec2f(${SCALE});
@compute @workgroup_size(64) fn main(@builtin(global_invocation_id) id: vec3u) {
  let i = id.x;
  if (i >= arrayLength(&out) / ${OUT}u) { return; }
  let c = cases[i];
  out[${OUT}u * i] = vec4f(super_quadric(c.xy, c.z), 0.0);
  out[${OUT}u * i + 1u] = vec4f(extrusion(c.xy, max(c.z, 2.0)), 0.0);
  out[${OUT}u * i + 2u] = vec4f(polar_profile(c.xy, u32(c.w)), 0.0);
  let p = ${vec3f(ORIGIN)} + AXES * vec3f(c.xy, ${HEIGHT});
  let q = warp_place(p, ${vec3f(ORIGIN)}, AXES, SCALE);
  let stretch = extrusion(q.xy, ${WARP_EXPONENT}.0);
  let value = dot(warp_mapped(q, stretch), vec3f(${LINEAR}));
  out[${OUT}u * i + 3u] = vec4f(value, warp_gradient(q, stretch, vec3f(${LINEAR}), AXES, SCALE));
}`;

function profiles(count: number, seed: number): readonly (readonly number[])[] {
  const next = random(seed);
  // the last one is as wild as drawn sections can be
  return Array.from({ length: count }, (_, i) =>
    Array.from({ length: 24 }, () => Math.fround(i < count - 1 ? 0.7 + 0.6 * next() : 0.05 + 2 * next())),
  );
}

/** x, y, α, profile: near the skel, over 1e±15, on the axes, on the diagonals, beside them, at the origin. */
function casesOf(seed: number): Float32Array<ArrayBuffer> {
  const next = random(seed);
  const signed = (decades: number) => (next() < 0.5 ? -1 : 1) * 10 ** (decades * (2 * next() - 1));
  return Float32Array.from(
    Array.from({ length: COUNT }, (_, i) => {
      const x = i % 16 === 0 ? 0 : i % 2 ? 4 * next() - 2 : signed(15);
      const nearly = 1 + 1e-4 * signed(3);
      const ys = [i % 64 === 0 ? 0 : signed(6), 0, x, -x, x * nearly, -x * nearly, signed(15), signed(1)];
      const y = ys[i % 16] ?? (i % 2 ? 4 * next() - 2 : x * signed(2));
      return [x, y, EXPONENTS[i % EXPONENTS.length]!, i % PROFILES.length];
    }).flat(),
  );
}

interface Case {
  readonly x: number;
  readonly y: number;
  readonly exponent: number;
  readonly profile: number;
  /** the four results of the device */
  readonly got: readonly (readonly number[])[];
}

/** Errors of m, and of ∂m times the distance ρ from the skel, in units of m + ρ |∂m|: what rounding the input makes. */
function worst(cases: readonly Case[], which: number, section: Section): { value: number; slope: number } {
  const out = new Float64Array(3);
  let [value, slope] = [0, 0];
  for (const { x, y, got } of cases) {
    section.evaluate(x, y, out);
    const [m, mx, my] = got[which] as [number, number, number];
    const rho = Math.hypot(x, y);
    const scale = Math.max(LEAST_STRETCH, out[0]! + rho * Math.hypot(out[1]!, out[2]!));
    const errors = [
      Math.abs(m - out[0]!) / scale,
      (rho * Math.hypot(mx - out[1]!, my - out[2]!)) / scale,
    ] as const;
    // NaN is the worst
    value = errors[0] <= value ? value : errors[0];
    slope = errors[1] <= slope ? slope : errors[1];
  }
  return { value, slope };
}

describeGpu(`cross sections in WGSL are their twins (${COUNT} points, seed ${SEED})`, () => {
  let cases: readonly Case[] = [];

  beforeAll(async () => {
    const input = casesOf(SEED);
    const modules = { ...SHADERS, test, 'field/profiles': heldProfiles };
    const numbers = await withDevice((device) =>
      compute(device, modules, input.buffer, 4 * OUT * COUNT, COUNT),
    );
    cases = Array.from({ length: COUNT }, (_, i) => {
      const [x, y, exponent, profile] = input.subarray(4 * i, 4 * i + 4) as unknown as number[];
      const got = Array.from({ length: OUT }, (_, k) => {
        const from = 4 * (OUT * i + k);
        return [...numbers.subarray(from, from + 4)];
      });
      return { x: x!, y: y!, exponent: exponent!, profile: profile!, got };
    });
  });

  it.each(EXPONENTS)('super-quadric, α = %d', (exponent) => {
    const section = superQuadric({ type: 'superQuadric', exponent });
    const own = cases.filter((c) => c.exponent === exponent);
    const error = worst(own, 0, section);
    expect(error.value).toBeLessThan(1e-6);
    expect(error.slope).toBeLessThan(3e-6);
  });

  it.each([2, 4, 50, 100])('extrusion, α = %d', (exponent) => {
    const section = extrusion({ type: 'extrusion', exponent });
    const own = cases.filter((c) => Math.max(c.exponent, 2) === exponent);
    const error = worst(own, 1, section);
    expect(error.value).toBeLessThan(2e-6);
    expect(error.slope).toBeLessThan(1e-5);
  });

  it.each(PROFILES.map((radii, i) => [i, radii] as const))('polar profile %d', (i, radii) => {
    const section = polarProfile({ type: 'polar', radii });
    const own = cases.filter((c) => c.profile === i);
    const error = worst(own, 2, section);
    expect(error.value).toBeLessThan(2e-6);
    expect(error.slope).toBeLessThan(1e-5);
  });

  it('a warped skel: place, value and gradient of a linear field', () => {
    const [lx, ly, lz] = LINEAR;
    const linear: SkelField = {
      box: { min: [0, 0, 0], max: [0, 0, 0] },
      value: (x, y, z) => lx * x + ly * y + lz * z,
      add(x, y, z, factor, out) {
        [lx * x + ly * y + lz * z, ...LINEAR].forEach((term, k) => {
          out[k]! += factor * term;
        });
      },
      isCubic: false,
      spread: () => {},
      ahead: () => {},
      standIn: () => 0,
      apart: () => Infinity,
      missed: () => Infinity,
      offset: () => 0,
    };
    const field = bindWarped(
      { type: 'point', at: ORIGIN, weight: 1 },
      {
        section: { type: 'extrusion', exponent: WARP_EXPONENT },
        scale: SCALE,
        up: AXES[1]!,
        along: AXES[2]!,
      },
      () => linear,
    );
    const out = new Float64Array(4);
    let [value, gradient] = [0, 0];
    // where float32 holds the place beside the origin
    for (const { x, y, got } of cases.filter(
      (c) => Math.hypot(c.x, c.y) > 0.1 && Math.hypot(c.x, c.y) < 30,
    )) {
      const p = ORIGIN.map((o, k) => o + AXES[0]![k]! * x + AXES[1]![k]! * y + AXES[2]![k]! * HEIGHT);
      out.fill(0);
      field.add(p[0]!, p[1]!, p[2]!, 1, out);
      const [v, ...g] = got[3]!;
      const steep = Math.hypot(out[1]!, out[2]!, out[3]!);
      value = Math.max(value, Math.abs(v! - out[0]!) / (steep * (10 + Math.hypot(x, y))));
      g.forEach((slope, k) => {
        gradient = Math.max(gradient, Math.abs(slope - out[k + 1]!) / steep);
      });
    }
    expect(value).toBeLessThan(2e-6);
    expect(gradient).toBeLessThan(1e-5);
  });
});
