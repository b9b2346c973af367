/** Which trees are smooth wherever they are: without their bricks nothing else is known of creases. */
import { expect, it } from 'vitest';
import { bindField } from '../../src/field/bind.ts';
import { isSmooth } from '../../src/field/bricks.ts';
import type { FieldNode } from '../../src/field/node.ts';
import { body, box, placed, sphere } from './trees.ts';

const union = (form: 'hard' | 'smooth', ...parts: readonly FieldNode[]): FieldNode => ({
  type: 'union',
  form,
  parts,
});

it.each([
  ['a body', body(), true],
  ['a moved ball', placed(sphere(1), 1, 2, 3), true],
  ['a box', box(1, 1, 1), false],
  ['one part', union('hard', sphere(1)), true],
  ['two parts, though they are apart', union('hard', sphere(1), placed(sphere(1), 9, 0, 0)), false],
  ['two parts, smoothly', union('smooth', sphere(1), body()), false],
  ['a blend of what has edges', { type: 'blend', a: box(1, 1, 1), b: body(), a0: 1, a1: 1, a2: 1 }, true],
] as const)('%s', (_, node, expected) => {
  expect(isSmooth(bindField(node))).toBe(expected);
});
