/** Zhu's picture against ours of the same bodies, and the count of what either misses. */
import { describe, expect, test } from 'vitest';
import { bindField } from '../../src/field/bind.ts';
import { locating } from '../../src/field/polygonize.ts';
import { NOWHERE, type RayCamera, type RayImage } from '../../src/field/rayImage.ts';
import { emptyImage, SceneCaster } from '../../src/field/rayScene.ts';
import { compared, comparing, zhuSum, ZhuBody } from '../../src/field/zhuImage.ts';
import { finished } from '../../src/math/finished.ts';
import { UNMOVED } from '../../src/math/placement.ts';
import { dot3 } from '../../src/math/tuple.ts';
import type { Vec3 } from '../../src/math/vec.ts';
import { BONE, body, sphere } from './trees.ts';

const PLACED = { rotation: [0.5, 0.1, 0, Math.sqrt(0.74)], translation: [3, 2, -4] } as const;
const BODIES = [
  { node: body(BONE, 1), placement: UNMOVED },
  {
    node: body([{ skel: { type: 'point', at: [0, 0, 0], weight: 4 }, colour: [0, 0, 1] }], 1),
    placement: PLACED,
  },
];
const camera = (fov: number): RayCamera => ({
  view: { pivot: [0, 1, 0], rotation: [0.1, 0.2, 0, Math.sqrt(0.95)], height: 20, fov },
  width: 60,
  height: 45,
  offset: [0.5, 0.5],
});
const [THICK] = BODIES;

const normal = ({ surface }: RayImage, at: number): Vec3 => [
  surface[4 * at]!,
  surface[4 * at + 1]!,
  surface[4 * at + 2]!,
];

describe.each([0, 35])('opening %d°', (fov) => {
  const seen = camera(fov);
  const located = BODIES.map(({ node, placement }) => ({
    located: finished(locating(bindField(node), 48)),
    placement,
  }));
  const theirs = BODIES.map(({ node, placement }) => new ZhuBody(node, placement));
  const shares: number[] = [];
  const { comparison, images } = finished(comparing(located, theirs, seen), (share) => shares.push(share));
  const ours = emptyImage(seen);
  const caster = new SceneCaster(located, seen);
  for (let y = 0; y < seen.height; y++) caster.row(ours, y);

  test('the same places, normals, colours and bodies, but for a few at outlines', () => {
    const [zhu] = images;
    let [hits, off] = [0, 0];
    for (let at = 0; at < seen.width * seen.height; at++) {
      const [a, b] = [zhu!.surface[4 * at + 3]!, ours.surface[4 * at + 3]!];
      if (b === NOWHERE && a === NOWHERE) continue;
      hits++;
      const isSame =
        Math.abs(a - b) < 0.02 &&
        dot3(normal(zhu!, at), normal(ours, at)) > 0.999 &&
        [0, 1, 2, 3].every((i) => Math.abs(zhu!.colours[4 * at + i]! - ours.colours[4 * at + i]!) < 0.02);
      if (!isSame) off++;
    }
    expect(hits).toBeGreaterThan(200);
    expect(off).toBeLessThan(0.03 * hits);
    expect(comparison.hits).toBe(hits);
  });

  test('the count says what each did', () => {
    expect(comparison.bricks.missed).toBe(0);
    expect(comparison.zhu.missed).toBeLessThan(0.03 * comparison.hits);
    expect(comparison.zhu.evaluationsPerPixel).toBeGreaterThan(comparison.bricks.evaluationsPerPixel);
    expect(shares).toEqual(shares.toSorted((a, b) => a - b));
    expect(shares.at(-1)).toBeLessThanOrEqual(1);
  });

  test('there is an image for each place in a pixel', () => {
    expect(images.length).toBe(5);
    for (const image of images) expect(image.surface.length).toBe(4 * seen.width * seen.height);
  });
});

test('missed is what the other finds, or finds nearer', () => {
  const image = (depths: readonly number[]) => {
    const made = emptyImage({ width: depths.length, height: 1 });
    for (const [i, depth] of depths.entries()) made.surface[4 * i + 3] = depth;
    return made;
  };
  const zhu = image([NOWHERE, 3, NOWHERE, 1, 2.05, 5, 1]);
  const ours = image([NOWHERE, NOWHERE, 4, 2, 2, 1, 1]);
  expect(compared(zhu, ours, 0.1)).toEqual({ hits: 6, missed: { zhu: 2, ours: 2 } });
});

test('what is no plain sum is refused, in words', () => {
  expect(() => zhuSum(sphere(3))).toThrow(/sums of skels.*found 'shape'/);
  expect(zhuSum(THICK!.node)).toBe(THICK!.node);
  const warp = { section: { type: 'extrusion', alpha: 4 }, scale: [1, 1], up: [0, 1, 0] } as const;
  const odd = { ...body(BONE), skels: [BONE[0]!, { ...BONE[0]!, warp }] } as unknown as Parameters<
    typeof zhuSum
  >[0];
  expect(() => zhuSum(odd)).toThrow(/skels\[1\].*cross sections/);
});
