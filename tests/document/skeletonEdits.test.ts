import { describe, expect, test } from 'vitest';
import { branched, moved, split, swollen, without } from '../../src/document/skeletonEdits.ts';
import type { MedialGraph } from '../../src/skeleton/medial/axis.ts';
import { random } from '../fixtures/random.ts';

const chain: MedialGraph = {
  nodes: [
    { at: [0, 0], radius: 2 },
    { at: [10, 0], radius: 4 },
    { at: [20, 0], radius: 6 },
  ],
  links: [
    [0, 1],
    [1, 2],
  ],
};

describe('edits of skeletons', () => {
  test('a node goes elsewhere, the others stay the same objects', () => {
    const next = moved(chain, 1, [10, 5]);
    expect(next.nodes[1]).toEqual({ at: [10, 5], radius: 4 });
    expect(next.nodes[0]).toBe(chain.nodes[0]);
  });

  test('radii stay within what files hold; all of a plate change', () => {
    expect(swollen(chain, 0, -5).nodes[0]!.radius).toBe(0.1);
    expect(swollen(chain, 0, 1e9).nodes[0]!.radius).toBe(1e6);
    expect(swollen(chain, 0, 3, true).nodes.map(({ radius }) => radius)).toEqual([3, 3, 3]);
  });

  test('a split link becomes two, with the radius in between', () => {
    const next = split(chain, 1, [15, 1]);
    expect(next.nodes[3]).toEqual({ at: [15, 1], radius: 5 });
    expect(next.links).toEqual([
      [0, 1],
      [1, 3],
      [3, 2],
    ]);
  });

  test('a branch is linked; in a loop it goes into the nearer link', () => {
    expect(branched(chain, 1, [10, 9]).links).toContainEqual([1, 3]);
    const loop = { ...chain, links: [...chain.links, [2, 0] as const] };
    const next = branched(loop, 1, [16, 3], true);
    expect(next.links).toHaveLength(4);
    expect(
      next.links
        .filter((link) => link.includes(3))
        .flat()
        .sort(),
    ).toEqual([1, 2, 3, 3]);
  });

  test('without a node its neighbours are linked, if it had two that were not; the last one stays', () => {
    expect(without(chain, 1)).toEqual({ nodes: [chain.nodes[0], chain.nodes[2]], links: [[0, 1]] });
    expect(without(chain, 0).links).toEqual([[0, 1]]);
    const loop = { ...chain, links: [...chain.links, [2, 0] as const] };
    expect(without(loop, 1).links).toEqual([[1, 0]]);
    const lone = { nodes: chain.nodes.slice(0, 1), links: [] };
    expect(without(lone, 0)).toBe(lone);
  });

  test.each(Array.from({ length: 10 }, (_, seed) => seed))(
    'any row of edits leaves a graph, seed %d',
    (seed) => {
      const next = random(seed);
      let graph = chain;
      for (let i = 0; i < 60; i++) {
        const node = Math.floor(next() * graph.nodes.length);
        const at = [30 * next(), 30 * next()] as const;
        const deed = Math.floor(4 * next());
        if (deed === 0) graph = moved(graph, node, at);
        else if (deed === 1 && graph.links.length > 0)
          graph = split(graph, Math.floor(next() * graph.links.length), at);
        else if (deed === 2) graph = branched(graph, node, at, next() > 0.5);
        else graph = without(graph, node);
        const names = graph.links.map(([a, b]) => [a, b].sort((x, y) => x - y).join(' '));
        expect(new Set(names).size).toBe(names.length);
        for (const [a, b] of graph.links)
          expect(a !== b && Math.max(a, b) < graph.nodes.length && Math.min(a, b) >= 0).toBe(true);
        expect(graph.nodes.every(({ at: p, radius }) => [...p, radius].every(Number.isFinite))).toBe(true);
      }
    },
  );
});
