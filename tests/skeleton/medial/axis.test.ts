import { describe, expect, it } from 'vitest';
import { medialAxis } from '../../../src/skeleton/medial/axis.ts';
import { along, distanceTo, isInside } from '../../../src/skeleton/medial/outline.ts';
import { plate, SHAPES, stadium } from '../../fixtures/silhouettes.ts';

const fine = (loops: Parameters<typeof medialAxis>[0]) => loops.map((loop) => along([loop], 1));

describe('medialAxis', () => {
  it.each(Object.entries(SHAPES))('%s: circles inside the region that reach its outline', (_, shape) => {
    const loops = fine(shape);
    for (const { at, radius } of medialAxis(loops).nodes) {
      expect(isInside(at, loops)).toBe(true);
      expect(radius).toBeCloseTo(distanceTo(at, loops), 9);
    }
  });

  it.each(Object.entries(SHAPES))('%s: hangs together, with a ring for each hole', (_, shape) => {
    const { nodes, links } = medialAxis(fine(shape));
    const group = nodes.map((_, i) => i);
    const find = (i: number): number => (group[i] === i ? i : find(group[i]!));
    for (const [a, b] of links) group[find(a)] = find(b);
    expect(new Set(group.map((_, i) => find(i))).size).toBe(1);
    expect(links.length - nodes.length + 1).toBe(shape.length - 1);
  });

  it('of a bar with round ends lies on its axis, with its radius', () => {
    const { nodes } = medialAxis(fine([stadium(30, 10)]));
    for (const { at, radius } of nodes) {
      expect(Math.abs(at[1])).toBeLessThan(0.1);
      expect(Math.abs(at[0])).toBeLessThan(30.1);
      expect(Math.abs(radius - 10)).toBeLessThan(0.05);
    }
  });

  it('knows junctions, sleeves and ends', () => {
    const { degrees } = medialAxis(fine(plate(1)));
    expect(new Set(degrees)).toEqual(new Set([1, 2, 3]));
    const count = (degree: number) => degrees.filter((d) => d === degree).length;
    // Euler: a ring has as many ends as junctions
    expect(count(3)).toBe(count(1));
  });

  it('has none where there is nothing', () => {
    expect(medialAxis([]).nodes).toEqual([]);
    expect(
      medialAxis([
        [
          [0, 0],
          [1, 1],
          [2, 2],
        ],
      ]).nodes,
    ).toEqual([]);
  });
});
