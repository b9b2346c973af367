import { describe, expect, test } from 'vitest';
import { fewOf, fewOfLoop } from '../../../src/document/form/few.ts';
import type { MedialNode } from '../../../src/skeleton/medial/axis.ts';
import { distanceTo } from '../../../src/skeleton/medial/outline.ts';
import { random } from '../../fixtures/random.ts';

const circle = (count: number): MedialNode[] =>
  Array.from({ length: count }, (_, i) => {
    const turn = (2 * Math.PI * i) / count;
    return { at: [30 * Math.cos(turn), 30 * Math.sin(turn)] as const, radius: 2 };
  });

describe('few places', () => {
  test('of a straight line its ends, and more where the radius bends', () => {
    const nodes = Array.from({ length: 21 }, (_, i) => ({ at: [i, 0] as const, radius: 2 }));
    expect(fewOf(nodes, 0.1)).toEqual([0, 20]);
    const thick = nodes.map((node, i) => (i === 10 ? { ...node, radius: 5 } : node));
    expect(fewOf(thick, 0.1)).toContain(10);
  });

  test.each([0.1, 0.3, 1])('of a ring none is off by more than %d mm', (tolerance) => {
    const nodes = circle(200);
    const kept = fewOfLoop(nodes, tolerance);
    const loop = kept.map((i) => nodes[i]!.at);
    for (const { at } of nodes) expect(distanceTo(at, [loop])).toBeLessThanOrEqual(tolerance + 1e-9);
    expect(kept.length).toBeLessThan(70);
  });

  test.each([0, 1, 2])('no more than asked for, ends among them, seed %d', (seed) => {
    const next = random(seed);
    const nodes = Array.from({ length: 90 }, (_, i) => ({
      at: [i, 9 * next()] as const,
      radius: 1 + next(),
    }));
    const kept = fewOf(nodes, 0.01, 20);
    expect(kept.length).toBeLessThanOrEqual(20);
    expect([kept[0], kept.at(-1)]).toEqual([0, 89]);
    expect(fewOfLoop(nodes, 0.01, 20).length).toBeLessThanOrEqual(20);
  });

  test('of what lies in one place, or is hardly anything', () => {
    const same = Array.from({ length: 9 }, () => ({ at: [1, 1] as const, radius: 1 }));
    expect(fewOfLoop(same, 0.1).length).toBeGreaterThan(2);
    expect(fewOf(same.slice(0, 1), 0.1)).toEqual([0]);
    expect(fewOf([], 0.1)).toEqual([]);
  });
});
