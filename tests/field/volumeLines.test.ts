/** Lines of bounding volumes lie on the volumes, as far from skels as the offset distance; matrices and placements move them. */
import { expect, test } from 'vitest';
import { inverted } from '../../src/field/affine.ts';
import type { FieldNode } from '../../src/field/node.ts';
import { linesOf, volumeLines } from '../../src/field/volumeLines.ts';
import { boundingVolumes } from '../../src/field/zhuVolumes.ts';
import { UNMOVED } from '../../src/math/placement.ts';
import { dot3, length3, sub3 } from '../../src/math/tuple.ts';
import type { Vec3 } from '../../src/math/vec.ts';
import { BONE, body, RIGID, SKEW, sphere } from './trees.ts';

const ends = (lines: ArrayLike<number>): Vec3[] =>
  Array.from({ length: lines.length / 3 }, (_, i) => [lines[3 * i]!, lines[3 * i + 1]!, lines[3 * i + 2]!]);

test('of a sphere, a cylinder and a prism', () => {
  for (const [from, to] of linesOf({ type: 'sphere', centre: [1, 2, 3], radius: 2 }))
    for (const end of [from, to]) expect(length3(sub3(end, [1, 2, 3]))).toBeCloseTo(2, 9);
  const [a, b]: Vec3[] = [
    [1, 0, 0],
    [4, 4, 0],
  ];
  const axis = sub3(b!, a!);
  for (const line of linesOf({ type: 'cylinder', a: a!, b: b!, radius: 1.5 }))
    for (const end of line) {
      const off = sub3(end, a!);
      const along = dot3(off, axis) / 25;
      expect(Math.min(Math.abs(along), Math.abs(along - 1))).toBeLessThan(1e-9);
      expect(Math.sqrt(dot3(off, off) - along * along * 25)).toBeCloseTo(1.5, 9);
    }
  const loops = [
    [
      [0, 0],
      [2, 0],
      [0, 3],
    ],
  ] as const;
  const prism = linesOf({ type: 'prism', origin: [5, 0, 0], u: [0, 1, 0], v: [0, 0, 1], loops, radius: 0.5 });
  expect(prism.length).toBe(9);
  for (const line of prism) for (const [x] of line) expect(Math.abs(x - 5)).toBeCloseTo(0.5, 9);
  expect(linesOf({ type: 'sphere', centre: [0, 0, 0], radius: Infinity })).toEqual([]);
});

test('all sums of a tree have them, where matrices put them; shapes and skels with sections have none', () => {
  const plain = body(BONE, 1);
  const alone = ends(volumeLines(plain, UNMOVED));
  expect(alone.length).toBe(2 * boundingVolumes(plain).flatMap(linesOf).length);
  const tree: FieldNode = {
    type: 'union',
    form: 'hard',
    parts: [
      sphere(3),
      { type: 'affine', matrix: SKEW, node: { type: 'affine', matrix: RIGID, node: plain } },
    ],
  };
  const back = (m: ReturnType<typeof inverted>, [x, y, z]: Vec3): Vec3 =>
    [0, 4, 8].map((i) => m[i]! * x + m[i + 1]! * y + m[i + 2]! * z + m[i + 3]!) as unknown as Vec3;
  const placement = { rotation: [0, 0, 0, 1], translation: [7, 0, 0] } as const;
  const placed = ends(volumeLines(tree, placement));
  expect(placed.length).toBe(alone.length);
  for (const [i, end] of placed.entries()) {
    const there = back(inverted(RIGID), back(inverted(SKEW), sub3(end, [7, 0, 0])));
    expect(length3(sub3(there, alone[i]!))).toBeLessThan(1e-4);
  }
  const warp = { section: { type: 'extrusion', alpha: 4 }, scale: [1, 1], up: [0, 1, 0] };
  const sectioned = body([{ ...BONE[0]!, warp } as unknown as (typeof BONE)[number]]);
  expect(volumeLines(sectioned, UNMOVED).length).toBe(0);
});
