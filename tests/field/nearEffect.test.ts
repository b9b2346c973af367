/** What changes of a tree do to its values in a cube, bounded without them: the field of one moment stands for that after any number of edits. */
import { expect, test } from 'vitest';
import { bindField } from '../../src/field/bind.ts';
import { type Near, Tally } from '../../src/field/near.ts';
import type { FieldNode } from '../../src/field/node.ts';
import { type Numbered, numbered, numbersIn, Supply } from '../../src/field/numbered.ts';
import { treeChanges } from '../../src/field/treeChanges.ts';
import { Lot } from './lot.ts';
import { randomEdit } from './randomEdits.ts';
import { randomTree } from './randomTrees.ts';
import { points } from './trees.ts';

const FULL = process.env.ROTUND_FULL !== undefined;

function wholeOf(tree: Numbered): Near {
  const tally = new Tally();
  tally.numbers = numbersIn(tree);
  return bindField(tree.node).near(tally);
}

interface Seen {
  readonly at: readonly [number, number, number];
  readonly half: number;
  readonly near: Near;
  debt: number;
}

/** Cubes within cubes, each with its list. */
function cubesIn(lot: Lot, whole: Near): Seen[] {
  return lot.many(6, () => {
    const [x, y, z] = lot.place();
    let near = whole;
    const depth = Math.floor(lot.between(1, 5));
    let half = 4;
    for (let i = 0; i < depth; i++, half /= 2) near = near.within(x, y, z, half, 1e-3 / half);
    return { at: [x, y, z], half: 2 * half, near, debt: 0 };
  });
}

const TREES = FULL ? 1000 : 40;

test(`fields differ by no more than the sum of effects (${TREES} trees, ten edits each, seed 93)`, () => {
  let [finite, kept] = [0, 0];
  for (let tree = 0; tree < TREES; tree++) {
    const lot = new Lot(93_000 + tree);
    const next = new Supply();
    const parts = lot.many(lot.one([2, 4, 8]), () => randomTree(lot, lot.one([0, 1, 2])));
    let now: Numbered = numbered(
      { type: lot.one(['union', 'subtraction', 'intersection']), form: 'hard', parts },
      next,
    );
    const cubes = cubesIn(lot, wholeOf(now));
    for (let edit = 0; edit < 10; edit++) {
      const after: FieldNode = randomEdit(lot, now.node);
      const changes = treeChanges(now, after, next);
      if (!changes) break;
      now = changes.tree;
      const whole = wholeOf(now);
      const field = bindField(after);
      for (const cube of cubes) {
        const { at, half, near } = cube;
        const effect = near.effect(whole, changes.nodes, ...at, half);
        cube.debt += effect;
        if (effect === 0) kept++;
        if (!(cube.debt < Infinity)) continue;
        finite++;
        for (const [dx, dy, dz] of points(8, half, 94 + edit)) {
          const p = [at[0] + dx, at[1] + dy, at[2] + dz] as const;
          const [then, value] = [near.value(...p), field.value(...p)];
          const size = 1e-9 * (1 + Math.abs(then));
          expect(Math.abs(value - then), `tree ${tree}, edit ${edit}`).toBeLessThanOrEqual(
            cube.debt + near.error + size,
          );
        }
      }
    }
  }
  console.info(`effects: ${finite} of cubes with a finite sum, ${kept} without any`);
  expect(finite).toBeGreaterThan(TREES);
}, 120_000);

test('numbers stay where parts come and go, in the middle of a set and deeper', () => {
  const ball = (radius: number): FieldNode => ({ type: 'shape', shape: { type: 'sphere', radius } });
  const union = (...parts: FieldNode[]): FieldNode => ({ type: 'union', form: 'hard', parts });
  const [a, b, d, e, f] = [ball(1), ball(2), ball(5), ball(3), ball(4)];
  const c = union(e, f);
  const next = new Supply();
  const before = numbered(union(a, b, c), next);
  expect(numbersIn(before)).toEqual({ leaves: [0, 1, 2, 3], sets: [-1, -2] });
  const { tree, nodes, touched } = treeChanges(before, union(d, c, a), next)!;
  // b is d now: a part that is likely to be an edit of it
  expect(numbersIn(tree)).toEqual({ leaves: [1, 2, 3, 0], sets: [-1, -2] });
  expect([...nodes.keys()].toSorted()).toEqual([-1, 1]);
  expect(touched).toBe(1);
  const more = treeChanges(tree, union(d, union(ball(6), e, f), a, ball(7)), next)!;
  expect(numbersIn(more.tree)).toEqual({ leaves: [1, 4, 2, 3, 0, 5], sets: [-1, -2] });
  expect([...more.nodes.keys()].toSorted()).toEqual([-1, -2, 4, 5]);
  expect(treeChanges(before, ball(1), next)).toBeNull();
});
