import { describe, expect, test } from 'vitest';
import { DEFAULT_BRUSH } from '../../../src/document/document.ts';
import { line } from '../../../src/document/form/line.ts';
import { DEFAULT_SHAPE } from '../../../src/document/solid.ts';
import type { Vec2 } from '../../../src/math/vec.ts';
import { distanceTo } from '../../../src/skeleton/medial/outline.ts';
import { random } from '../../fixtures/random.ts';
import { lineInk } from './inks.ts';
import { depth, formed } from './surfaces.ts';

const straight = Array.from({ length: 81 }, (_, i): Vec2 => [i - 40, 0]);
const arc = Array.from({ length: 120 }, (_, i): Vec2 => [40 * Math.cos(i / 40), 40 * Math.sin(i / 40)]);

describe('lines', () => {
  test.each(['cauchy', 'gaussian', 'quartic', 'inverseCubic', 'inverseQuintic', 'power'])(
    'are as thick as the brush from end to end: %s',
    (kernel) => {
      const found = formed(line, lineInk(straight), kernel)!;
      for (const x of [0, -20, -35, -40, 40])
        expect(Math.abs(depth(found, [x, 0, 0], [0, 1, 0], 30) / DEFAULT_BRUSH.radius - 1)).toBeLessThan(
          0.03,
        );
      const tip = depth(found, [-40, 0, 0], [-1, 0, 0], 30);
      expect(tip).toBeGreaterThan(0.85 * DEFAULT_BRUSH.radius);
      expect(tip).toBeLessThan(1.05 * DEFAULT_BRUSH.radius);
    },
  );

  test('have few points where they are straight, and more where they bend; all are near the stroke', () => {
    expect(formed(line, lineInk(straight))!.shaped.skeleton.nodes).toHaveLength(2);
    const ink = lineInk(arc);
    const { nodes } = formed(line, ink)!.shaped.skeleton;
    expect(nodes.length).toBeLessThan(25);
    const places = Array.from({ length: 400 }, (_, i) => ink.curves[0]!.point(i / 399));
    const row = nodes.map(({ at }) => at);
    // there and back: a loop of no area
    const loop = [...row, ...row.slice(1, -1).reverse()];
    for (const p of places) expect(distanceTo(p, [loop])).toBeLessThan(0.085 * DEFAULT_BRUSH.radius);
  });

  test('follow a profile and the pressure', () => {
    const shape = { ...DEFAULT_SHAPE, profile: [1, 0.5, 1] };
    const found = formed(line, lineInk(straight, { shape }))!;
    expect(Math.abs(depth(found, [0, 0, 0], [0, 1, 0], 30) / 3 - 1)).toBeLessThan(0.2);
    expect(Math.abs(depth(found, [-38, 0, 0], [0, 1, 0], 30) / 6 - 1)).toBeLessThan(0.1);
    const brush = { ...DEFAULT_BRUSH, pressure: true };
    const { nodes } = formed(line, lineInk(straight, { brush }))!.shaped.skeleton;
    for (const { radius } of nodes) expect(radius).toBeCloseTo(DEFAULT_BRUSH.radius, 6);
  });

  test('a closed stroke is a loop, several strokes are several lines', () => {
    const { curves } = lineInk(straight);
    const far = lineInk(straight.map(([x, y]): Vec2 => [x, y + 50])).curves;
    const { nodes, links } = formed(line, lineInk(straight, { curves: [...curves, ...far] }))!.shaped
      .skeleton;
    expect([nodes.length, links.length]).toEqual([4, 2]);
  });

  test('by hand: branches, lone nodes, links without length', () => {
    const nodes = [
      [0, 0],
      [30, 0],
      [-20, 20],
      [-20, -20],
      [80, 0],
      [120, 0],
      [120, 0],
    ].map(([x, y]) => ({ at: [x!, y!] as const, radius: 4 }));
    const skeleton = {
      nodes,
      links: [
        [0, 1],
        [0, 2],
        [0, 3],
        [5, 6],
      ] as const,
    };
    const found = formed(line, { ...lineInk(straight), skeleton })!;
    for (const { at } of nodes) expect(found.field.value(at[0], at[1], 0)).toBeGreaterThan(0);
    const empty = { nodes: [], links: [] };
    expect(formed(line, { ...lineInk(straight), skeleton: empty })).toBeNull();
  });

  test.each(Array.from({ length: 20 }, (_, seed) => seed))('a random walk, seed %d: finite', (seed) => {
    const next = random(seed);
    const walk: Vec2[] = [[0, 0]];
    const count = 2 + Math.floor(200 * next());
    const step = seed % 4 === 0 ? 0 : 4;
    for (let i = 0; i < count; i++) {
      const [x, y] = walk.at(-1)!;
      walk.push([x + step * (next() - 0.4), y + (seed % 3 === 0 ? 0 : step * (next() - 0.5))]);
    }
    const ink = lineInk(walk);
    if (ink.curves.length === 0) return;
    const found = formed(line, ink)!;
    expect(found.shaped.skeleton.nodes.length).toBeLessThanOrEqual(60);
    for (const [x, y] of walk.slice(0, 9)) expect(Number.isFinite(found.field.value(x, y, 1))).toBe(true);
  });
});
