/** The walk through bricks: every place of a ray in the lattice is in one brick or block that tells what the grid tells. */
import { expect, test } from 'vitest';
import { bindField } from '../../src/field/bind.ts';
import { locating } from '../../src/field/polygonize.ts';
import { RayWalk, walked } from '../../src/field/rayWalk.ts';
import { length3, scale3, sub3 } from '../../src/math/tuple.ts';
import type { Vec3 } from '../../src/math/vec.ts';
import { sceneNode } from '../bench/scenes/index.ts';
import { finished } from './finished.ts';
import { Lot } from './lot.ts';

const SEED = 5300;

test(`parts follow each other and tell what the grid tells (300 rays from seed ${SEED})`, () => {
  const { bricks } = finished(locating(bindField(sceneNode('tree64')), 96));
  const { lattice, counts, grid } = bricks;
  const edge = 4 * lattice.step;
  const walk = new RayWalk(walked(bricks));
  const lot = new Lot(SEED);
  let parts = 0;
  for (let n = 0; n < 300; n++) {
    const from = scale3(lot.direction(), 2.5);
    // towards the middle, or along an axis
    const along = n % 10 === 0 ? ([0, 0, -1] as Vec3) : sub3(scale3(lot.direction(), 0.4), from);
    const ray = scale3(along, 1 / length3(along));
    if (!walk.begin(from, ray, 0, Infinity)) continue;
    let before = walk.start;
    do {
      parts++;
      expect(walk.start).toBe(before);
      expect(walk.stop).toBeGreaterThanOrEqual(walk.start);
      before = walk.stop;
      if (walk.stop - walk.start < 1e-9) continue;
      for (const share of [0.01, 0.5, 0.99]) {
        const t = walk.start + share * (walk.stop - walk.start);
        const [i, j, k] = [0, 1, 2].map((axis) =>
          Math.floor((from[axis]! + t * ray[axis]! - lattice.origin[axis]!) / edge),
        ) as [number, number, number];
        expect(grid[i + counts[0] * (j + counts[1] * k)]).toBe(walk.state);
      }
    } while (walk.next());
    // the end is where the lattice ends
    const end = [0, 1, 2].map((axis) => from[axis]! + walk.stop * ray[axis]!);
    const out = end.some((x, axis) => {
      const low = lattice.origin[axis]! + 0.5 * lattice.step;
      const high = low + (lattice.counts[axis]! - 2) * lattice.step;
      return Math.min(Math.abs(x - low), Math.abs(x - high)) < 1e-9;
    });
    expect(out).toBe(true);
  }
  expect(parts).toBeGreaterThan(1000);
});
