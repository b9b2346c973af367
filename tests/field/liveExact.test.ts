/**
 * Edits that end somewhere, of kernels with a support: what they do not reach is as it was, so that the edited mesh has the triangles of the one that
 * is made at once on the same lattice, where faces are told by exact values and where the body is cut off, too.
 */
import { expect, test } from 'vitest';
import { bindField } from '../../src/field/bind.ts';
import { CUT } from '../../src/field/brickValues.ts';
import { AMBIGUOUS } from '../../src/field/cubeLoops.ts';
import type { Lattice } from '../../src/field/lattice.ts';
import { LiveMesh } from '../../src/field/liveMesh.ts';
import type { FieldNode, SkelsNode } from '../../src/field/node.ts';
import { Lot } from './lot.ts';
import { body, placed, sphere } from './trees.ts';

/** Blobs that all but touch, in cells of about their size, between two that stay. */
function blobs(lot: Lot, count: number): SkelsNode {
  const inner = lot.many(count, () => ({
    skel: { type: 'point' as const, at: lot.place(), weight: lot.between(0.6, 1.6) },
  }));
  const corner = (x: number) => ({ skel: { type: 'point' as const, at: [x, x, x] as const, weight: 2 } });
  return {
    ...body([corner(-4.5), corner(4.5), ...inner]),
    kernel: 'quartic',
    params: { R: 1 },
    threshold: 0.4,
  };
}

/** Cubes of a lattice with a face that four edges of cross. */
function ambiguous(node: FieldNode, { origin, step, counts: [nx, ny, nz] }: Lattice): number {
  const field = bindField(node);
  const inside = (i: number, j: number, k: number) =>
    field.value(origin[0] + i * step, origin[1] + j * step, origin[2] + k * step) > 0 ? 1 : 0;
  let count = 0;
  for (let k = 0; k < nz - 1; k++)
    for (let j = 0; j < ny - 1; j++)
      for (let i = 0; i < nx - 1; i++) {
        let mask = 0;
        for (let c = 0; c < 8; c++) mask |= inside(i + (c & 1), j + ((c >> 1) & 1), k + (c >> 2)) << c;
        count += AMBIGUOUS[mask]!;
      }
  return count;
}

test.each([97, 98, 99])(
  'blobs with ambiguous faces are those made at once after each of five edits, seed %d',
  (seed) => {
    const lot = new Lot(seed);
    let node = blobs(lot, 60);
    const live = new LiveMesh(28);
    const { bricks } = live.make(node);
    expect(ambiguous(node, bricks.lattice)).toBeGreaterThan(5);
    for (let i = 0; i < 5; i++) {
      const at = 2 + Math.floor(lot.between(0, node.skels.length - 2));
      const other = { skel: { type: 'point' as const, at: lot.place(), weight: 1.2 } };
      node = { ...node, skels: node.skels.with(at, other) };
      const edit = live.make(structuredClone(node));
      const fresh = new LiveMesh(28).make(node);
      expect(edit.bricks.lattice).toEqual(fresh.bricks.lattice);
      expect(edit.isEdit).toBe(true);
      expect(edit.renewed).toBeLessThan(0.5 * edit.bricks.active.length);
      expect(edit.mesh.indices).toEqual(fresh.mesh.indices);
      const off = edit.mesh.positions.map((x, n) => Math.abs(x - fresh.mesh.positions[n]!));
      // at the rim of a support there is next to nothing
      expect(Math.max(...off) / bricks.lattice.step).toBeLessThan(0.03);
    }
  },
);

test('what is cut off at the border stays cut off in bricks that are kept', () => {
  const ground: FieldNode = { type: 'shape', shape: { type: 'halfSpace', normal: [0, 1, 0], offset: 1.3 } };
  const scene = (x: number): FieldNode => ({
    type: 'union',
    form: 'hard',
    parts: [ground, placed(sphere(20), 0, 30, 0), placed(sphere(9), x, 40, 50), placed(sphere(5), 60, 40, 0)],
  });
  const live = new LiveMesh(40);
  expect(live.make(scene(-50)).isCut).toBe(true);
  for (const x of [-47, -20, -20.5]) {
    const edit = live.make(structuredClone(scene(x)));
    const fresh = new LiveMesh(40).make(scene(x));
    expect(edit).toMatchObject({ isCut: true, isEdit: true });
    expect(edit.renewed).toBeLessThan(0.4 * edit.bricks.active.length);
    expect(edit.mesh.indices.length).toBe(fresh.mesh.indices.length);
    const half = CUT < 0 ? edit.bricks.lattice.step / 2 : 0;
    const low = edit.mesh.positions.reduce((least, value) => Math.min(least, value), 0);
    expect(low).toBeCloseTo(edit.bricks.lattice.origin[1] + half, 4);
  }
});
