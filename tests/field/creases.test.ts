/** Sharp edges of hard sets, in cells: how far the mesh is from the true crease, and its vertices there. */
import { describe, expect, test } from 'vitest';
import { bindField } from '../../src/field/bind.ts';
import { polygonize } from '../../src/field/polygonize.ts';
import { topology } from '../../src/mesh/check.ts';
import { creaseCases } from './creaseCases.ts';
import { CLOSE, expectSharp, fromSecond, largest } from './creaseChecks.ts';
import { hardTree } from './hardTrees.ts';
import { Lot } from './lot.ts';
import { touches } from './meshes.ts';

const CELLS = 48;

describe(`creases are sharp: within ${CLOSE} cell of the true ones`, () => {
  test.each(creaseCases())('$name', (one) => {
    const { mesh, lattice } = polygonize(bindField(one.node), CELLS);
    expect(one.crease.length).toBeGreaterThan(500);
    expect(largest(one.crease.map((p) => fromSecond(one.sides, p)))).toBeLessThan(1e-9);
    expectSharp(mesh, lattice, one);
  });
});

test('many creases at once are a closed mesh that does not touch itself (40 trees, seeds from 4200)', () => {
  for (let seed = 4200; seed < 4240; seed++) {
    const { mesh } = polygonize(bindField(hardTree(new Lot(seed))), 24);
    expect(topology(mesh), `seed ${seed}`).toMatchObject({ watertight: true, finite: true });
    expect(touches(mesh), `seed ${seed}`).toBe(false);
  }
});
