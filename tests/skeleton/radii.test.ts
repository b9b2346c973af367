/** Radii instead of weights: the isosurface is where they say. */
import { describe, expect, test } from 'vitest';
import { bindField } from '../../src/field/bind.ts';
import type { AnySkel } from '../../src/field/expand.ts';
import type { TreeField } from '../../src/field/treeField.ts';
import { kernelNamed } from '../../src/kernel/index.ts';
import type { KernelParams } from '../../src/kernel/kernel.ts';
import { cos, sin, TAU } from '../../src/math/trig.ts';
import type { Vec3 } from '../../src/math/vec.ts';
import { hasRadii, type RoundSkel, weighted } from '../../src/skeleton/radii.ts';
import { FieldError } from '../../src/skeleton/skeleton.ts';
import { variants } from '../kernel/variants.ts';

const RADIUS = 1.5;
const T = 0.4;

const bound = (kernel: string, params: KernelParams, ...skels: AnySkel[]): TreeField =>
  bindField({ type: 'skels', kernel, params, threshold: T, skels: skels.map((skel) => ({ skel })) });

/** How far from `from` the surface is, in the direction of a unit vector. */
function surfaceAt(field: TreeField, from: Vec3, to: Vec3): number {
  let [inside, outside] = [0, 8];
  for (let i = 0; i < 55; i++) {
    const r = 0.5 * (inside + outside);
    const value = field.value(from[0] + r * to[0], from[1] + r * to[1], from[2] + r * to[2]);
    if (value > 0) inside = r;
    else outside = r;
  }
  return inside;
}

/** An even line along x, `length` mm, its middle at the origin. */
const line = (length: number, ...radii: number[]): RoundSkel => ({
  type: 'polyline',
  points: radii.map((_, i) => [length * (i / (radii.length - 1) - 0.5), 0, 0]),
  radii,
  closed: false,
});

/** What the two ends that a line of 40 radii lacks are worth, in radii: the tail of f beyond 20 radii. */
const ENDS: Readonly<Record<string, number>> = {
  gaussian: 1e-14,
  quartic: 1e-14,
  inverse: 1e-14,
  inverseQuintic: 1e-6,
  cauchy: 1e-4,
  inverseCubic: 1e-3,
  inverseSquared: 0.04,
};

describe.each(variants)('radii with the kernel $title', ({ kernel, params, exponent }) => {
  test('a long even polyline is as thick in its middle as it says', () => {
    const radii = [1, 2, 3, 4, 5].map(() => RADIUS);
    const field = bound(kernel.name, params, line(40 * RADIUS, ...radii));
    // (1 + s²r²)^(−n/2) falls as r^−n, too slowly below 2 for any line to be a long one: here its middle is below T
    if (kernel.name === 'power' && exponent < 2) {
      const lacking = field.value(0, 0.6 * RADIUS, 0.8 * RADIUS);
      expect(lacking).toBeLessThan(0);
      expect(lacking).toBeGreaterThan(-T);
      return;
    }
    const thickness = surfaceAt(field, [0, 0, 0], [0, 0.6, 0.8]) / RADIUS;
    expect(Math.abs(thickness - 1)).toBeLessThan(ENDS[kernel.name] ?? 1.6 * 20 ** (1 - exponent));
  });

  test('a lone point is a ball of its radius', () => {
    const field = bound(kernel.name, params, { type: 'point', at: [1, 2, 3], radius: RADIUS });
    expect(surfaceAt(field, [1, 2, 3], [0, 0.6, -0.8])).toBeCloseTo(RADIUS, 12);
  });

  test('a segment is the polyline of its two ends, an even NURBS curve an even line', () => {
    const { type, radii } = line(9, 1, 2) as Extract<RoundSkel, { type: 'polyline' }>;
    expect(type).toBe('polyline');
    const ends = { a: [-4.5, 0, 0], b: [4.5, 0, 0] } as const;
    const [one, other] = [
      bound(kernel.name, params, { type: 'segment', ...ends, radii: [radii[0]!, radii[1]!] }),
      bound(kernel.name, params, line(9, 1, 2)),
    ];
    expect(one.value(1, 2, 3)).toBe(other.value(1, 2, 3));
    const even = [-4.5, -2, 1, 4.5].map((x): Vec3 => [x, 0, 0]);
    const curve = { type: 'nurbs', points: even, radii: [1, 1, 1, 1], density: 5 } as const;
    const wanted = bound(kernel.name, params, line(9, 1, 1)).value(1, 2, 3);
    expect(Math.abs(bound(kernel.name, params, curve).value(1, 2, 3) - wanted)).toBeLessThan(1e-11);
  });
});

describe('radii', () => {
  const ring = (count: number): RoundSkel => {
    const angles = Array.from({ length: count }, (_, i) => (i * TAU) / count);
    const points = angles.map((angle): Vec3 => [30 * cos(angle), 0, 30 * sin(angle)]);
    return { type: 'polyline', points, radii: points.map(() => RADIUS), closed: true };
  };
  const turn: RoundSkel = {
    type: 'arc',
    centre: [0, 0, 0],
    start: [30, 0, 0],
    axis: [0, 1, 0],
    angle: TAU,
    radii: [RADIUS, RADIUS],
    fieldError: 1e-3,
    distance: 0,
  };

  test.each([
    ['cauchy', { s: 0.6 }],
    ['gaussian', { s: 0.5 }],
    ['quartic', { R: 4 }],
    ['power', { s: 0.6, n: 5 }],
  ] satisfies [string, KernelParams][])(
    'the tube of a ring of 20 radii has its radius up and down, a little more inwards than outwards, %s',
    (kernel, params) => {
      for (const skel of [ring(96), turn]) {
        const field = bound(kernel, params, skel);
        expect(Math.abs(surfaceAt(field, [30, 0, 0], [0, 1, 0]) / RADIUS - 1)).toBeLessThan(2e-3);
        const [outer, inner] = [1, -1].map((x) => surfaceAt(field, [30, 0, 0], [x, 0, 0]));
        expect(Math.abs(outer! + inner! - 2 * RADIUS)).toBeLessThan(0.015 * RADIUS);
        expect(inner! - outer!).toBeGreaterThan(0);
        expect(inner! - outer!).toBeLessThan(0.08 * RADIUS);
      }
    },
  );

  test('the radii of a NURBS curve are subdivided with it, then become weights', () => {
    const points = [0, 20, 40, 60].map((x): Vec3 => [x, 0, 0]);
    const curve = { type: 'nurbs', points, radii: [1, 1, 2.5, 2.5], density: 32 } as const;
    const field = bound('gaussian', { s: 0.6 }, curve);
    for (const t of [0.2, 0.5, 0.8]) {
      const [a, b] = [1, 2.5];
      const radius = (1 - t) ** 3 * a + 3 * t * (1 - t) ** 2 * a + 3 * t * t * (1 - t) * b + t ** 3 * b;
      expect(Math.abs(surfaceAt(field, [60 * t, 0, 0], [0, 0, 1]) / radius - 1)).toBeLessThan(5e-3);
    }
  });

  test('a threshold ten times as high asks for ten times the weight', () => {
    const cauchy = kernelNamed('cauchy')!;
    const [low, high] = [0.1, 1].map((threshold) => weighted(line(9, 1, 2), cauchy, {}, threshold));
    const weights = (skel: typeof low) => (skel as { weights: readonly number[] }).weights;
    weights(low).forEach((weight, i) => {
      expect(weights(high)[i]! / weight).toBeCloseTo(10, 12);
    });
  });

  test('weights are left alone', () => {
    expect(hasRadii({ type: 'point', at: [0, 0, 0], weight: 1 })).toBe(false);
    expect(hasRadii({ type: 'point', at: [0, 0, 0], weight: 1, radius: undefined } as AnySkel)).toBe(false);
  });

  const flat = { type: 'segment', a: [1, 1, 1], b: [1, 1, 1], radii: [1, 1] } as const;
  const points = [0, 1, 2, 3].map((x): Vec3 => [x, 0, 0]);
  test.each<[string, AnySkel, string, RegExp]>([
    ['beyond the support', line(9, 1, 5), 'quartic', /^skels\[1\]\.radii\[1\]: no weight .* radius of 5/],
    ['no radius', line(9, 1, 0, 2), 'cauchy', /^skels\[1\]\.radii\[1\]: the radius must be above 0, found 0/],
    ['no number', line(9, 1, Number.NaN), 'gaussian', /^skels\[1\]\.radii\[1\]: .* found NaN/],
    ['a point', { type: 'point', at: [0, 0, 0], radius: 9 }, 'quartic', /^skels\[1\]\.radius: no weight/],
    ['too many', { ...line(9, 1, 2), points } as AnySkel, 'cauchy', /4 points need as many radii, got 2/],
    [
      'of a control point',
      { type: 'nurbs', points, radii: [1, 1, -2, 1], density: 3 },
      'cauchy',
      /^skels\[1\]\.radii\[2\]: .*found -2/,
    ],
    ['too few', { type: 'nurbs', points, radii: [1], density: 3 }, 'cauchy', /as many radii, got 1/],
    ['nowhere apart', flat, 'cauchy', /^skels\[1\]: a segment with radii needs ends that are apart/],
    ['no length', flat, 'inverse', /^skels\[1\]: radii of the kernel inverse need a length above 0/],
    ['one end', { ...flat, radii: [1] } as never, 'cauchy', /2 radii, found 1/],
    [
      'both',
      { ...flat, weights: [1] } as never,
      'cauchy',
      /^skels\[1\]: a segment has weights or radii, not/,
    ],
    ['a spline', { type: 'quadratic', radii: [1] } as never, 'cauchy', /a quadratic has weights, not radii/],
  ])('%s: refused, with the place', (_, skel, kernel, message) => {
    const make = () =>
      bound(kernel, kernel === 'quartic' ? { R: 4 } : {}, { type: 'point', at: [0, 0, 0], weight: 1 }, skel);
    expect(make).toThrow(FieldError);
    expect(make).toThrow(message);
  });

  test('a threshold that is none is named, not the radii', () => {
    const node = { type: 'skels', kernel: 'cauchy', params: {}, skels: [{ skel: flat }] } as const;
    expect(() => bindField({ ...node, threshold: 0 })).toThrow(/^threshold must be above 0, got 0/);
  });
});
