/** Components, groups and skels of trees, counted by hand. */
import { describe, expect, it } from 'vitest';
import { bodyCounts } from '../../src/document/bodyCounts.ts';
import type { FieldNode } from '../../src/field/node.ts';

const ball: FieldNode = { type: 'shape', shape: { type: 'sphere', radius: 3 } };
const sum = (skels: number): FieldNode => ({
  type: 'skels',
  kernel: 'cauchy',
  params: {},
  threshold: 1,
  skels: Array.from({ length: skels }, () => ({ skel: { type: 'point', at: [0, 0, 0], weight: 1 } })),
});

describe('bodyCounts', () => {
  it.each<[string, FieldNode, readonly [number, number, number]]>([
    ['a shape has no skels', ball, [0, 0, 0]],
    ['a sum is a component of one group', sum(3), [1, 1, 3]],
    ['sums in a union', { type: 'union', form: 'hard', parts: [sum(3), ball, sum(2)] }, [2, 2, 5]],
    ['a blend', { type: 'blend', a: sum(1), b: sum(2), a0: 1, a1: 1, a2: 1 }, [2, 2, 3]],
    ['a morph', { type: 'morph', from: sum(4), to: ball, t: 0.5 }, [1, 1, 4]],
    [
      'what is placed',
      { type: 'affine', matrix: [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0], node: sum(6) },
      [1, 1, 6],
    ],
  ])('%s', (_, node, [components, groups, skels]) => {
    expect(bodyCounts(node)).toEqual({ components, groups, skels });
  });
});
