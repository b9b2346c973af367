/** The worker as its page hears it: a draft, then the body; the latest wish wins. */
import { beforeAll, beforeEach, describe, expect, test, vi } from 'vitest';
import type { FromWorker, Located, Made, Make, ToWorker } from '../../src/field/fieldWork.ts';
import type { FieldNode } from '../../src/field/node.ts';
import { body } from '../field/trees.ts';
import { random } from '../fixtures/random.ts';

const heard: FromWorker[] = [];
let onMessage = (_: FromWorker): void => {};
const scope: {
  onmessage?: (event: { readonly data: ToWorker }) => void;
  postMessage(message: FromWorker): void;
} = {
  postMessage(message) {
    heard.push(message);
    onMessage(message);
  },
};
const say = (data: ToWorker) => scope.onmessage!({ data });
const sphere: FieldNode = { type: 'shape', shape: { type: 'sphere', radius: 10 } };
const wish = (id: number, more: Partial<Make> = {}) =>
  say({ type: 'make', id, node: sphere, resolution: 24, mesh: 'worker', isEdited: false, ...more });
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

beforeAll(async () => {
  vi.stubGlobal('self', scope);
  await import('../../src/worker/field.ts');
});
beforeEach(() => void heard.splice(0));

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
    onMessage = (message) => {
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
    onMessage = () => {};
    expect(late).toEqual([]);
  });

  test('a newer wish at the second draft: of the older nothing more comes', async () => {
    onMessage = (message) => {
      if (message.id === 40 && message.type === 'made' && cellsOf(message) > 30) wish(41);
    };
    wish(40, { resolution: 150 });
    await made(41);
    onMessage = () => {};
    const ids = heard.filter(({ type }) => type === 'made').map(({ id }) => id);
    expect(ids).toEqual([40, 40, 41]);
  });

  test('gives up what is no longer wanted', async () => {
    onMessage = ({ type, id }) => {
      if (type !== 'made' || id !== 3) return;
      wish(4);
      wish(5);
    };
    wish(3, { resolution: 150 });
    await made(5);
    onMessage = () => {};
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
      expect([...bricks.grid].filter((place) => place >= 0).length).toBe(bricks.count);
      expect(bricks.count).toBeGreaterThan(0);
    }
  });

  test('makes what has sharp edges itself, whoever was to', async () => {
    const box: FieldNode = { type: 'shape', shape: { type: 'box', half: [10, 8, 6] } };
    wish(12, { node: box });
    const own = await made(12);
    wish(10, { node: box, mesh: 'page' });
    const sharp = await made(10);
    expect(sharp).toMatchObject({ hasCreases: true, evaluations: own.evaluations });
    expect(sharp.mesh).toEqual(own.mesh);
    wish(11);
    expect(await made(11)).toMatchObject({ hasCreases: false });
  });

  test('of a body that is edited what stays is kept, if the page says so', async () => {
    const limbs = (x: number): FieldNode => ({
      ...body(
        Array.from({ length: 8 }, (_, i) => ({
          skel: { type: 'segment', a: [12 * i, 0, 0], b: [12 * i, 20, i === 3 ? x : 0], weights: [1] },
        })),
      ),
    });
    wish(30, { node: limbs(0), resolution: 60, isEdited: true });
    const first = await made(30);
    wish(31, { node: limbs(1), resolution: 60, isEdited: true });
    const edit = await made(31);
    // no draft came before it
    expect(of(31).filter(({ type }) => type === 'made').length).toBe(1);
    expect(edit.evaluations).toBeLessThan(0.6 * first.evaluations);
    wish(32, { node: limbs(1), resolution: 60 });
    expect((await made(32)).evaluations).toBeGreaterThan(edit.evaluations);
  });

  test.each(['worker', 'page'] as const)('stops when told so: a mesh for the %s', async (mesh) => {
    const id = mesh === 'worker' ? 120 : 130;
    onMessage = (message) => {
      if (message.id === id) say({ type: 'stop', id: id + 1 });
    };
    wish(id, { resolution: 150, mesh });
    await vi.waitFor(() => expect(of(id).length).toBeGreaterThan(0));
    await new Promise((done) => setTimeout(done, 100));
    onMessage = () => {};
    // what it said first was the last
    expect(of(id).length).toBe(1);
    wish(id + 2);
    await made(id + 2);
  });
});
