/** Edited bodies: what a change does not reach is kept, and many small drags come to no more than one. */
import { describe, expect, test } from 'vitest';
import { bindField } from '../../src/field/bind.ts';
import type { FieldMesh } from '../../src/field/brickMesh.ts';
import { LiveMesh } from '../../src/field/liveMesh.ts';
import type { FieldNode, SkelsNode } from '../../src/field/node.ts';
import { polygonize } from '../../src/field/polygonize.ts';
import { topology } from '../../src/mesh/check.ts';
import { bounds, volume } from '../../src/mesh/measure.ts';
import { random } from '../fixtures/random.ts';
import { Lot } from './lot.ts';
import { offBy } from './meshes.ts';
import { randomTree } from './randomTrees.ts';
import { type Point, placed } from './trees.ts';

const FULL = process.env.ROTUND_FULL !== undefined;

/** A comb of thin segments along x, the one in the middle moved. */
function comb(count: number, moved: Point = [0, 0, 0], old?: SkelsNode): SkelsNode {
  const middle = Math.floor(count / 2);
  const skels = Array.from({ length: count }, (_, i) => {
    const [dx, dy, dz] = i === middle ? moved : [0, 0, 0];
    if (old && i !== middle) return old.skels[i]!;
    const at = 6 * (i - count / 2);
    return {
      skel: {
        type: 'segment' as const,
        a: [at + dx, -6 + dy, dz] as const,
        b: [at + dx, 6 + dy, 2 + dz] as const,
        weights: [1],
      },
    };
  });
  return { type: 'skels', kernel: 'cauchy', params: { s: 0.5 }, threshold: 1.6, skels };
}

const CELLS = 96;

describe('an edit', () => {
  test('of one of 100 segments asks a tenth and renews few bricks', () => {
    const before = comb(100);
    const live = new LiveMesh(3 * CELLS);
    const whole = live.make(before);
    const edit = live.make(comb(100, [0.3, 0.2, 0.1], before));
    console.info(
      `an edit: ${edit.renewed} of ${edit.bricks.active.length} bricks, ${(edit.evaluations / whole.evaluations).toFixed(3)} of the work`,
    );
    expect(edit.evaluations).toBeLessThan(0.1 * whole.evaluations);
    expect(edit.renewed).toBeLessThan(0.2 * edit.bricks.active.length);
    const { genus, components } = topology(whole.mesh);
    expect(topology(edit.mesh)).toMatchObject({ watertight: true, finite: true, genus, components });
  });

  test('of nothing renews nothing', () => {
    const live = new LiveMesh(48);
    const node = comb(9);
    const { mesh } = live.make(node);
    const again = live.make(comb(9, [0, 0, 0], node));
    expect(live.make(node).renewed).toBe(0);
    expect(again.mesh.indices).toEqual(mesh.indices);
    expect(again.mesh.positions).toEqual(mesh.positions);
  });

  test('of one of 16 parts of a union looks at that part alone', () => {
    const part = comb(3);
    const at = (x: number, y: number) => placed(part, x, y, 0);
    const union = (dx: number): FieldNode => ({
      type: 'union',
      form: 'hard',
      parts: Array.from({ length: 16 }, (_, i) =>
        at(30 * (i % 4) + (i === 5 ? dx : 0), 30 * Math.floor(i / 4)),
      ),
    });
    const live = new LiveMesh(CELLS);
    const whole = live.make(union(0));
    const edit = live.make(union(1.5));
    expect(edit.evaluations).toBeLessThan(0.25 * whole.evaluations);
    expect(topology(edit.mesh)).toMatchObject({ watertight: true, components: 48 });
    const fresh = polygonize(bindField(union(1.5)), CELLS);
    expect(offBy(union(1.5), edit.mesh, fresh.lattice.step)).toBeLessThan(0.05);
  });
});

/** How an edit may end: the tree before, and after. */
const EDITS: readonly (readonly [name: string, before: FieldNode, after: FieldNode])[] = (() => {
  const old = comb(20);
  const { skels } = old;
  const with_ = (terms: SkelsNode['skels']): FieldNode => ({ ...old, skels: terms });
  const at = (dx: number): FieldNode => ({
    type: 'union',
    form: 'hard',
    parts: Array.from({ length: 8 }, (_, i) => placed(comb(2), 20 * i, i === 3 ? dx : 0, 0)),
  });
  return [
    ['a term in another colour', old, with_(skels.with(4, { ...skels[4]!, colour: [1, 0, 0] }))],
    ['a term twice', old, with_([...skels, skels[4]!])],
    ['a term less', old, with_(skels.toSpliced(7, 1))],
    ['a factor', old, with_(skels.with(4, { ...skels[4]!, factor: 1.4 }))],
    ['a term far away', old, comb(20, [0, 60, 0], old)],
    ['another threshold', old, { ...old, threshold: 1.4 }],
    ['a part that moves', at(0), at(7)],
    ['a part that leaves', at(0), at(120)],
    ['a part that comes back', at(120), at(0)],
  ];
})();

test.each(EDITS)('%s: the edit is what is made at once', (_, before, after) => {
  const live = new LiveMesh(128);
  live.make(before);
  // as a worker gets it
  const { mesh, bricks } = live.make(structuredClone(after));
  const fresh = new LiveMesh(128).make(after).mesh;
  const { step } = bricks.lattice;
  expect(topology(mesh)).toMatchObject({ watertight: true, finite: true });
  expect(offBy(after, mesh, step)).toBeLessThan(0.03);
  // tubes are some cells thick, and lattices lie otherwise
  expect(volume(mesh) / volume(fresh)).toBeCloseTo(1, 1);
  const [found, wanted] = [bounds(mesh), bounds(fresh)];
  for (const end of ['min', 'max'] as const) {
    found[end].forEach((x, axis) => {
      expect(Math.abs(x - wanted[end][axis]!)).toBeLessThan(step);
    });
  }
  const red = (of: FieldMesh) => of.colours.reduce((most, x) => Math.max(most, x), 0);
  expect(red(mesh)).toBeCloseTo(red(fresh), 2);
});

test('what is given up half-way is made anew', () => {
  const live = new LiveMesh(48);
  const before = comb(20);
  live.make(before);
  const after = comb(20, [0.4, 0, 0], before);
  const steps = live.making(after);
  steps.next();
  const { mesh } = live.make(after);
  expect(mesh.positions).toEqual(new LiveMesh(48).make(after).mesh.positions);
});

test(`${FULL ? '10,000' : '300'} small drags are no worse than one (seed 91)`, () => {
  const next = random(91);
  const live = new LiveMesh(96);
  let node = comb(25);
  live.make(node);
  let at: Point = [0, 0, 0];
  let renewed = 0;
  const drags = FULL ? 10_000 : 300;
  let last = live.make(node);
  for (let i = 0; i < drags; i++) {
    const step = () => 0.01 * (2 * next() - 1);
    at = [at[0] + step(), at[1] + step(), at[2] + step()];
    node = comb(25, at, node);
    last = live.make(node);
    renewed += last.renewed / last.bricks.active.length;
  }
  const fresh = polygonize(bindField(node), 96);
  expect(topology(last.mesh)).toMatchObject({ watertight: true, genus: topology(fresh.mesh).genus });
  // what drags leave, and what near lists miss
  expect(offBy(node, last.mesh, fresh.lattice.step)).toBeLessThan(0.03);
  console.info(`drags: ${((100 * renewed) / drags).toFixed(2)} % of the bricks renewed each`);
  expect(renewed / drags).toBeLessThan(0.25);
}, 300_000);

test.each([0, 10, 20])(
  'trees drawn by lot, one after the other, are those made at once (10 pairs, seed 92, from %i)',
  (from) => {
    for (let i = from; i < from + 10; i++) {
      const live = new LiveMesh(16);
      for (const seed of [920 + i, 950 + i]) {
        const node = randomTree(new Lot(seed), 2);
        const { mesh } = live.make(node);
        expect(topology(mesh), `seed ${seed}`).toMatchObject({ watertight: true, finite: true });
      }
    }
  },
  120_000,
);
