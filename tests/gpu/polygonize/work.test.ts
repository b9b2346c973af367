/** What a mesh on the GPU asks, against counting node by node. */
import { describe, expect, it } from 'vitest';
import { bindField } from '../../../src/field/bind.ts';
import type { Bricks } from '../../../src/field/bricks.ts';
import { BRICK, latticeAround } from '../../../src/field/lattice.ts';
import { gpuWork } from '../../../src/gpu/polygonize/work.ts';
import { body, sphere } from '../../field/trees.ts';
import { askedOf, bricksOf } from '../../fixtures/bricks.ts';

/** Of each node the brick that comes first, which owns it. */
function owners({ active }: Bricks): ReadonlyMap<string, number> {
  const found = new Map<string, number>();
  for (const [place, { i, j, k }] of active.entries()) {
    for (let n = 0; n < 125; n++) {
      const at = [n % 5, Math.floor(n / 5) % 5, Math.floor(n / 25)];
      const key = [i, j, k].map((brick, axis) => BRICK * brick + at[axis]!).join(' ');
      if (!found.has(key)) found.set(key, place);
    }
  }
  return found;
}

const listOf = ({ active }: Bricks, place: number): number => askedOf({ active: [active[place]!] } as never);

describe('the work of a mesh on the GPU', () => {
  it('is one value a node of a shape', () => {
    const bricks = bricksOf(sphere(5), latticeAround(bindField(sphere(5)).box!, 30));
    expect(gpuWork(bricks)).toEqual({ nodes: owners(bricks).size, aVertex: 4.2 });
  });

  it('is the list of its owner a node of a sum, and the mean of the lists at vertices', () => {
    const node = body();
    const bricks = bricksOf(node, latticeAround(bindField(node).box!, 24));
    const expected = [...owners(bricks).values()].reduce((sum, place) => sum + listOf(bricks, place), 0);
    const { nodes, aVertex } = gpuWork(bricks);
    expect(nodes).toBe(expected);
    expect(aVertex).toBeCloseTo((4.2 * askedOf(bricks)) / bricks.active.length, 10);
  });

  it('is nothing where nothing is', () => {
    const bricks = bricksOf(sphere(1), { origin: [20, 20, 20], step: 1, counts: [9, 9, 9] });
    expect(gpuWork(bricks)).toEqual({ nodes: 0, aVertex: 0 });
  });
});
