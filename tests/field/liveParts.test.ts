/** Edited bodies of many parts: one more or one less asks for what it reaches, wherever it stands in the tree. */
import { describe, expect, test } from 'vitest';
import { bindField } from '../../src/field/bind.ts';
import { LiveMesh } from '../../src/field/liveMesh.ts';
import type { FieldNode, SetNode, SkelsNode, Term } from '../../src/field/node.ts';
import { polygonize } from '../../src/field/polygonize.ts';
import { topology } from '../../src/mesh/check.ts';
import { bounds, volume } from '../../src/mesh/measure.ts';
import { Lot } from './lot.ts';
import { offBy } from './meshes.ts';
import { body, box, placed, sphere } from './trees.ts';

const FULL = process.env.ROTUND_FULL !== undefined;

const bone = (lean: number): Term => ({
  skel: { type: 'segment', a: [0, 0, 0], b: [3, 6, lean], weights: [1] },
});
const limb = (i: number): FieldNode => placed(body([bone(i % 3)]), 10 * (i % 10), 12 * Math.floor(i / 10), 0);
const set = (type: SetNode['type'], parts: readonly FieldNode[]): FieldNode => ({
  type,
  form: 'hard',
  parts,
});
const union = (parts: readonly FieldNode[]): FieldNode => set('union', parts);
const LIMBS = Array.from({ length: 100 }, (_, i) => limb(i));

/** A field of segments, all in one sum. */
const stubble = (count: number): SkelsNode => ({
  ...body(
    Array.from({ length: count }, (_, i) => ({
      skel: {
        type: 'segment',
        a: [10 * (i % 10), 12 * Math.floor(i / 10), 0],
        b: [10 * (i % 10) + 3, 12 * Math.floor(i / 10) + 6, i % 3],
        weights: [1],
      },
    })),
  ),
  kernel: 'quartic',
  params: { R: 4 },
});
const { skels } = stubble(101);
const sum = (terms: readonly Term[]): FieldNode => ({ ...stubble(1), skels: terms });

const ofHundred: readonly (readonly [name: string, before: FieldNode, after: FieldNode])[] = [
  ['a part more at the end', union(LIMBS), union([...LIMBS, limb(105)])],
  ['a part more in the middle', union(LIMBS), union(LIMBS.toSpliced(50, 0, placed(limb(0), 43, 51, 3)))],
  ['a part more beyond the others', union(LIMBS), union([...LIMBS, placed(limb(0), -12, 30, 0)])],
  ['the first part less', union(LIMBS), union(LIMBS.slice(1))],
  ['a part less in the middle', union(LIMBS), union(LIMBS.toSpliced(33, 1))],
  ['two parts in each other’s place', union(LIMBS), union(LIMBS.with(3, LIMBS[7]!).with(7, LIMBS[3]!))],
  [
    'a hole more',
    set('subtraction', [union(LIMBS), sphere(2)]),
    set('subtraction', [union(LIMBS), sphere(2), placed(sphere(2), 41, 38, 0)]),
  ],
  [
    'a hole that moves',
    set('subtraction', [union(LIMBS), placed(sphere(2), 42, 38, 0), sphere(2)]),
    set('subtraction', [union(LIMBS), placed(sphere(2), 41, 38, 0), sphere(2)]),
  ],
  [
    'a part more within',
    set('subtraction', [union(LIMBS), sphere(2)]),
    set('subtraction', [union([...LIMBS, placed(limb(0), 43, 51, 3)]), sphere(2)]),
  ],
  ['a term more', sum(skels.slice(0, 100)), sum(skels)],
  ['a term more in the middle', sum(skels.toSpliced(50, 1)), sum(skels)],
  ['a term less', sum(skels), sum(skels.toSpliced(50, 1))],
];

describe('of a hundred', () => {
  test.each(ofHundred)('%s asks a tenth at most, and is what is made at once', (_, before, after) => {
    const live = new LiveMesh(160);
    const whole = live.make(before);
    // as a worker gets it
    const edit = live.make(structuredClone(after));
    const share = edit.evaluations / whole.evaluations;
    console.info(`${edit.renewed} of ${edit.bricks.active.length} bricks, ${share.toFixed(3)} of the work`);
    expect(edit.isEdit).toBe(true);
    expect(share).toBeLessThan(0.1);
    expect(edit.renewed).toBeLessThan(0.1 * edit.bricks.active.length);
    expect(edit.bricks.lattice.step).toBe(whole.bricks.lattice.step);
    const fresh = polygonize(bindField(after), 160);
    const { genus, components } = topology(fresh.mesh);
    expect(topology(edit.mesh)).toMatchObject({ watertight: true, finite: true, genus, components });
    expect(volume(edit.mesh) / volume(fresh.mesh)).toBeCloseTo(1, 1);
    const [found, wanted] = [bounds(edit.mesh), bounds(fresh.mesh)];
    for (const end of ['min', 'max'] as const) {
      for (const axis of [0, 1, 2] as const) {
        expect(Math.abs(found[end][axis] - wanted[end][axis])).toBeLessThan(fresh.lattice.step);
      }
    }
  });
});

test('a body that grows bit by bit is made anew when it has grown by half, in larger cells', () => {
  const live = new LiveMesh(96);
  const chain = (count: number) =>
    union(Array.from({ length: count }, (_, i) => placed(sphere(4), 6 * i, 0, 0)));
  const first = live.make(chain(16));
  const made = Array.from({ length: 12 }, (_, i) => live.make(chain(17 + i)));
  const steps = made.map(({ bricks }) => bricks.lattice.step);
  const anew = made.filter(({ isEdit }) => !isEdit);
  expect(steps[0]).toBe(first.bricks.lattice.step);
  expect(anew.length).toBe(1);
  expect(steps.at(-1)!).toBeGreaterThan(1.4 * steps[0]!);
  for (const { mesh, bricks } of made) {
    expect(topology(mesh)).toMatchObject({ watertight: true, components: 1, genus: 0 });
    expect(Math.max(...bricks.lattice.counts)).toBeLessThan(1.6 * 96);
  }
});

test('creases stay where parts come: a box with ever more bites (12 edits)', () => {
  const live = new LiveMesh(40);
  const bite = (i: number) => placed(sphere(3), 10 * Math.cos(i), 8 * Math.sin(i), 5 - 0.7 * i);
  const bitten = (count: number) =>
    set('subtraction', [box(10, 8, 6), ...Array.from({ length: count }, (_, i) => bite(i))]);
  live.make(bitten(1));
  let last = live.make(bitten(2));
  for (let i = 3; i < 14; i++) last = live.make(structuredClone(bitten(i)));
  const fresh = polygonize(bindField(bitten(13)), 40).mesh;
  expect(topology(last.mesh)).toMatchObject({ watertight: true, genus: topology(fresh).genus });
  // where nothing was left uncorrected the mesh is the very same
  expect(volume(last.mesh) / volume(fresh)).toBeCloseTo(1, 5);
  expect(last.mesh.indices.length).toBe(fresh.indices.length);
});

const CHAINS = FULL ? 60 : 3;

test.each(Array.from({ length: CHAINS }, (_, i) => 96_000 + i))(
  'twelve edits one after the other are one body made at once, seed %d',
  (seed) => {
    const lot = new Lot(seed, 4);
    const live = new LiveMesh(48);
    let parts = lot.many(12, () => randomPart(lot));
    const tree = (): FieldNode => set('subtraction', [union(parts.slice(1)), parts[0]!, sphere(2)]);
    live.make(tree());
    for (let i = 0; i < 12; i++) {
      const at = Math.floor(lot.between(0, parts.length));
      const what = lot.one(['more', 'less', 'other'] as const);
      if (what === 'more') parts = parts.toSpliced(at, 0, randomPart(lot));
      else
        parts =
          what === 'less' && parts.length > 3 ? parts.toSpliced(at, 1) : parts.with(at, randomPart(lot));
      const { mesh, bricks } = live.make(structuredClone(tree()));
      expect(topology(mesh), `edit ${i}`).toMatchObject({ watertight: true, finite: true });
      // of spheres that all but touch less than a cell is left
      expect(offBy(tree(), mesh, bricks.lattice.step), `edit ${i}`).toBeLessThan(0.1);
      const fresh = polygonize(bindField(tree()), 64).mesh;
      expect(volume(mesh) / volume(fresh), `edit ${i}`).toBeCloseTo(1, 1);
    }
  },
);

function randomPart(lot: Lot): FieldNode {
  const [x, y, z] = lot.place();
  const kind = lot.one(['limb', 'ball', 'hollow'] as const);
  if (kind === 'limb') return placed(body([bone(lot.between(0, 4)), bone(lot.between(-4, 0))]), x, y, z);
  const ball = placed(sphere(lot.between(2, 5)), x, y, z);
  return kind === 'ball' ? ball : set('subtraction', [ball, placed(sphere(2.5), x + 1, y + 2, z)]);
}
