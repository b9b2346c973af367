/** What waits for bodies hears of them until they are there or given up, and leaves nothing with who may give them up. */
import { expect, test } from 'vitest';
import { Needs } from '../../src/element/needs.ts';
import { body, sphere } from '../field/trees.ts';

const NODES = [sphere(3), body()];

/** Listeners that a signal still has. */
function watched() {
  const giver = new AbortController();
  const { signal } = giver;
  let listeners = 0;
  const add = signal.addEventListener.bind(signal);
  signal.addEventListener = ((type: string, listener: EventListener, options?: AddEventListenerOptions) => {
    listeners++;
    options?.signal?.addEventListener('abort', () => listeners--);
    add(type, listener, options);
  }) as AbortSignal['addEventListener'];
  return { giver, signal, listeners: () => listeners };
}

test('what is made is told, and nothing listens any more', async () => {
  const needs = new Needs();
  const { signal, listeners } = watched();
  const shares: number[] = [];
  const waiting = needs.wait(NODES, { signal, progress: (share) => shares.push(share) }, () => {});
  expect(listeners()).toBe(1);
  needs.tell((node) => (node === NODES[0] ? 1 : 0.5));
  needs.tell(() => 1);
  await waiting;
  expect(shares).toEqual([0.75, 1]);
  expect(listeners()).toBe(0);
  expect(needs.nodes).toEqual([]);
});

test('what is given up rejects with the reason', async () => {
  const needs = new Needs();
  const { giver, signal, listeners } = watched();
  let changes = 0;
  const waiting = needs.wait(NODES, { signal }, () => changes++);
  giver.abort(new Error('enough'));
  await expect(waiting).rejects.toThrow('enough');
  expect([changes, needs.nodes.length, listeners()]).toEqual([2, 0, 0]);
});
