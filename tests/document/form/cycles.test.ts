import { describe, expect, test } from 'vitest';
import { cyclesOf, graphOfLoops, regionsOf } from '../../../src/document/form/cycles.ts';
import { areaOf } from '../../../src/skeleton/region.ts';
import { box, disc, shifted } from '../../fixtures/silhouettes.ts';

const node = (x: number, y: number) => ({ at: [x, y] as const, radius: 1 });

describe('loops as graphs', () => {
  test('come back as they were', () => {
    const loops = [box(10, 10), shifted(disc(3), [20, 0])].map((loop) => loop.map(([x, y]) => node(x, y)));
    const back = cyclesOf(graphOfLoops(loops));
    expect(back.map((cycle) => cycle.length)).toEqual(loops.map((loop) => loop.length));
    for (const [i, cycle] of back.entries()) expect(new Set(cycle)).toEqual(new Set(loops[i]));
  });

  test('what ends somewhere is in none', () => {
    const nodes = [node(0, 0), node(4, 0), node(4, 4), node(9, 9), node(0, 5)];
    const links = [
      [0, 1],
      [1, 2],
      [2, 0],
      [2, 3],
      [4, 4],
    ] as const;
    const cycles = cyclesOf({ nodes, links });
    expect(cycles).toHaveLength(1);
    expect(new Set(cycles[0])).toEqual(new Set(nodes.slice(0, 3)));
  });

  test('two that share a place are two', () => {
    const nodes = [node(0, 0), node(4, 2), node(4, -2), node(-4, 2), node(-4, -2)];
    const links = [
      [0, 1],
      [1, 2],
      [2, 0],
      [0, 3],
      [3, 4],
      [4, 0],
    ] as const;
    const cycles = cyclesOf({ nodes, links });
    expect(cycles.map((cycle) => cycle.length).sort()).toEqual([3, 3]);
  });

  test('of nothing nothing', () => {
    expect(cyclesOf({ nodes: [], links: [] })).toEqual([]);
    expect(cyclesOf({ nodes: [node(0, 0), node(1, 0)], links: [[0, 1]] })).toEqual([]);
  });
});

describe('regions', () => {
  test('outlines counter-clockwise, holes clockwise, and what lies in holes by itself', () => {
    const loops = [disc(40), [...disc(30)].reverse(), disc(10), shifted(disc(5), [90, 0])];
    const regions = regionsOf(loops);
    expect(regions.map((region) => region.length).sort()).toEqual([1, 1, 2]);
    for (const [outer, ...holes] of regions) {
      expect(areaOf(outer!)).toBeGreaterThan(0);
      for (const hole of holes) expect(areaOf(hole)).toBeLessThan(0);
    }
  });

  test('what has no area is none', () => {
    expect(
      regionsOf([
        [
          [0, 0],
          [1, 0],
          [2, 0],
        ],
        [
          [0, 0],
          [1, 1],
        ],
        [],
      ]),
    ).toEqual([]);
  });
});
