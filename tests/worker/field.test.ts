/** The worker as its page hears it: a draft, then the body; the latest wish wins. */
import { beforeAll, beforeEach, describe, expect, test, vi } from 'vitest';
import type { FromWorker, Make, ToWorker } from '../../src/field/fieldWork.ts';
import { nodeCount } from '../../src/field/lattice.ts';
import type { FieldNode } from '../../src/field/node.ts';

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
  say({ type: 'make', id, node: sphere, resolution: 24, values: 'worker', ...more });
const of = (id: number) => heard.filter((message) => message.id === id);
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
    expect(fine.evaluations).toBeGreaterThan(64 ** 3);
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

  test('takes values from the page, or its own where the page has none', async () => {
    wish(8);
    const own = await made(8);
    wish(9, { values: 'page' });
    const asked = await vi.waitFor(() => {
      const last = of(9).at(-1);
      if (last?.type !== 'wanted') throw new Error('not yet');
      return last.lattice;
    });
    expect(asked).toEqual(own.lattice);
    say({ type: 'values', id: 9, values: null });
    expect((await made(9)).mesh.indices).toEqual(own.mesh.indices);

    wish(10, { values: 'page' });
    await vi.waitFor(() => expect(of(10).at(-1)?.type).toBe('wanted'));
    say({ type: 'values', id: 10, values: new Float32Array(nodeCount(asked)).fill(-1) });
    expect((await made(10)).mesh.indices.length).toBe(0);
  });
});
