/** The worker as its page hears it: a draft, then the body; the latest wish wins. */
import { beforeAll, beforeEach, describe, expect, test, vi } from 'vitest';
import type { FromWorker, Located, Made, Make, ToWorker } from '../../src/field/fieldWork.ts';
import type { FieldNode, SkelsNode } from '../../src/field/node.ts';
import type { PackedBricks, PackedEdit } from '../../src/field/packedBricks.ts';
import { body } from '../field/trees.ts';
import { random } from '../fixtures/random.ts';
import { FakeScope } from './scope.ts';

const scope = new FakeScope<ToWorker, FromWorker>();
const { heard, say } = scope;
const sphere: FieldNode = { type: 'shape', shape: { type: 'sphere', radius: 10 } };
const wish = (id: number, more: Partial<Make> = {}) =>
  say({ type: 'make', id, node: sphere, resolution: 24, mesh: 'worker', name: null, ...more });
const of = (id: number) => heard.filter((message) => message.id === id);
/** about a body, of whole bricks: there is one of air around it, and a node more than cells */
const cellsOf = (step: Made | Located) => {
  return Math.max(...step.lattice.counts) - 5;
};
const made = (id: number) =>
  vi.waitFor(() => {
    const found = heard.find((message) => message.id === id && message.type === 'made' && !message.draft);
    if (found?.type !== 'made') throw new Error('not yet');
    return found;
  }, 15_000);

const located = (id: number) =>
  vi.waitFor(() => {
    const found = heard.find((message) => message.id === id && message.type === 'bricks');
    if (found?.type !== 'bricks') throw new Error('not yet');
    return found.bricks;
  }, 15_000);

beforeAll(async () => {
  vi.stubGlobal('self', scope);
  await import('../../src/worker/field.ts');
});
beforeEach(() => scope.forget());

describe('the worker', () => {
  test('makes a body; a fine one after its draft', async () => {
    wish(1);
    expect((await made(1)).mesh.indices.length).toBeGreaterThan(1000);
    expect(of(1).filter(({ type }) => type === 'made').length).toBe(1);
    wish(2, { resolution: 64 });
    const fine = await made(2);
    const [draft] = of(2).filter((message) => message.type === 'made');
    expect(draft).toMatchObject({ draft: true });
    expect(fine.evaluations).toBeLessThan(64 ** 3);
  });

  test.each([
    [40, [40]],
    [64, [28, 64]],
    [104, [28, 52, 104]],
  ])('of %d cells comes by way of %j, one after the other', async (resolution, expected) => {
    const id = 100 + resolution;
    wish(id, { resolution });
    const last = await made(id);
    const all = of(id).filter((message) => message.type === 'made');
    expect(all.map(({ draft }) => draft)).toEqual(expected.map((cells) => cells !== resolution));
    // a sphere of radius 10 in a box about it: cells along the side
    const cells = all.map(cellsOf);
    expect(cells).toEqual(expected);
    expect(all.at(-1)).toBe(last);
  });

  test.each([1, 2, 3, 4])('of many wishes at any moment the last is made, seed %d', async (seed) => {
    const next = random(seed);
    const first = 1000 * seed;
    let id = first;
    let newest = first;
    const late: number[] = [];
    scope.onHeard = (message) => {
      if (message.type === 'made') {
        // the coarsest of what went before is welcome while there is nothing newer; all else is the latest wish's only
        const isCoarsest = message.draft && cellsOf(message) <= 28;
        if (message.id < newest || (!isCoarsest && message.id !== id)) late.push(message.id);
        newest = message.id;
      }
      const isWhole = message.type === 'made' && !message.draft;
      if (id < first + 12 && (isWhole || next() < 0.4))
        wish(++id, { resolution: [24, 60, 104][Math.floor(3 * next())]! });
    };
    wish(id, { resolution: 104 });
    await vi.waitFor(() => expect(heard.at(-1)).toMatchObject({ id: first + 12, draft: false }), 15_000);
    scope.onHeard = () => {};
    expect(late).toEqual([]);
  });

  test('a newer wish at the second draft: of the older nothing more comes', async () => {
    scope.onHeard = (message) => {
      if (message.id === 40 && message.type === 'made' && cellsOf(message) > 30) wish(41);
    };
    wish(40, { resolution: 150 });
    await made(41);
    scope.onHeard = () => {};
    const ids = heard.filter(({ type }) => type === 'made').map(({ id }) => id);
    expect(ids).toEqual([40, 40, 41]);
  });

  test('gives up what is no longer wanted', async () => {
    scope.onHeard = ({ type, id }) => {
      if (type !== 'made' || id !== 3) return;
      wish(4);
      wish(5);
    };
    wish(3, { resolution: 150 });
    await made(5);
    scope.onHeard = () => {};
    expect(of(3).every((message) => message.type !== 'made' || message.draft)).toBe(true);
    expect(of(4)).toEqual([]);
  });

  test('says in words what has no field, and goes on', async () => {
    wish(6, {
      node: {
        type: 'union',
        form: 'hard',
        parts: [sphere, { ...sphere, shape: { type: 'sphere', radius: 0 } } as FieldNode],
      },
    });
    await vi.waitFor(() =>
      expect(of(6).at(-1)).toMatchObject({ type: 'refused', message: expect.stringMatching(/^parts\[1\]/) }),
    );
    wish(7);
    await made(7);
  });

  /** The same; but plates of singular kernels are the worker's to cull. */
  const mixed: FieldNode = {
    type: 'morph',
    from: sphere,
    to: {
      ...body([
        {
          skel: {
            type: 'polygon',
            origin: [0, 0, 0],
            u: [1, 0, 0],
            v: [0, 1, 0],
            loops: [
              [
                [0, 0],
                [9, 0],
                [0, 9],
              ],
            ],
            weight: 1,
          },
        },
      ]),
      kernel: 'inverseCubic',
      params: {},
    },
    t: 0,
  };

  test.each([
    ['bricks', mixed],
    ['the lattice, where devices find the bricks,', sphere],
  ])('hands %s to a page that makes the mesh, coarse ones first, each with its box', async (_, tree) => {
    const id = tree === sphere ? 9 : 8;
    wish(id, { mesh: 'page', resolution: 104, node: tree });
    const all = await vi.waitFor(() => {
      const found = of(id).filter((message) => message.type === 'bricks');
      expect(found.at(-1)).toMatchObject({ draft: false });
      return found;
    }, 15_000);
    expect(of(id).some(({ type }) => type === 'made')).toBe(false);
    expect(all.map(cellsOf)).toEqual([28, 52, 104]);
    for (const { bricks, box, node } of all) {
      expect(node).toEqual(tree);
      for (const axis of [0, 1, 2] as const) {
        expect(box.min[axis]).toBeLessThan(-10 + 1e-9);
        expect(box.max[axis]).toBeGreaterThan(10 - 1e-9);
        expect(box.max[axis] - box.min[axis]).toBeLessThan(1.1 * 20);
      }
      expect(bricks === null).toBe(tree === sphere);
      if (!bricks) continue;
      // the surface is in none of the others
      const { count } = bricks as PackedBricks;
      expect([...bricks.grid].filter((place) => place >= 0).length).toBe(count);
      expect(count).toBeGreaterThan(0);
    }
  });

  test('says of bricks whether edges are in them', async () => {
    // plates of singular kernels are not the device's to find
    const corners = [
      [-5, -5],
      [5, -5],
      [5, 5],
      [-5, 5],
    ] as const;
    const plate: FieldNode = {
      type: 'skels',
      kernel: 'inverse',
      params: {},
      threshold: 12,
      skels: [
        {
          skel: {
            type: 'polygon',
            origin: [0, 0, 0],
            u: [1, 0, 0],
            v: [0, 1, 0],
            loops: [corners],
            weight: 1,
          },
        },
      ],
    };
    const box: FieldNode = { type: 'shape', shape: { type: 'box', half: [10, 8, 6] } };
    wish(12, { node: { type: 'union', form: 'hard', parts: [plate, box] }, mesh: 'page' });
    expect((await located(12))!.hasCreases).toBe(true);
    wish(13, { node: plate, mesh: 'page' });
    expect((await located(13))!.hasCreases).toBe(false);
  });

  test('of a body that is edited what stays is kept, if the page says so', async () => {
    const limbs = (x: number): FieldNode => ({
      ...body(
        Array.from({ length: 8 }, (_, i) => ({
          skel: { type: 'segment', a: [12 * i, 0, 0], b: [12 * i, 20, i === 3 ? x : 0], weights: [1] },
        })),
      ),
    });
    wish(30, { node: limbs(0), resolution: 60, name: 'limbs' });
    const first = await made(30);
    wish(31, { node: limbs(1), resolution: 60, name: 'limbs' });
    const edit = await made(31);
    // no draft came before it
    expect(of(31).filter(({ type }) => type === 'made').length).toBe(1);
    expect(edit.evaluations).toBeLessThan(0.6 * first.evaluations);
    expect([first.isEdit, edit.isEdit]).toEqual([false, true]);
    wish(32, { node: limbs(1), resolution: 60 });
    const anew = await made(32);
    expect(anew.evaluations).toBeGreaterThan(edit.evaluations);
    expect(anew.isEdit).toBe(false);
    // another body, and what has no field, leave it as it is
    wish(33, { resolution: 60, name: 'ball' });
    expect(await made(33)).toMatchObject({ isEdit: false });
    wish(34, { node: { ...limbs(2), threshold: 0 } as FieldNode, resolution: 60, name: 'limbs' });
    await vi.waitFor(() => expect(of(34).at(-1)).toMatchObject({ type: 'refused' }));
    wish(35, { node: limbs(1.2), resolution: 60, name: 'limbs' });
    expect(await made(35)).toMatchObject({ isEdit: true });
  });

  test('hands a page that has the bricks of a body what an edit made anew of them', async () => {
    const limbs = (x: number): FieldNode => ({
      ...body(
        Array.from({ length: 8 }, (_, i) => ({
          skel: { type: 'segment', a: [12 * i, 0, 0], b: [12 * i, 20, i === 3 ? x : i], weights: [1] },
        })),
      ),
    });
    const asked = async (id: number, node: FieldNode, isHeld: boolean) => {
      wish(id, { node, resolution: 60, mesh: 'page', name: 'limbs', isHeld });
      const last = await vi.waitFor(() => {
        const found = heard.findLast((message) => message.id === id);
        expect(found).toMatchObject({ type: 'bricks', draft: false, isKept: true });
        return found as Located;
      }, 15_000);
      return { last, steps: of(id).filter(({ type }) => type === 'bricks').length };
    };
    const whole = await asked(50, limbs(0), true);
    expect(whole.last.bricks).toHaveProperty('count');
    expect(whole.steps).toBeGreaterThan(1);
    const edit = await asked(51, limbs(0.5), true);
    expect(edit.steps).toBe(1);
    const { renewed, lists, grid } = edit.last.bricks as PackedEdit;
    expect(renewed.length).toBeLessThan(0.6 * grid.filter((place) => place >= 0).length);
    expect(lists.length).toBeLessThan(0.6 * (whole.last.bricks as PackedBricks).lists.length);
    expect(edit.last.evaluations).toBeLessThan(0.6 * whole.last.evaluations);
    // a term more shifts what lists say by place, and a new device has nothing
    const more = limbs(0.5) as SkelsNode;
    const again = await asked(52, { ...more, skels: [...more.skels, more.skels[0]!] }, true);
    expect(again.last.bricks).toHaveProperty('count');
    expect((await asked(53, limbs(0.6), false)).last.bricks).toHaveProperty('count');
    expect((await asked(54, limbs(0.7), true)).last.bricks).toHaveProperty('renewed');
  });

  test.each(['worker', 'page'] as const)('stops when told so: a mesh for the %s', async (mesh) => {
    const id = mesh === 'worker' ? 120 : 130;
    scope.onHeard = (message) => {
      if (message.id === id) say({ type: 'stop', id: id + 1 });
    };
    wish(id, { resolution: 150, mesh });
    await vi.waitFor(() => expect(of(id).length).toBeGreaterThan(0));
    await new Promise((done) => setTimeout(done, 100));
    scope.onHeard = () => {};
    // what it said first was the last
    expect(of(id).length).toBe(1);
    wish(id + 2);
    await made(id + 2);
  });
});
