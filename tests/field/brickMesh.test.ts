/** Meshes of bricks: closed whatever the values are, and that of all values at all nodes. */
import { describe, expect, test } from 'vitest';
import { bindField } from '../../src/field/bind.ts';
import { BrickMesh } from '../../src/field/brickMesh.ts';
import { type Bricks, culling } from '../../src/field/bricks.ts';
import { BrickValues } from '../../src/field/brickValues.ts';
import { type Lattice, latticeAround, nodeCount } from '../../src/field/lattice.ts';
import { type Near, Tally } from '../../src/field/near.ts';
import { topology } from '../../src/mesh/check.ts';
import { volume } from '../../src/mesh/measure.ts';
import { random } from '../fixtures/random.ts';
import { finished } from './finished.ts';
import { Lot } from './lot.ts';
import { everyBrick, noise } from './noise.ts';
import { randomTree } from './randomTrees.ts';

function meshOf(whole: Near, bricks: Bricks, tally: Tally) {
  const values = new BrickValues(whole, bricks, tally);
  const mesh = new BrickMesh(bricks, values, tally);
  for (const [place, brick] of bricks.active.entries()) mesh.add(brick, values.fill(place));
  return mesh.mesh();
}

test('noise, every cube a hard case, is a closed mesh of one side (40 lattices, seed 62)', () => {
  const next = random(62);
  const lattice: Lattice = { origin: [0, 0, 0], step: 1, counts: [9, 9, 13] };
  for (let round = 0; round < 40; round++) {
    const near = noise(
      lattice,
      Float64Array.from({ length: nodeCount(lattice) }, () => 2 * next() - 1),
    );
    const mesh = meshOf(near, everyBrick(near, lattice), new Tally());
    expect(topology(mesh)).toMatchObject({ watertight: true, badEdges: 0, finite: true });
    expect(volume(mesh)).toBeGreaterThan(0);
  }
});

describe('bricks', () => {
  test('have the signs of all values at all nodes (40 trees, seed 71)', () => {
    const lot = new Lot(71);
    let surfaces = 0;
    let nodes = 0;
    let doubtful = 0;
    for (let i = 0; i < 40; i++) {
      const field = bindField(randomTree(lot, 2));
      const lattice = latticeAround({ min: [-6, -6, -6], max: [6, 6, 6] }, 20);
      const tally = new Tally();
      const whole = field.near(tally);
      const bricks = finished(culling(whole, lattice));
      const values = new BrickValues(whole, bricks, tally);
      const signs = new Map<number, boolean>();
      const [nx, ny, nz] = lattice.counts;
      bricks.active.forEach(({ i: bi, j: bj, k: bk }, place) => {
        values.fill(place).forEach((value, c) => {
          const [x, y, z] = [4 * bi + (c % 5), 4 * bj + (Math.floor(c / 5) % 5), 4 * bk + Math.floor(c / 25)];
          signs.set(x + nx * (y + ny * z), value > 0);
        });
      });
      if (bricks.active.length > 0) surfaces++;
      for (const [node, sign] of signs) {
        const at = [node % nx, Math.floor(node / nx) % ny, Math.floor(node / (nx * ny))] as const;
        if (at.some((a, axis) => a === 0 || a === [nx, ny, nz][axis]! - 1)) continue;
        const p = at.map((a, axis) => lattice.origin[axis]! + a * lattice.step) as [number, number, number];
        nodes++;
        if (field.value(...p) > 0 !== sign) doubtful++;
      }
    }
    expect(surfaces).toBeGreaterThan(20);
    expect(nodes).toBeGreaterThan(50_000);
    console.info(`signs: ${doubtful} of ${nodes} wrong`);
    // interpolation is estimated, not proven
    expect(doubtful).toBeLessThan(1e-4 * nodes);
  });

  test('that are culled hold no surface, and every other cell is in an active one (40 trees, seed 72)', () => {
    const lot = new Lot(72);
    for (let i = 0; i < 40; i++) {
      const field = bindField(randomTree(lot, 2));
      const lattice = latticeAround({ min: [-6, -6, -6], max: [6, 6, 6] }, 20);
      const { grid, counts } = finished(culling(field.near(new Tally()), lattice));
      const edge = 4 * lattice.step;
      const next = random(72 + i);
      grid.forEach((state, number) => {
        if (state >= 0) return;
        const at = [
          number % counts[0],
          Math.floor(number / counts[0]) % counts[1],
          Math.floor(number / (counts[0] * counts[1])),
        ];
        const p = at.map((a, axis) => lattice.origin[axis]! + edge * (a + next())) as [
          number,
          number,
          number,
        ];
        expect(field.value(...p) > 0).toBe(state === -2);
      });
    }
  });
});
