/** Skels with a cross section of their own. */
import { describe, expect, test } from 'vitest';
import { bindField } from '../../src/field/bind.ts';
import type { FieldNode, Term } from '../../src/field/node.ts';
import type { Warp } from '../../src/field/warp.ts';
import { pow } from '../../src/math/pow.ts';
import { sin, TAU } from '../../src/math/trig.ts';
import { evaluated, gradientError, lostPoints, placed, points } from './trees.ts';

const up = [0, 0, 1] as const;
const flower = Array.from({ length: 24 }, (_, i) => 1 + 0.3 * sin((i * TAU) / 6));
const warps: readonly (readonly [string, Warp])[] = [
  ['scaled', { section: { type: 'round' }, scale: [1.5, 0.5], up }],
  ['star', { section: { type: 'superQuadric', exponent: 0.6 }, scale: [1, 1], up }],
  ['diamond', { section: { type: 'superQuadric', exponent: 1 }, scale: [1.2, 0.8], up }],
  ['square', { section: { type: 'superQuadric', exponent: 6 }, scale: [1, 2], up: [0, 1, 1] }],
  ['slab', { section: { type: 'extrusion', exponent: 8 }, scale: [1, 0.7], up }],
  ['flower', { section: { type: 'polar', radii: flower }, scale: [1, 1], up: [1, 2, 3] }],
];

const segment = { type: 'segment', a: [-3, 1, 0], b: [4, 0, 2], weights: [2, -0.1] } as const;
const point = { type: 'point', at: [1, 1, -1], weight: 4 } as const;
const polygon = {
  type: 'polygon',
  origin: [0, 0, 1],
  u: [1, 0, 1],
  v: [0, 1, 0],
  loops: [
    [
      [-3, -2],
      [3, -2],
      [0, 3],
    ],
  ],
  weight: 1,
} as const;

const body = (...skels: Term[]): FieldNode => ({
  type: 'skels',
  kernel: 'cauchy',
  params: { s: 0.7 },
  threshold: 1,
  skels,
});

describe('warped skels', () => {
  describe.each(warps)('%s', (_, warp) => {
    test.each([
      ['segment', { skel: segment, warp }],
      ['point', { skel: point, warp: { ...warp, along: [1, 0.2, 0] } }],
      ['polygon', { skel: polygon, warp }],
    ] satisfies [string, Term][])(
      '%s: gradient = differences, the box holds the inside (seed 41)',
      (_, term) => {
        const field = bindField(body(term));
        expect(gradientError(field, points(150, 5, 41))).toBeLessThan(1e-6);
        expect(lostPoints(field, 9, 3000, 41)).toEqual([]);
        expect(field.box!.min.every((x, i) => Number.isFinite(x) && x < field.box!.max[i]!)).toBe(true);
      },
    );
  });

  test('a super-quadric section of a segment: the field is that of the round one at radius 1', () => {
    const long = { type: 'segment', a: [0, 0, -50], b: [0, 0, 50], weights: [1] } as const;
    const plain = bindField(body({ skel: long }));
    for (const exponent of [0.5, 1, 4, 50]) {
      const warp: Warp = { section: { type: 'superQuadric', exponent }, scale: [2, 3], up: [0, 1, 0] };
      const field = bindField(body({ skel: long, warp }));
      for (const u of [0, 0.1, 0.5, 0.9, 1]) {
        const [x, y] = [2 * pow(u, 1 / exponent), -3 * pow(1 - u, 1 / exponent)];
        expect(field.value(x, y, 3)).toBeCloseTo(plain.value(1, 0, 3), 13);
      }
    }
  });

  test('a round section without scaling is the plain skel (seed 42)', () => {
    const warp: Warp = { section: { type: 'round' }, scale: [1, 1], up };
    const [plain, warped] = [bindField(body({ skel: segment })), bindField(body({ skel: segment, warp }))];
    for (const p of points(100, 6, 42)) {
      evaluated(plain, p).forEach((x, i) => {
        expect(evaluated(warped, p)[i]).toBeCloseTo(x, 12);
      });
    }
  });

  test('the extrusion is a slab: half as thick as its scale in y, whatever the weight', () => {
    for (const weight of [1, 2, 4]) {
      const warp: Warp = { section: { type: 'extrusion', exponent: 50 }, scale: [1, 3], up: [0, 1, 0] };
      const long = { type: 'segment', a: [0, 0, -20], b: [0, 0, 20], weights: [weight] } as const;
      const field = bindField(body({ skel: long, warp }));
      expect(field.value(0, 2.7, 0)).toBeGreaterThan(0);
      expect(field.value(0, 3.3, 0)).toBeLessThan(0);
    }
  });

  test.each([2, 5, 100])('an extruded skel may be thicker than a kilometre, exponent %d', (exponent) => {
    const warp: Warp = { section: { type: 'extrusion', exponent }, scale: [1, 1], up: [0, 1, 0] };
    for (const radius of [1e5, 2e6]) {
      const skel: Term['skel'] = {
        type: 'segment',
        a: [0, 0, -9e6],
        b: [0, 0, 9e6],
        radii: [radius, radius],
      };
      const field = bindField({ ...body({ skel, warp }), params: { s: 1 / radius } } as FieldNode);
      expect(field.value(0, 0, 0)).toBeGreaterThan(0);
      expect(field.value(0, field.box!.max[1] * 1.01, 0)).toBeLessThan(0);
      expect(gradientError(field, [[radius / 3, 0.9 * field.box!.max[1], 0]], 1)).toBeLessThan(1e-6);
    }
  });

  test('only along and up tell where a section points: it moves and turns with them (seed 43)', () => {
    const warp: Warp = { section: { type: 'polar', radii: flower }, scale: [1, 2], up: [0, 1, 0] };
    const turned: Warp = { ...warp, up: [0, 0, 1] };
    const here = bindField(body({ skel: { ...segment, a: [0, 0, 0], b: [3, 0, 0] }, warp }));
    const there = bindField(
      placed(body({ skel: { ...segment, a: [9, 0, 0], b: [12, 0, 0] }, warp: turned }), -9, 0, 0),
    );
    for (const [x, y, z] of points(50, 3, 43)) {
      expect(there.value(x, -z, y)).toBeCloseTo(here.value(x, y, z), 13);
    }
  });

  test('a thousand radii from the origin nothing is lost (seed 44)', () => {
    const warp: Warp = { section: { type: 'superQuadric', exponent: 6 }, scale: [1, 1], up };
    const near = bindField(body({ skel: segment, warp }));
    const far = bindField(body({ skel: { ...segment, a: [4093, 4097, 4096], b: [4100, 4096, 4098] }, warp }));
    for (const [x, y, z] of points(50, 4, 44)) {
      expect(far.value(x + 4096, y + 4096, z + 4096)).toBeCloseTo(near.value(x, y, z), 10);
    }
  });

  test.each<[string, Term, RegExp]>([
    ['no up', { skel: segment, warp: { section: { type: 'round' }, scale: [1, 1] } }, /needs up/],
    [
      'up along the segment',
      { skel: segment, warp: { section: { type: 'round' }, scale: [1, 1], up: [7, -1, 2] } },
      /up must not point along/,
    ],
    [
      'a point without along',
      { skel: point, warp: { section: { type: 'round' }, scale: [1, 1], up } },
      /along/,
    ],
    [
      'one scale',
      { skel: segment, warp: { section: { type: 'round' }, scale: [1] as never, up } },
      /scale must be 2 numbers, got 1/,
    ],
    ['no width', { skel: segment, warp: { section: { type: 'round' }, scale: [1, 0], up } }, /scale\[1\]/],
    [
      'an unknown section',
      { skel: segment, warp: { section: { type: 'hexagon' } as never, scale: [1, 1], up } },
      /unknown section 'hexagon'/,
    ],
  ])('%s is refused', (_, term, message) => {
    expect(() => bindField(body(term))).toThrow(message);
    expect(() => bindField(body(term))).toThrow(/^skels\[0\]/);
  });
});
