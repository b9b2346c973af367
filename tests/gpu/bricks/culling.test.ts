/**
 * Bricks that the device finds, against the field itself in float64: what is said to be inside or outside is, lists are as good as their
 * headers say, and there are hardly more of them than the CPU finds.
 */
import { afterAll, beforeAll, expect, it } from 'vitest';
import { bindField, boundTerms } from '../../../src/field/bind.ts';
import { INSIDE, OUTSIDE } from '../../../src/field/bricks.ts';
import { BRICK, type Lattice, latticeAround } from '../../../src/field/lattice.ts';
import type { FieldNode, SkelsNode } from '../../../src/field/node.ts';
import { cullsOnDevice } from '../../../src/gpu/bricks/cullsOnDevice.ts';
import { openDevice } from '../../../src/gpu/device.ts';
import type { Vec3 } from '../../../src/math/vec.ts';
import { taylorAt } from '../../../src/skeleton/taylor.ts';
import { Lot } from '../../field/lot.ts';
import { randomBody, randomTree } from '../../field/randomTrees.ts';
import { body, box, placed, sphere } from '../../field/trees.ts';
import { widths } from '../../field/widths.ts';
import { bricksOf } from '../../fixtures/bricks.ts';
import { closeDawn, dawnGpu, describeGpu } from '../dawn.ts';
import { EVERYTHING } from '../everything.ts';
import { type Culled, culledOn, headerOf, type Scene } from './culled.ts';
import { nearOn } from './nearOn.ts';
import { plain } from './plain.ts';

afterAll(closeDawn);

const BODIES = process.env.ROTUND_FULL ? 200 : 30;
const TREES = process.env.ROTUND_FULL ? 200 : 30;
const CELLS = 24;
/** of values near 1, in float32 */
const BLUR = 3e-4;
/** ms: a pipeline of everything takes lavapipe minutes */
const PATIENCE = process.env.ROTUND_FULL ? 1_800_000 : 600_000;

/** Bounded ones of what the lot draws. */
function scenes(lot: Lot, count: number, draw: (lot: Lot) => FieldNode): readonly Scene[] {
  const found: Scene[] = [];
  while (found.length < count) {
    const node = plain(draw(lot));
    const { box } = bindField(node);
    const size = box ? Math.max(...box.max.map((x, axis) => x - box.min[axis]!)) : 0;
    if (box && size > 0 && size < 100 * lot.unit && cullsOnDevice(node))
      found.push({ node, lattice: latticeAround(box, CELLS) });
  }
  return found;
}

/** Of each brick: its number and some of its places, corners included. */
function* samples(lot: Lot, { counts, origin, step }: Lattice) {
  const along = counts.map((nodes) => (nodes - 1) / BRICK) as [number, number, number];
  for (let k = 0; k < along[2]; k++)
    for (let j = 0; j < along[1]; j++)
      for (let i = 0; i < along[0]; i++) {
        const inBrick = (n: number) =>
          n < 8 ? [n & 1, (n >> 1) & 1, n >> 2] : lot.many(3, () => lot.between(0, 1));
        const at = lot.many(12, (n) =>
          inBrick(n).map((x, axis) => origin[axis]! + step * BRICK * ([i, j, k][axis]! + x)),
        ) as unknown as Vec3[];
        yield { number: i + along[0] * (j + along[1] * k), place: [i, j, k] as const, at };
      }
}

const isAtBorder = (place: readonly number[], { counts }: Lattice) =>
  place.some((at, axis) => at === 0 || at === (counts[axis]! - 1) / BRICK - 1);

/** Bricks that are not what the device says they are, in words. */
function wrong(lot: Lot, { node, lattice }: Scene, { grid }: Culled): string[] {
  const field = bindField(node);
  const found: string[] = [];
  for (const { number, place, at } of samples(lot, lattice)) {
    const values = at.map((p) => field.value(...p));
    const [low, high] = [Math.min(...values), Math.max(...values)];
    if (grid[number] === OUTSIDE && high > 0) found.push(`brick ${place} is outside, with ${high}`);
    if (grid[number] === INSIDE && low <= 0) found.push(`brick ${place} is inside, with ${low}`);
    if (grid[number] === INSIDE && isAtBorder(place, lattice)) found.push(`brick ${place} is at the border`);
  }
  return found;
}

/** Of the numbers of bricks: ascending along the grid, each with the header of its place. */
function expectInOrder(culled: Culled): void {
  const { grid, lattice, count } = culled;
  const [nx, ny] = lattice.counts.map((nodes) => (nodes - 1) / BRICK) as [number, number];
  const active = [...grid.keys()].filter((number) => grid[number]! >= 0);
  expect(active.length).toBe(count);
  active.forEach((number, i) => {
    const { i: x, j, k } = headerOf(culled, i);
    expect(grid[number]).toBe(i);
    expect(x + nx * (j + ny * k)).toBe(number);
  });
}

/** How many bricks the device finds for one of the CPU's. */
const ratio = (all: readonly Scene[], found: readonly Culled[]) =>
  found.reduce((sum, { count }) => sum + count, 0) /
  all.reduce((sum, { node, lattice }) => sum + bricksOf(node, lattice).active.length, 0);

describeGpu('bricks of the device', () => {
  // one for all, for a pipeline of everything takes software adapters half a minute
  let device: GPUDevice;
  let release = () => {};
  beforeAll(async () => {
    const opened = await openDevice(dawnGpu());
    if ('reason' in opened) throw new Error(opened.reason);
    ({ device, release } = opened);
  });
  afterAll(() => release());

  it.each([1, 1e6, 1e-6])(
    `of bodies of every kernel hold the surface, with sizes about %s mm (${BODIES} bodies, seed 101)`,
    async (unit) => {
      const lot = new Lot(101, unit);
      const all = scenes(lot, BODIES, randomBody);
      const found = await culledOn(device, all, EVERYTHING);
      found.forEach((culled, i) => {
        expect(wrong(lot, all[i]!, culled), JSON.stringify(all[i]!.node)).toEqual([]);
        expectInOrder(culled);
      });
      expect(ratio(all, found)).toBeLessThan(1.03);
    },
    PATIENCE,
  );

  it(
    'of bodies whose terms have widths of their own hold the surface (places by lot, seed 105)',
    async () => {
      const lot = new Lot(105);
      const all = ['cauchy', 'quartic'].flatMap((kernel): readonly Scene[] => {
        const node = widths(kernel);
        return [node, { ...node, skels: [...node.skels].reverse() }].map((node) => ({
          node,
          lattice: latticeAround(bindField(node).box!, CELLS),
        }));
      });
      const found = await culledOn(device, all, EVERYTHING);
      found.forEach((culled, i) => {
        expect(wrong(lot, all[i]!, culled)).toEqual([]);
        expectInOrder(culled);
      });
      expect(ratio(all, found)).toBeLessThan(1.05);
    },
    PATIENCE,
  );

  it(
    `of random trees hold the surface (${TREES} trees, seed 102)`,
    async () => {
      const lot = new Lot(102);
      const all = scenes(lot, TREES, randomTree);
      const found = await culledOn(device, all, EVERYTHING);
      found.forEach((culled, i) => {
        expect(wrong(lot, all[i]!, culled), JSON.stringify(all[i]!.node)).toEqual([]);
        expectInOrder(culled);
      });
      expect(ratio(all, found)).toBeLessThan(1.05);
    },
    PATIENCE,
  );

  it(
    `have lists as good as their headers say (${BODIES} bodies, seed 103)`,
    async () => {
      const lot = new Lot(103);
      const all = scenes(lot, BODIES, randomBody) as readonly (Scene & { node: SkelsNode })[];
      const found = await culledOn(device, all, EVERYTHING);
      let far = 0;
      found.forEach((culled, i) => {
        far += expectListed(lot, all[i]!, culled);
      });
      // the test is of something
      expect(far).toBeGreaterThan(100);
    },
    PATIENCE,
  );

  it(
    `of random trees have the field of the tree, what was dropped does not matter (${TREES} trees, seed 104)`,
    async () => {
      const lot = new Lot(104);
      const all = scenes(lot, TREES, randomTree);
      const found = await culledOn(device, all, EVERYTHING);
      const near = await nearOn(device);
      let [compared, dropped] = [0, 0];
      for (const [i, culled] of found.entries()) {
        const { node, lattice } = all[i]!;
        const field = bindField(node);
        const inBricks = [...samples(lot, lattice)].flatMap(({ number, at }) => {
          const own = culled.grid[number]!;
          return own < 0 ? [] : at.map((p) => [...p.map(Math.fround), own]);
        });
        if (inBricks.length === 0) continue;
        const values = await near(node, culled, Float32Array.from(inBricks.flat()));
        inBricks.forEach(([x, y, z, own], k) => {
          const exact = field.value(x!, y!, z!);
          const { error, start } = headerOf(culled, own!);
          if (culled.lists[4 * start] !== 0) dropped++;
          // beside skels a value is as steep as it is large
          if (Math.abs(exact) > 3) return;
          compared++;
          expect(Math.abs(values[k]! - exact), JSON.stringify([x, y, z, node])).toBeLessThan(error + BLUR);
        });
      }
      // the test is of something
      expect(dropped).toBeGreaterThan(10);
      expect(compared).toBeGreaterThan(1000);
    },
    PATIENCE,
  );

  it(
    'are none, all, or cut off at the border',
    async () => {
      const lattice: Lattice = { origin: [-4, -4, -4], step: 0.25, counts: [33, 33, 33] };
      const lot = new Lot(1);
      const trees = [plain(body(undefined, 50)), sphere(20), placed(box(3, 3, 3), 5, 0, 0)];
      const all = trees.map((node): Scene => ({ node, lattice }));
      const found = await culledOn(device, all, EVERYTHING);
      found.forEach((culled, i) => {
        expect(wrong(lot, all[i]!, culled)).toEqual([]);
        expectInOrder(culled);
      });
      expect(found[0]!.count).toBe(0);
      // of 8³ bricks those at the border
      expect(found[1]!.count).toBe(512 - 216);
      expect(found[1]!.grid.filter((number) => number === INSIDE).length).toBe(216);
      expect(found[2]!.count).toBeGreaterThan(0);
    },
    PATIENCE,
  );
});

/** Checks the lists of some bricks in float64 and says how many terms they leave out. */
function expectListed(lot: Lot, { node, lattice }: Scene & { node: SkelsNode }, culled: Culled): number {
  const field = bindField(node);
  const terms = node.skels.flatMap((term) => boundTerms(term, node));
  const floats = new Float32Array(culled.lists.buffer);
  let left = 0;
  for (const { number, at } of samples(lot, lattice)) {
    const own = culled.grid[number]!;
    if (own < 0) continue;
    const { start, error } = headerOf(culled, own);
    const count = culled.lists[4 * start + 2]!;
    const numbers = [...culled.lists.subarray(4 * (start + 5), 4 * (start + 5) + count)];
    expect(numbers).toEqual([...new Set(numbers)].sort((a, b) => a - b));
    left += terms.length - count;
    for (const p of at) {
      const of = (n: number) => terms[n]!.factor * terms[n]!.field.value(...p);
      const value = numbers.reduce((sum, n) => sum + of(n), farAt(floats, 4 * start, p));
      const S = terms.reduce((sum, _, n) => sum + Math.abs(of(n)), node.threshold);
      expect(Math.abs(value - field.value(...p))).toBeLessThanOrEqual(error + 2e-6 * S);
    }
  }
  return left;
}

/** What stands for the terms that an entry leaves out. */
function farAt(floats: Float32Array, entry: number, [x, y, z]: Vec3): number {
  const four = (row: number) => floats.subarray(entry + 4 * row, entry + 4 * row + 3);
  const [cx, cy, cz] = four(1);
  const taylor = Float64Array.of(floats[entry + 3]!, ...four(2), ...four(3), ...four(4));
  return taylorAt(taylor, x - cx!, y - cy!, z - cz!);
}
