/** Bounding volumes after table 1 of Zhu et al., against what they bound; their march, against intervals in float64. */
import { describe, expect, test } from 'vitest';
import { bindField } from '../../src/field/bind.ts';
import type { SkelsNode } from '../../src/field/node.ts';
import { locating } from '../../src/field/polygonize.ts';
import { Raycaster } from '../../src/field/raycast.ts';
import { ZhuMarch } from '../../src/field/zhuMarch.ts';
import { within } from '../../src/field/zhuVolumes.ts';
import { length3, scale3, sub3 } from '../../src/math/tuple.ts';
import type { Vec3 } from '../../src/math/vec.ts';
import { sceneNode } from '../bench/scenes/index.ts';
import { finished } from './finished.ts';
import { Lot } from './lot.ts';
import { firstHit, placeOn } from './rays.ts';
import { BONE, body } from './trees.ts';

const SEED = 4100;

describe('volumes', () => {
  test(`hold all of the inside (5,000 places from seed ${SEED})`, () => {
    const node = body(BONE, 1);
    const field = bindField(node);
    const { volumes } = new ZhuMarch(node, BONE.length);
    const lot = new Lot(SEED);
    let inside = 0;
    for (let i = 0; i < 5000; i++) {
      const p = scale3(lot.direction(), 8);
      if (!(field.value(...p) > 0)) continue;
      inside++;
      const ray: Vec3 = [0, 0, 1];
      const holds = volumes.some((volume) =>
        within(volume, p, ray).some(([s, t]) => s <= 1e-9 && t >= -1e-9),
      );
      expect(holds, p.join(' ')).toBe(true);
    }
    expect(inside).toBeGreaterThan(100);
  });

  test('a prism over a plate with a hole', () => {
    const corners = (half: number) =>
      [
        [-half, -half],
        [half, -half],
        [half, half],
        [-half, half],
      ] as const;
    const prism = {
      type: 'prism',
      origin: [0, 0, 5],
      u: [1, 0, 0],
      v: [0, 1, 0],
      loops: [corners(4), corners(1)],
      radius: 2,
    } as const;
    expect(within(prism, [-10, 0, 5], [1, 0, 0])).toEqual([
      [6, 9],
      [11, 14],
    ]);
    expect(within(prism, [2, 2, 20], [0, 0, -1])).toEqual([[13, 17]]);
    expect(within(prism, [0, 0, 20], [0, 0, -1])).toEqual([]);
    expect(within(prism, [-10, 0, 8], [1, 0, 0])).toEqual([]);
  });
});

test('hits are on the surface, and ours cost less and miss fewer', () => {
  const node: SkelsNode = sceneNode('tree64');
  const field = bindField(node);
  const zhu = new ZhuMarch(node);
  const found = finished(locating(field, 128));
  const ours = new Raycaster(found);
  const before = ours.work;
  const size = length3(sub3(found.box.max, found.box.min));
  const missed = { zhu: 0, ours: 0 };
  let hits = 0;
  for (let i = 0; i < 900; i++) {
    const [x, y] = [(i % 30) / 15 - 1, Math.floor(i / 30) / 15 - 1];
    const ray = {
      from: [x + 0.01, y + 0.01, 4] as const,
      along: [0, 0, -1] as const,
      nearest: 0,
      pixel: 1 / 256,
      growth: 0,
    };
    const truth = firstHit(field, ray, 0, 8, 1e-5).t;
    if (truth === null) continue;
    hits++;
    const theirs = zhu.cast(ray.from, ray.along);
    if (theirs !== null) expect(Math.abs(field.value(...placeOn(ray, theirs)))).toBeLessThan(1e-3);
    if (theirs === null || Math.abs(theirs - truth) > 0.01 * size) missed.zhu++;
    if (!ours.cast(ray) || Math.abs(ours.hit.t - truth) > 1e-4 * size) missed.ours++;
  }
  expect(hits).toBeGreaterThan(50);
  expect(missed.ours).toBe(0);
  expect(missed.zhu).toBeLessThan(0.2 * hits);
  expect(ours.work - before).toBeLessThan(zhu.work / 5);
});
