/** What has no surface, or no field: an empty mesh, or a message that says where and what. */
import { describe, expect, test } from 'vitest';
import { bindField } from '../../src/field/bind.ts';
import type { FieldNode, Term } from '../../src/field/node.ts';
import { PAGE, polygonize } from '../../src/field/polygonize.ts';
import type { Vec2, Vec3 } from '../../src/math/vec.ts';
import { topology } from '../../src/mesh/check.ts';
import { bounds, volume } from '../../src/mesh/measure.ts';
import { FieldError } from '../../src/skeleton/skeleton.ts';
import { expectSolid, made, set, shape } from './meshes.ts';
import { BONE, body, placed, sphere } from './trees.ts';

const half = (x: number): FieldNode => shape({ type: 'halfSpace', normal: [x, 0, 0], offset: 0 });
const O: Vec3 = [0, 0, 0];
const still = { skel: { type: 'segment', a: [1, 2, 3], b: [1, 2, 3], weights: [5, 1] } } as const;

const plate = (...loops: readonly (readonly Vec2[])[]): Term => ({
  skel: { type: 'polygon', origin: O, u: [1, 0, 0], v: [0, 1, 0], loops, weight: 4 },
});
const square = (r: number): readonly Vec2[] => [
  [-r, -r],
  [r, -r],
  [r, r],
  [-r, r],
];

describe('an empty mesh', () => {
  test.each<readonly [string, FieldNode]>([
    ['of a field that never comes to T', body(BONE, 1e6)],
    ['of a body that only takes away', body(BONE.map((term) => ({ ...term, factor: -1 })))],
    ['of a segment of no length', body([still])],
    ['of spheres that do not meet', set('intersection', 'hard', sphere(1), placed(sphere(1), 3, 0, 0))],
    ['of what is taken away whole', set('subtraction', 'smooth', sphere(1), sphere(2))],
    ['of half-spaces back to back', set('subtraction', 'hard', half(1), half(1))],
    ['of a weight of 0', body([{ skel: { type: 'point', at: O, weight: 0 } }])],
  ])('%s', (_, node) => {
    const { mesh } = made(node, 24);
    expect(mesh.indices.length).toBe(0);
    expect(topology(mesh)).toMatchObject({ watertight: true, components: 0, finite: true });
  });
});

describe('what the numbers of a mesh cannot hold is refused', () => {
  test.each<readonly [string, FieldNode]>([
    ['a ball of 10 mm, 1e9 mm off', placed(sphere(10), 1e9, 0, 0)],
    ['a ball of 1e-300 mm', sphere(1e-300)],
    ['a ball of 20 mm, 1e6 mm off', placed(sphere(20), 0, -1e6, 0)],
  ])('%s', (_, node) => {
    expect(() => made(node, 64)).toThrow(FieldError);
    expect(() => made(node, 64)).toThrow(
      /no mesh can hold it: its cells are .* mm, but up to .* mm from the origin/,
    );
  });

  test.each([1e-30, 1e-6, 1, 1e6, 1e30])('a ball of %f mm is one', (radius) => {
    expectSolid(made(sphere(radius), 16).mesh);
  });

  test('a ball of 20 mm, 10 m off, is one', () => {
    expectSolid(made(placed(sphere(20), 1e4, 3, 2), 64).mesh);
  });
});

describe('what is left', () => {
  test('a segment of no length adds nothing', () => {
    const [with_, without] = [body([...BONE, still]), body()].map((node) => made(node, 24).mesh);
    expect(volume(with_!) / volume(without!)).toBeCloseTo(1, 2);
    expectSolid(with_!);
  });

  test('what is inside everywhere is the page', () => {
    const { mesh, lattice } = made(set('union', 'hard', half(1), half(-1)), 16);
    expectSolid(mesh);
    // half a cell more at some sides, and edges may be cut by less than a cell
    const more = volume(mesh) - (2 * PAGE) ** 3;
    expect(Math.abs(more)).toBeLessThan((6 * 2 * PAGE * 0.5 + 12 * lattice.step) * 2 * PAGE * lattice.step);
  });

  test('what fills the given box grows out of it', () => {
    const { mesh } = polygonize(bindField(sphere(10)), 24, { min: [-1, -1, -1], max: [1, 1, 1] });
    expectSolid(mesh);
    expect(bounds(mesh).max[0]).toBeGreaterThan(9.9);
  });

  test.each([0, -5, Number.NaN, 1])('a resolution of %d is the least there is', (resolution) => {
    expectSolid(made(sphere(10), resolution).mesh);
  });

  test('polygons that cross themselves or go twice over their corners are closed', () => {
    const bow: readonly Vec2[] = [
      [-3, -2],
      [3, 2],
      [3, -2],
      [-3, 3],
    ];
    const twice = square(2).flatMap((corner) => [corner, corner]);
    for (const loop of [bow, twice]) {
      const { mesh } = made(body([plate(loop)]), 24);
      expect(topology(mesh)).toMatchObject({ watertight: true, finite: true });
      expect(volume(mesh)).toBeGreaterThan(0);
    }
  });

  test.each([1e-6, 1e6])('bodies and sets %d times as large', (k) => {
    const grown: FieldNode = { type: 'affine', matrix: [k, 0, 0, 0, 0, k, 0, 0, 0, 0, k, 0], node: body() };
    const built = {
      ...body([{ skel: { type: 'segment', a: O, b: [4 * k, 0, 0], weights: [2 / k] } }]),
      params: { s: 0.6 / k },
    };
    const bitten = set('subtraction', 'hard', grown, placed(sphere(2 * k), 4 * k, 0, 0));
    const unit = set('subtraction', 'hard', body(), placed(sphere(2), 4, 0, 0));
    for (const node of [grown, built]) expectSolid(made(node, 24).mesh);
    const [large, plain] = [made(bitten, 24).mesh, made(unit, 24).mesh];
    expect(topology(large)).toMatchObject({ watertight: true, finite: true });
    // their lattices differ
    expect(Math.abs(volume(large) / k ** 3 / volume(plain) - 1)).toBeLessThan(0.02);
  });
});

describe('a message', () => {
  const segment = (weights: readonly number[], b: Vec3 = [1, 0, 0]): Term => ({
    skel: { type: 'segment', a: O, b, weights },
  });
  test.each<readonly [string, FieldNode, RegExp]>([
    ['T of 0', body(BONE, 0), /threshold.*above 0/],
    ['T below 0', body(BONE, -1), /threshold.*above 0/],
    ['T that is no number', body(BONE, Number.NaN), /threshold/],
    ['no skels', body([]), /at least one skel/],
    [
      'radii on a segment of no length',
      body([{ skel: { ...still.skel, radii: [1, 1] } as never }]),
      /skels\[0\]/,
    ],
    [
      'a line through one point',
      body([{ skel: { type: 'polyline', points: [O, O], weights: [1, 1], closed: true } }]),
      /skels\[0\].*apart/,
    ],
    ['two corners', body([plate(square(1).slice(0, 2))]), /skels\[0\].*3 vertices/],
    [
      'corners on a line',
      body([
        plate([
          [0, 0],
          [1, 1],
          [2, 2],
        ]),
      ]),
      /skels\[0\].*no area/,
    ],
    ['no loops', body([plate()]), /skels\[0\].*loop/],
    ['a hole that is larger than its plate', body([plate(square(1), square(2))]), /skels\[0\].*smaller/],
    ['a weight that is no number', body([segment([Number.NaN])]), /skels\[0\].*numbers/],
    ['an end without end', body([segment([1], [Infinity, 0, 0])]), /skels\[0\].*numbers/],
  ])('%s', (_, node, message) => {
    expect(() => made(node, 16)).toThrow(FieldError);
    expect(() => made(node, 16)).toThrow(message);
  });

  test('a box of no numbers', () => {
    const box = (x: number) => ({ min: [x, 0, 0] as const, max: [1, 1, 1] as const });
    for (const x of [Number.NaN, -Infinity]) {
      expect(() => polygonize(bindField(sphere(1)), 16, box(x))).toThrow(/finite|no end/);
    }
  });
});
