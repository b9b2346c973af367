/** Meshes of bricks: closed whatever the values are, and that of all values at all nodes. */
import { describe, expect, test } from 'vitest';
import { bindField } from '../../src/field/bind.ts';
import { BrickMesh } from '../../src/field/brickMesh.ts';
import { type Bricks, culling } from '../../src/field/bricks.ts';
import { BrickValues } from '../../src/field/brickValues.ts';
import { type Lattice, latticeAround } from '../../src/field/lattice.ts';
import { type Near, Tally } from '../../src/field/near.ts';
import type { TreeField } from '../../src/field/treeField.ts';
import { topology } from '../../src/mesh/check.ts';
import { volume } from '../../src/mesh/measure.ts';
import { random } from '../fixtures/random.ts';
import { finished } from './finished.ts';
import { Lot } from './lot.ts';
import { nodeCount } from './nodeCount.ts';
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
      const found = signsOf(field, lattice);
      if (found.bricks > 0) surfaces++;
      nodes += found.nodes;
      doubtful += found.wrong;
    }
    expect(surfaces).toBeGreaterThan(20);
    expect(nodes).toBeGreaterThan(50_000);
    console.info(`signs: ${doubtful} of ${nodes} wrong`);
    // interpolation is estimated, not proven
    expect(doubtful).toBeLessThan(1e-4 * nodes);
  });

  test.each([0.05, 0.1, 0.3])('see skels that are flattened to %f of their height', (by) => {
    const skels = [0, 1, 2].map((i) => ({
      skel: { type: 'segment', a: [4 * i, 0, 0], b: [4 * i + 6, 3, 2], weights: [1] } as const,
      warp: { section: { type: 'round' }, scale: [1, by], up: [0, 0, 1] } as const,
    }));
    const field = bindField({ type: 'skels', kernel: 'cauchy', params: { s: 0.25 }, threshold: 2.5, skels });
    const { wrong, nodes } = signsOf(field, latticeAround(field.box!, 48));
    expect(nodes).toBeGreaterThan(1000);
    expect(wrong).toBe(0);
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

/** Nodes of active bricks off the lattice's border, and those whose sign is not the field's. */
function signsOf(field: TreeField, lattice: Lattice) {
  const tally = new Tally();
  const whole = field.near(tally);
  const bricks = finished(culling(whole, lattice));
  const values = new BrickValues(whole, bricks, tally);
  const signs = new Map<number, boolean>();
  const [nx, ny] = lattice.counts;
  bricks.active.forEach(({ i, j, k }, place) => {
    values.fill(place).forEach((value, c) => {
      const [x, y, z] = [4 * i + (c % 5), 4 * j + (Math.floor(c / 5) % 5), 4 * k + Math.floor(c / 25)];
      signs.set(x + nx * (y + ny * z), value > 0);
    });
  });
  let [nodes, wrong] = [0, 0];
  for (const [node, sign] of signs) {
    const at = [node % nx, Math.floor(node / nx) % ny, Math.floor(node / (nx * ny))] as const;
    if (at.some((a, axis) => a === 0 || a === lattice.counts[axis]! - 1)) continue;
    const [x, y, z] = at.map((a, axis) => lattice.origin[axis]! + a * lattice.step);
    nodes++;
    if (field.value(x!, y!, z!) > 0 !== sign) wrong++;
  }
  return { bricks: bricks.active.length, nodes, wrong };
}
