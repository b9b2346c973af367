/** Loops around cubes: closed, of every crossing once, alike on both sides of a face. */
import { describe, expect, test } from 'vitest';
import { CubeLoops } from '../../src/field/cubeLoops.ts';
import type { Lattice } from '../../src/field/lattice.ts';
import { meshing } from '../../src/field/latticeMesh.ts';
import type { TreeField } from '../../src/field/treeField.ts';
import { topology } from '../../src/mesh/check.ts';
import { volume } from '../../src/mesh/measure.ts';
import { random } from '../fixtures/random.ts';

const CORNERS = Array.from({ length: 8 }, (_, corner) => corner);

/** Values of the signs that `mask` says. */
const valuesOf = (mask: number, next: () => number) =>
  CORNERS.map((corner) => (((mask >> corner) & 1) === 1 ? 1 : -1) * (0.1 + next()));

describe('loops', () => {
  test('every crossed edge is in one loop, once, whatever the values (seed 61)', () => {
    const next = random(61);
    const loops = new CubeLoops();
    for (let mask = 0; mask < 256; mask++) {
      const crossed = [1, 2, 4].flatMap((step, axis) =>
        CORNERS.filter((c) => !(c & step) && ((mask >> c) ^ (mask >> (c | step))) & 1).map(
          (c) => c + 8 * axis,
        ),
      );
      for (let round = 0; round < 20; round++) {
        loops.trace(mask, valuesOf(mask, next));
        const end = loops.count > 0 ? loops.ends[loops.count - 1]! : 0;
        expect([...loops.edges.subarray(0, end)].sort((a, b) => a - b)).toEqual(
          crossed.sort((a, b) => a - b),
        );
        let start = 0;
        for (let i = 0; i < loops.count; i++) {
          expect(loops.ends[i]! - start).toBeGreaterThan(2);
          start = loops.ends[i]!;
        }
      }
    }
  });

  test('noise on a lattice, every cube a hard case, is a closed mesh of one side (40 lattices, seed 62)', () => {
    const next = random(62);
    const lattice: Lattice = { origin: [0, 0, 0], step: 1, counts: [7, 8, 9] };
    for (let round = 0; round < 40; round++) {
      const values = Float64Array.from({ length: 7 * 8 * 9 }, () => 2 * next() - 1);
      const mesh = finished(meshing(between(lattice, values), lattice, values));
      expect(topology(mesh)).toMatchObject({ watertight: true, badEdges: 0, finite: true });
      expect(volume(mesh)).toBeGreaterThan(0);
    }
  });
});

function finished<T>(steps: Generator<number, T>): T {
  for (;;) {
    const { done, value } = steps.next();
    if (done) return value;
  }
}

/** The field that is linear between neighbours: where surfaces cross edges is where their values say. */
function between({ counts: [nx, ny, nz] }: Lattice, values: Float64Array): TreeField {
  const value = (x: number, y: number, z: number) => {
    const [i, j, k] = [x, y, z].map((c, axis) => Math.min(Math.floor(c), [nx, ny, nz][axis]! - 2)) as [
      number,
      number,
      number,
    ];
    const at = (corner: number) =>
      values[i + (corner & 1) + nx * (j + ((corner >> 1) & 1) + ny * (k + (corner >> 2)))]!;
    const share = (c: number, first: number, bit: number) => (bit ? c - first : 1 - c + first);
    return CORNERS.reduce(
      (sum, c) => sum + at(c) * share(x, i, c & 1) * share(y, j, c & 2) * share(z, k, c & 4),
      0,
    );
  };
  return {
    value,
    evaluate(x, y, z, out) {
      const h = 1e-6;
      out[0] = value(x, y, z);
      out[1] = (value(x + h, y, z) - value(x - h, y, z)) / (2 * h);
      out[2] = (value(x, y + h, z) - value(x, y - h, z)) / (2 * h);
      out[3] = (value(x, y, z + h) - value(x, y, z - h)) / (2 * h);
    },
    colour: (x, y, z, out) => {
      out.fill(0.5);
      return value(x, y, z);
    },
    range: () => {},
    box: null,
    boxAbove: () => null,
  };
}
