/** Meshes of trees drawn by lot: closed, oriented, 2-manifold, in their lattice; a hundred, or a thousand with ROTUND_FULL. */
import { describe, expect, test } from 'vitest';
import { bindField } from '../../src/field/bind.ts';
import { type Polygonized, polygonize } from '../../src/field/polygonize.ts';
import { topology } from '../../src/mesh/check.ts';
import { weld } from '../../src/mesh/weld.ts';
import { Lot } from './lot.ts';
import { isWithin } from './meshes.ts';
import { randomTree } from './randomTrees.ts';

const BLOCK = 10;
const BLOCKS = process.env.ROTUND_FULL ? 100 : 10;
const SEED = 6000;

/** In words, what is wrong. */
function faults({ mesh, lattice }: Polygonized): string[] {
  const found = topology(mesh);
  const { positions, normals, colours, indices } = mesh;
  const { ids } = weld(positions);
  const places = new Set(Array.from(indices, (i) => ids[i]!)).size;
  // V counts the fans of triangles around points: one a point where the surface does not touch itself
  const fans = found.euler + indices.length / 6;
  const isUnit = (i: number) =>
    Math.abs(Math.hypot(normals[i]!, normals[i + 1]!, normals[i + 2]!) - 1) < 1e-5;
  return [
    ...(found.watertight ? [] : [`${found.badEdges} bad edges`]),
    ...(found.watertight && fans !== places ? [`touches itself: ${fans} fans at ${places} points`] : []),
    ...(found.finite && colours.every((x) => x >= 0 && x <= 1) ? [] : ['no number']),
    ...(isWithin(mesh, lattice) ? [] : ['outside its lattice']),
    ...(normals.every((_, i) => i % 3 > 0 || isUnit(i)) ? [] : ['a normal']),
    ...(colours.length === positions.length ? [] : ['unpainted vertices']),
  ];
}

/** A busy machine is no failure: some trees have fields that take long. */
const PATIENCE = 200_000;

describe(`meshes of trees drawn by lot (${BLOCKS * BLOCK} from seed ${SEED})`, () => {
  const blocks = Array.from({ length: BLOCKS }, (_, i) => SEED + BLOCK * i);
  test.each(blocks)(
    'seeds %i and nine more',
    (first) => {
      let surfaces = 0;
      for (let seed = first; seed < first + BLOCK; seed++) {
        const lot = new Lot(seed, [1, 1, 1e6, 1e-6][seed % 4]);
        const field = bindField(randomTree(lot));
        const found = polygonize(field, Math.round(lot.between(12, 20)));
        expect(faults(found), `seed ${seed}`).toEqual([]);
        if (found.mesh.indices.length > 0) surfaces++;
      }
      expect(surfaces).toBeGreaterThan(2);
    },
    PATIENCE,
  );
});
