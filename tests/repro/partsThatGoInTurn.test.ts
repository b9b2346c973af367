/**
 * Tree 710 of seed 93 (tests/field/nearEffect.test.ts), as small as it comes: of a hard union two parts that reach as far in a cube go one after the
 * other. Each was thought to be made up for by the other: the field fell by ten millimetres, and the sum of effects was below two. So it was with
 * a part that sank while another hid it from the cube around, which then went.
 */
import { expect, it } from 'vitest';
import { bindField } from '../../src/field/bind.ts';
import { Tally } from '../../src/field/near.ts';
import type { FieldNode } from '../../src/field/node.ts';
import { type Numbered, numbered, numbersIn, Supply } from '../../src/field/numbered.ts';
import { treeChanges } from '../../src/field/treeChanges.ts';
import { placed, sphere } from '../field/trees.ts';

const union = (...parts: FieldNode[]): FieldNode => ({ type: 'union', form: 'hard', parts });
const [one, other] = [placed(sphere(5), 0, 0, 0), placed(sphere(5), 0.05, 0, 0)];
const far = [placed(sphere(5), 10, 0, 0), placed(sphere(5), 40, 0, 0)];
const [at, half] = [[-5, 0, 0] as const, 0.05];

function wholeOf(tree: Numbered) {
  const tally = new Tally();
  tally.numbers = numbersIn(tree);
  return bindField(tree.node).near(tally);
}

it('two parts gone, one after the other, count as much as the field falls', () => {
  const next = new Supply();
  let now = numbered(union(one, other, ...far), next);
  const near = wholeOf(now).within(...at, half, 0);
  let sum = 0;
  for (const after of [union(other, ...far), union(...far)]) {
    const { tree, nodes } = treeChanges(now, after, next)!;
    now = tree;
    const whole = wholeOf(tree);
    sum += near.effect(whole, nodes, ...at, half);
    const fall = near.value(...at) - whole.value(...at);
    expect(sum).toBeGreaterThanOrEqual(fall);
  }
});

it('a part that is hidden, sinks and is laid bare again is not what it was', () => {
  const next = new Supply();
  const [cover, small] = [placed(sphere(5.4), 0, 0, 0), placed(sphere(1), 0, 0, 0)];
  const [before, hidden, sunk, bare] = [
    union(one, other, ...far),
    union(one, cover, ...far),
    union(small, cover, ...far),
    union(small, ...far),
  ];
  let now = numbered(before, next);
  const around = (tree: Numbered) => wholeOf(tree).within(...at, 2 * half, 0);
  const near = around(now).within(...at, half, 0);
  let sum = 0;
  for (const after of [hidden, sunk, bare]) {
    const { tree, nodes } = treeChanges(now, after, next)!;
    now = tree;
    const outer = around(tree);
    sum += near.effect(outer, nodes, ...at, half);
    expect(sum).toBeGreaterThanOrEqual(near.value(...at) - outer.value(...at));
  }
});
