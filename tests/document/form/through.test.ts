import { describe, expect, test } from 'vitest';
import { through } from '../../../src/document/form/through.ts';

const ringOf = (count: number, radius = 30) =>
  Array.from({ length: count }, (_, i) => {
    const turn = (2 * Math.PI * i) / count;
    return { at: [radius * Math.cos(turn), radius * Math.sin(turn)] as const, radius: 3 };
  });

describe('curves through circles', () => {
  test.each([8, 12, 16, 24])('of %d on a circle a circle', (count) => {
    const { nodes, closed } = through({ nodes: ringOf(count), closed: true });
    expect(closed).toBe(true);
    expect(nodes.length).toBeGreaterThan(count);
    const off = Math.max(...nodes.map(({ at }) => Math.abs(Math.hypot(...at) / 30 - 1)));
    expect(off).toBeLessThan(count < 12 ? 0.01 : 0.002);
  });

  test('go through all of them', () => {
    const given = ringOf(12).map((node, i) => ({ ...node, radius: 2 + (i % 3) }));
    const { nodes } = through({ nodes: given, closed: true });
    for (const { at, radius } of given)
      expect(
        nodes.some(
          (node) =>
            Math.hypot(node.at[0] - at[0], node.at[1] - at[1]) < 1e-9 &&
            Math.abs(node.radius - radius) < 1e-9,
        ),
      ).toBe(true);
    expect(nodes.every(({ radius }) => radius >= 2 && radius <= 4)).toBe(true);
  });

  test('corners of rows stay', () => {
    const corner = [
      ...Array.from({ length: 10 }, (_, i) => [i, 0]),
      ...Array.from({ length: 10 }, (_, i) => [10, i]),
    ];
    const nodes = corner.map(([x, y]) => ({ at: [x!, y!] as const, radius: 1 }));
    for (const { at } of through({ nodes, closed: false }).nodes)
      expect(Math.min(Math.abs(at[1]), Math.abs(at[0] - 10))).toBeLessThan(1e-9);
  });

  test('two are straight, one is one, repeated ones are one', () => {
    const [a, b] = ringOf(2);
    expect(through({ nodes: [a!, b!], closed: false }).nodes).toEqual([a, b]);
    expect(through({ nodes: [a!], closed: false }).nodes).toEqual([a]);
    expect(
      through({ nodes: [a!, a!, a!, b!, b!], closed: true }).nodes.every(({ at }) =>
        at.every(Number.isFinite),
      ),
    ).toBe(true);
  });
});
