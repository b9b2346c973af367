import { describe, expect, test } from 'vitest';
import { DEFAULT_BRUSH } from '../../../src/document/document.ts';
import { ring } from '../../../src/document/form/ring.ts';
import { DEFAULT_SHAPE } from '../../../src/document/solid.ts';
import type { Vec2 } from '../../../src/math/vec.ts';
import { expectSolid, made } from '../../field/meshes.ts';
import { random } from '../../fixtures/random.ts';
import { box, disc, polar } from '../../fixtures/silhouettes.ts';
import { lineInk, loopInk } from './inks.ts';
import { depth, formed } from './surfaces.ts';

const R = DEFAULT_BRUSH.radius;

describe('rings', () => {
  test.each(['cauchy', 'gaussian', 'quartic', 'inverseCubic'])(
    'round a disc, as thick as the brush: %s',
    (kernel) => {
      const found = formed(ring, loopInk([disc(40)]), kernel)!;
      for (let k = 0; k < 24; k++) {
        const way = [Math.cos((Math.PI * k) / 12), Math.sin((Math.PI * k) / 12)] as const;
        const up = depth(found, [40 * way[0], 40 * way[1], 0], [0, 0, 1], 20);
        expect(Math.abs(up / R - 1)).toBeLessThan(0.03);
        const out = depth(found, [40 * way[0], 40 * way[1], 0], [way[0], way[1], 0], 20);
        expect(Math.abs(out / R - 1)).toBeLessThan(0.06);
      }
      expectSolid(made(found.node, 48).mesh, 1);
    },
  );

  test('12 to 24 nodes, a cycle, on the stroke', () => {
    const wild = polar((t) => 40 + 9 * Math.sin(14 * Math.PI * t));
    for (const loop of [disc(40), box(80, 60), wild]) {
      const { nodes, links } = formed(ring, loopInk([loop]))!.shaped.skeleton;
      expect(nodes.length).toBeGreaterThanOrEqual(12);
      expect(nodes.length).toBeLessThanOrEqual(24);
      expect(links.length).toBe(nodes.length);
    }
  });

  test('corners stay: a box is as thick at its corners as anywhere, on the stroke', () => {
    const found = formed(ring, loopInk([box(80, 60)]))!;
    const off = found.shaped.skeleton.nodes.filter(
      ({ at }) => Math.abs(Math.abs(at[0]) - 40) > 0.6 && Math.abs(Math.abs(at[1]) - 30) > 0.6,
    );
    expect(off).toEqual([]);
    expect(found.field.value(40, 30, 0)).toBeGreaterThan(0);
  });

  test('one thick node swells there alone', () => {
    const ink = loopInk([disc(40)]);
    const { skeleton } = formed(ring, ink)!.shaped;
    const nodes = skeleton.nodes.map((node, i) => (i === 0 ? { ...node, radius: 2 * R } : node));
    const found = formed(ring, { ...ink, skeleton: { ...skeleton, nodes } })!;
    const [x, y] = nodes[0]!.at;
    expect(depth(found, [x, y, 0], [0, 0, 1], 40)).toBeGreaterThan(1.6 * R);
    expect(Math.abs(depth(found, [-x, -y, 0], [0, 0, 1], 40) / R - 1)).toBeLessThan(0.05);
  });

  test('the profile goes round', () => {
    const shape = { ...DEFAULT_SHAPE, profile: [1, 0.5, 1] };
    const { nodes } = formed(ring, loopInk([disc(40)], { shape }))!.shaped.skeleton;
    const radii = nodes.map(({ radius }) => radius);
    expect(Math.min(...radii)).toBeLessThan(0.6 * R);
    expect(radii[0]).toBeCloseTo(R, 6);
  });

  test.each(Array.from({ length: 10 }, (_, seed) => seed))(
    'random strokes, seed %d: finite, open ones too',
    (seed) => {
      const next = random(seed);
      const places = Array.from(
        { length: 3 + Math.floor(60 * next()) },
        (): Vec2 => [60 * next(), seed % 3 === 0 ? 0 : 60 * next()],
      );
      for (const ink of [lineInk(places), loopInk([places])]) {
        if (ink.curves.length === 0) continue;
        const found = formed(ring, ink)!;
        for (const [x, y] of places.slice(0, 5))
          expect(Number.isFinite(found.field.value(x, y, 1))).toBe(true);
      }
    },
  );
});
