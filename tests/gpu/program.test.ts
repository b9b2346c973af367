/** Programs without a device: a second interpreter of the steps gives the tree's own values, and the stack stays low. */
import { describe, expect, it } from 'vitest';
import { bindField } from '../../src/field/bind.ts';
import { blendUnion } from '../../src/field/blendUnion.ts';
import { hardUnion } from '../../src/field/hardUnion.ts';
import { morph } from '../../src/field/morph.ts';
import type { FieldNode } from '../../src/field/node.ts';
import type { Operation } from '../../src/field/operation.ts';
import { smoothUnion } from '../../src/field/smoothUnion.ts';
import { REGISTRY } from '../../src/gpu/ingredients.ts';
import { programOf, ROLE, STACK, type Step, TAKE } from '../../src/gpu/program.ts';
import { Lot } from '../field/lot.ts';
import { randomTree } from '../field/randomTrees.ts';
import { points, sphere } from '../field/trees.ts';

type Leaf = Extract<FieldNode, { readonly type: 'skels' | 'shape' }>;

/** in the order of the tree, each with the matrices above it */
function leaves(node: FieldNode, above: (leaf: FieldNode) => FieldNode = (leaf) => leaf): FieldNode[] {
  switch (node.type) {
    case 'skels':
    case 'shape':
      return [above(node satisfies Leaf)];
    case 'affine':
      return leaves(node.node, (leaf) => above({ ...node, node: leaf }));
    case 'blend':
      return [...leaves(node.a, above), ...leaves(node.b, above)];
    case 'morph':
      return [...leaves(node.from, above), ...leaves(node.to, above)];
    default:
      return node.parts.flatMap((part) => leaves(part, above));
  }
}

function operationOf({ operation, amounts: [a0, a1, a2] }: Step): Operation {
  switch (REGISTRY.operations[operation]!) {
    case 'hardUnion':
      return hardUnion;
    case 'smoothUnion':
      return smoothUnion;
    case 'blendUnion':
      return blendUnion({ a0: a0!, a1: a1!, a2: a2! });
    case 'morph':
      return morph(a0!);
  }
}

const trees = (seed: number, count: number): FieldNode[] => {
  const lot = new Lot(seed);
  return lot.many(count, () => randomTree(lot, 5));
};

/** What the steps come to when leaf k has values[k], and how high the stack grew. */
function run(steps: readonly Step[], leafOf: ReadonlyMap<string, number>): { value: number; height: number } {
  const stack: number[] = [];
  let [value, height] = [0, 0];
  for (const step of steps) {
    const isStack = step.take === TAKE.STACK;
    const early = isStack ? stack.pop()! : value;
    const late = isStack ? value : leafOf.get(`${step.take} ${step.at} ${step.place}`)!;
    if (step.role === ROLE.JOIN) {
      const [a, b] = step.swapped ? [late, early] : [early, late];
      value = step.outer * operationOf(step).value(step.outer * a, step.sign * b);
      continue;
    }
    if (step.role === ROLE.PUSH) stack.push(value);
    height = Math.max(height, stack.length);
    value = late;
  }
  expect(stack).toEqual([]);
  return { value, height };
}

/** Leaves are written in the order of the tree, so their places in the heap rise with it. */
const leafSteps = (steps: readonly Step[]) =>
  steps.filter(({ take }) => take !== TAKE.STACK).sort((a, b) => a.at - b.at);

const key = ({ take, at, place }: Step) => `${take} ${at} ${place}`;

describe('a program', () => {
  it('is its tree: 100 random trees, seed 43', () => {
    for (const node of trees(43, 100)) {
      const { steps } = programOf(node);
      const own = leaves(node).map((leaf) => bindField(leaf));
      const order = leafSteps(steps);
      expect(order.length).toBe(own.length);
      for (const p of points(5, 6, 44)) {
        const values = new Map(order.map((step, i) => [key(step), own[i]!.value(...p)]));
        const { value } = run(steps, values);
        const truth = bindField(node).value(...p);
        expect(Math.abs(value - truth)).toBeLessThanOrEqual(1e-12 * (1 + Math.abs(truth)));
      }
    }
  });

  const nest = (depth: number, side: 'left' | 'right' | 'both'): FieldNode => {
    if (depth === 0) return sphere(1);
    const inner = nest(depth - 1, side);
    const parts =
      side === 'left' ? [inner, sphere(2)] : side === 'right' ? [sphere(2), inner] : [inner, inner];
    return { type: 'subtraction', form: 'hard', parts };
  };
  const heightOf = (node: FieldNode) => {
    const { steps } = programOf(node);
    return run(steps, new Map(steps.map((step) => [key(step), 1]))).height;
  };

  it('needs no stack for chains of either side, and log₂ of the leaves at most', () => {
    expect(heightOf(nest(199, 'left'))).toBe(0);
    expect(heightOf(nest(199, 'right'))).toBe(0);
    expect(heightOf(nest(10, 'both'))).toBeLessThanOrEqual(10);
    for (const node of trees(45, 60)) {
      expect(2 ** heightOf(node)).toBeLessThanOrEqual(leaves(node).length);
    }
  });

  it('refuses what the stack has no place for', () => {
    const deepest = nest(STACK + 1, 'both');
    expect(() => programOf({ ...deepest, parts: [deepest, deepest] } as FieldNode)).toThrow(
      'too many branches',
    );
  });

  it('takes ten thousand parts', () => {
    const parts = Array.from({ length: 10_000 }, (_, i) => sphere(1 + i));
    expect(programOf({ type: 'union', form: 'hard', parts }).steps.length).toBe(10_000);
  });

  it('refuses what the tree refuses', () => {
    const none: FieldNode = { type: 'union', form: 'hard', parts: [] };
    expect(() => programOf(none)).toThrow('union has no parts');
  });
});
