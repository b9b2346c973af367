/** Rays without bricks meet what intervals along them say, and cost some dozens of values of the field. */
import { expect, test } from 'vitest';
import { bindField } from '../../src/field/bind.ts';
import type { FieldNode } from '../../src/field/node.ts';
import { latticed } from '../../src/field/polygonize.ts';
import { rayAlone } from '../../src/field/rayAlone.ts';
import type { Ray } from '../../src/field/raycast.ts';
import { add3, length3, scale3, sub3 } from '../../src/math/tuple.ts';
import type { Vec3 } from '../../src/math/vec.ts';
import { sceneNode, skelsOf } from '../bench/scenes/index.ts';
import { carvedTree } from '../bench/scenes/trees.ts';
import { random } from '../fixtures/random.ts';
import { finished } from './finished.ts';
import { firstHit } from './rays.ts';
import { placed } from './trees.ts';

const SCENES: readonly (readonly [name: string, node: FieldNode, rays: number])[] = [
  ['16 segments', sceneNode('tree16'), 60],
  ['178 segments', sceneNode('tree178'), 25],
  ['what is carved', carvedTree(), 25],
  ['a torus', { type: 'shape', shape: { type: 'torus', ring: 20, tube: 3 } }, 60],
];

test.each(SCENES)('%s, seed 7', (_name, node, count) => {
  const field = bindField(node);
  const caster = rayAlone(field);
  const next = random(7);
  const { min, max } = finished(latticed(field, 16)).box;
  const size = Math.max(...sub3(max, min));
  const within = (): Vec3 => {
    const at = (axis: 0 | 1 | 2) => min[axis] + next() * (max[axis] - min[axis]);
    return [at(0), at(1), at(2)];
  };
  let hits = 0;
  const works: number[] = [];
  for (let i = 0; i < count; i++) {
    const target = within();
    const off = sub3(within(), target);
    const along = scale3(off, -1 / length3(off));
    const from = add3(target, scale3(along, -2 * size));
    const ray: Ray = { from, along, nearest: 0, pixel: size / 1000, growth: 0 };
    const before = caster.work;
    const isHit = caster.cast(ray);
    works.push(caster.work - before);
    const least = size * 2e-6;
    const truth = firstHit(field, ray, 0, 4 * size, least);
    expect(isHit).toBe(truth.t !== null);
    if (truth.t === null) continue;
    hits++;
    expect(Math.abs(caster.hit.t - truth.t)).toBeLessThan(size * 1e-4);
  }
  // a millisecond
  const mean = works.reduce((sum, work) => sum + work) / works.length;
  expect(mean).toBeLessThan(100 * Math.max(skelsOf(node), 1));
  expect(hits).toBeGreaterThan(3);
});

test.each([
  ['no end in numbers', 1e308, 0, 'not bounded by finite numbers'],
  ['squares without one', 1e200, 0, 'not bounded by finite numbers'],
  ['a place that has no digits for its size', 1, 1e16, 'too far off'],
])('%s is refused', (_name, radius, off, why) => {
  const ball: FieldNode = { type: 'shape', shape: { type: 'sphere', radius } };
  expect(() => rayAlone(bindField(placed(ball, off, 0, 0)))).toThrow(why);
});
