/** What balls let pass holds no surface: along every ray and as far beside it as was asked for. */
import { expect, test } from 'vitest';
import { bindField } from '../../src/field/bind.ts';
import { BRICK } from '../../src/field/lattice.ts';
import { locating } from '../../src/field/polygonize.ts';
import { ballsIn } from '../../src/field/rayBalls.ts';
import { add3, length3, scale3 } from '../../src/math/tuple.ts';
import type { Vec3 } from '../../src/math/vec.ts';
import { sceneNode } from '../bench/scenes/index.ts';
import { carvedTree } from '../bench/scenes/trees.ts';
import { finished } from './finished.ts';
import { Lot } from './lot.ts';
import { randomTree } from './randomTrees.ts';

const SEED = 5100;
const RAYS = 300;
/** of a brick, beside the ray */
const BESIDE = 0.02;

test.each([
  ['16 segments', sceneNode('tree16'), 64],
  ['carved', carvedTree(), 64],
  ...Array.from(
    { length: 12 },
    (_, i) => [`seed ${SEED + i}`, randomTree(new Lot(SEED + i), 2), 20] as const,
  ),
] as const)('%s', (_, node, cells) => {
  const field = bindField(node);
  const { bricks } = finished(locating(field, cells));
  const { active, lattice } = bricks;
  const balls = ballsIn(bricks);
  const lot = new Lot(SEED);
  const edge = BRICK * lattice.step;
  let free = 0;
  for (let n = 0; n < RAYS && active.length > 0; n++) {
    const place = Math.floor(lot.between(0, active.length - 1e-9));
    const brick = active[place]!;
    const low = [brick.i, brick.j, brick.k].map((at, axis) => lattice.origin[axis]! + at * edge);
    const from = low.map((at) => at + edge * lot.between(0.02, 0.98)) as unknown as Vec3;
    const direction = lot.direction();
    const ray = scale3(direction, 1 / length3(direction));
    const isInside = field.value(...from) > 0;
    const clear = balls.of(place).clear(ray, ...from, isInside, BESIDE * edge);
    if (!(clear > 0)) continue;
    free++;
    for (const share of [0, 0.2, 0.5, 0.8, 1]) {
      const aside = lot.direction();
      const at = add3(
        from,
        add3(scale3(ray, share * clear), scale3(aside, (0.99 * BESIDE * edge) / length3(aside))),
      );
      // bounds hold in the brick, up to what its list misses
      if (at.some((x, axis) => x < low[axis]! || x > low[axis]! + edge)) continue;
      const value = field.value(...at);
      if (Math.abs(value) > brick.near.error) expect(value > 0, `ray ${n}`).toBe(isInside);
    }
  }
  if (cells > 20) expect(free).toBeGreaterThan(0.2 * RAYS);
});

test('are the same for all who ask', () => {
  const { bricks } = finished(locating(bindField(sceneNode('tree16')), 32));
  expect(ballsIn(bricks)).toBe(ballsIn(bricks));
  expect(ballsIn(bricks).of(3)).toBe(ballsIn(bricks).of(3));
});
