import { describe, expect, test } from 'vitest';
import { DEFAULT_BRUSH } from '../../../src/document/document.ts';
import { curve } from '../../../src/document/form/curve.ts';
import { DEFAULT_SHAPE } from '../../../src/document/solid.ts';
import type { Vec2 } from '../../../src/math/vec.ts';
import { distanceTo } from '../../../src/skeleton/medial/outline.ts';
import { type NurbsSkel, nurbsPolyline } from '../../../src/skeleton/nurbs.ts';
import { random } from '../../fixtures/random.ts';
import { lineInk } from './inks.ts';
import { depth, type Formed, formed } from './surfaces.ts';

const LINES: Readonly<Record<string, readonly Vec2[]>> = {
  straight: Array.from({ length: 81 }, (_, i): Vec2 => [i - 40, 0]),
  arc: Array.from({ length: 120 }, (_, i): Vec2 => [40 * Math.cos(i / 40), 40 * Math.sin(i / 40)]),
  wave: Array.from({ length: 121 }, (_, i): Vec2 => [i - 60, 20 * Math.sin(i / 20)]),
  hook: Array.from(
    { length: 121 },
    (_, i): Vec2 =>
      i < 60 ? [0, 60 - i] : [20 - 20 * Math.cos((i - 60) / 20), -20 * Math.sin((i - 60) / 20)],
  ),
};

const skelOf = ({ shaped }: Formed) => {
  const skel = shaped.skels.find(({ type }) => type === 'nurbs') as unknown as NurbsSkel & {
    readonly radii: readonly number[];
  };
  return { ...skel, weights: skel.radii };
};

describe('curves', () => {
  test.each(Object.keys(LINES))(
    'follow the stroke within 1 % of its size with few control points: %s',
    (name) => {
      const ink = lineInk(LINES[name]!);
      const found = formed(curve, ink)!;
      expect(found.shaped.skeleton.nodes.length).toBeLessThanOrEqual(12);
      const row = nurbsPolyline({ ...skelOf(found), density: 40 }).points.map(([x, y]): Vec2 => [x, y]);
      const loop = [...row, ...row.slice(1, -1).reverse()];
      const size = Math.max(
        ...[0, 1].map(
          (axis) =>
            Math.max(...LINES[name]!.map((p) => p[axis]!)) - Math.min(...LINES[name]!.map((p) => p[axis]!)),
        ),
      );
      for (let i = 0; i <= 200; i++)
        expect(distanceTo(ink.curves[0]!.point(i / 200), [loop])).toBeLessThan(0.01 * size);
    },
  );

  test('are as thick as the brush, times the profile', () => {
    const found = formed(curve, lineInk(LINES.straight!))!;
    for (const x of [-40, -20, 0, 30])
      expect(Math.abs(depth(found, [x, 0, 0], [0, 0, 1], 30) / DEFAULT_BRUSH.radius - 1)).toBeLessThan(0.05);
    const shape = { ...DEFAULT_SHAPE, profile: [1, 2] };
    const radii = formed(curve, lineInk(LINES.straight!, { shape }))!.shaped.skeleton.nodes.map(
      ({ radius }) => radius,
    );
    expect(radii[0]).toBeCloseTo(DEFAULT_BRUSH.radius, 6);
    expect(radii.at(-1)).toBeCloseTo(2 * DEFAULT_BRUSH.radius, 6);
  });

  test('density and knots are what the shape says, where they fit', () => {
    const knots = [0, 0, 0, 0, 1, 4, 5, 5, 5, 5];
    const found = formed(curve, lineInk(LINES.wave!, { shape: { ...DEFAULT_SHAPE, density: 3, knots } }))!;
    const skel = skelOf(found);
    expect(skel.points).toHaveLength(6);
    expect(skel.knots).toEqual(knots.map((knot) => knot / 5));
    expect(nurbsPolyline(skel).points).toHaveLength(3 * 3 + 1);
    for (const bad of [
      [],
      [1, 2, 3],
      [0, 0, 0, 0, 0],
      [0, 0, 0, 0, 2, 1, 3, 3, 3, 3],
      [0, 0, 0, 0, 0, 0, 0, 0],
    ]) {
      const shape = { ...DEFAULT_SHAPE, knots: bad };
      expect(formed(curve, lineInk(LINES.wave!, { shape }))).not.toBeNull();
    }
  });

  test.each([1, 2, 3, 5])('%d control points by hand', (count) => {
    const nodes = Array.from({ length: count }, (_, i) => ({ at: [15 * i, i % 2] as const, radius: 4 }));
    const links = nodes.slice(1).map((_, i) => [i, i + 1] as const);
    const found = formed(curve, { ...lineInk(LINES.wave!), skeleton: { nodes, links } })!;
    for (const { at } of [nodes[0]!, nodes.at(-1)!])
      expect(found.field.value(at[0], at[1], 0)).toBeGreaterThan(0);
  });

  test('a closed row by hand is a loop', () => {
    const nodes = [
      [0, 0],
      [40, 0],
      [40, 40],
      [0, 40],
    ].map(([x, y]) => ({ at: [x!, y!] as const, radius: 4 }));
    const links = [
      [0, 1],
      [1, 2],
      [2, 3],
      [3, 0],
    ] as const;
    expect(formed(curve, { ...lineInk(LINES.wave!), skeleton: { nodes, links } })).not.toBeNull();
  });

  test.each(Array.from({ length: 12 }, (_, seed) => seed))(
    'random strokes, seed %d: finite, near the stroke',
    (seed) => {
      const next = random(seed);
      const places = Array.from(
        { length: 2 + Math.floor(30 * next()) },
        (): Vec2 => [60 * next(), seed % 3 === 0 ? 0 : 60 * next()],
      );
      const ink = lineInk(places);
      if (ink.curves.length === 0) return;
      const found = formed(curve, ink)!;
      for (const { at, radius } of found.shaped.skeleton.nodes)
        expect([...at, radius].every(Number.isFinite)).toBe(true);
      for (const p of places.slice(0, 5))
        expect(Number.isFinite(found.field.value(p[0], p[1], 1))).toBe(true);
    },
  );
});
