/** What a session says and casts in exact mode: that it is on its way, at once; then what it is. Another style casts nothing. */
import { afterEach, beforeEach, expect, it, vi } from 'vitest';
import { makeBody } from '../../src/document/bodies.ts';
import { EMPTY_DRAWING, FRONT_VIEW } from '../../src/document/drawing.ts';
import { Session } from '../../src/element/session.ts';
import { WORDS } from '../../src/element/words.ts';
import type { FromExact, ToExact } from '../../src/field/exactWork.ts';
import type { FieldNode } from '../../src/field/node.ts';
import { OFFSETS } from '../../src/field/rayEdges.ts';
import type { Scene } from '../../src/scene/index.ts';
import { documentOf } from '../cli/drawings.ts';

const NODE: FieldNode = { type: 'shape', shape: { type: 'sphere', radius: 5 } };
const NONE = { surface: null, colours: null };

/** Answers when it is told to; there are no workers for meshes, which are there. */
class FakeWorker {
  onmessage: ((event: { readonly data: FromExact }) => void) | null = null;
  onerror: ((event: { readonly message: string }) => void) | null = null;
  todo: ToExact[] = [];
  constructor(address: URL) {
    if (!address.pathname.includes('exact')) throw new Error('none');
    workers.push(this);
  }
  postMessage(message: ToExact): void {
    if (message.type === 'cast') casts.add(message.id);
    this.todo.push(message);
  }
  ended = false;
  terminate(): void {
    this.ended = true;
  }
  answer(): void {
    const id = Math.max(...casts);
    for (let job = this.todo.shift(); job; job = this.todo.shift()) {
      if (job.id !== id || job.type === 'cast' || job.type === 'stop') continue;
      const { places } = { places: Uint32Array.of(), ...job };
      const data: FromExact =
        job.type === 'band'
          ? { ...job, ...NONE, places, work: 16 }
          : { ...job, ...NONE, count: job.places.length };
      this.onmessage?.({ data });
    }
  }
}

let workers: FakeWorker[];
let casts: Set<number>;
let session: Session;
let said: string[];
let refined: number | null;
const scene = {
  device: null,
  description: null,
  pixels: { width: 20, height: 32 },
  get refined() {
    return refined;
  },
  refine(_image: unknown, { alone = false } = {}) {
    refined = alone ? 0 : (refined ?? 0) + 1;
    return true;
  },
  render() {
    refined = 0;
  },
  setLook() {
    refined = null;
  },
  pick: () => null,
  ...{ sync() {}, guide() {}, setFaint() {}, select() {}, dispose() {} },
  rig: { update: () => false, view: () => FRONT_VIEW, setView() {} },
} as unknown as Scene;

/** Frames, as long as the picture is not whole. */
function rested(): void {
  for (let i = 0; i < 20; i++) {
    for (const worker of workers) worker.answer();
    vi.advanceTimersByTime(100);
  }
}

beforeEach(() => {
  vi.useFakeTimers();
  vi.stubGlobal('Worker', FakeWorker);
  vi.stubGlobal('requestAnimationFrame', (next: (now: number) => void) =>
    setTimeout(() => next(performance.now()), 16),
  );
  [workers, casts, said, refined] = [[], new Set(), [], null];
  makeBody(NODE, 24);
  const changed = () => {
    if (said.at(-1) !== session?.said) said.push(session?.said);
  };
  session = new Session({ changed, drawn() {}, committed() {}, selected() {}, moded() {} });
  session.open(
    { ...EMPTY_DRAWING, document: documentOf([{ type: 'addBody', name: 'Ball', node: NODE }]) },
    { fit: false, fresh: true },
  );
  session.attach(scene);
  vi.advanceTimersByTime(5000);
  said = [];
});
afterEach(() => {
  vi.unstubAllGlobals();
  vi.useRealTimers();
});

it('says at once that the exact surface is on its way, once to whoever listens, and then that it is there', () => {
  expect(session.seen).toMatch(/^mesh/);
  session.setMode('exact');
  expect(session.seen).toBe('exact on its way · 0 %');
  vi.advanceTimersByTime(500);
  expect(casts.size).toBe(1);
  expect(session.seen).toBe('exact on its way · 0 %');
  rested();
  expect(session.seen).toMatch(/^exact · 0.1 evaluations per pixel/);
  expect(said).toEqual([WORDS.onItsWay, WORDS.mode.exact]);
});

it('leaves what was said since', () => {
  session.setMode('exact');
  session.run({ type: 'removeParts', ids: ['nobody'] });
  session.said = 'another';
  rested();
  expect(session.said).toBe('another');
});

it('says once why there is none', () => {
  session.setMode('exact');
  vi.advanceTimersByTime(500);
  for (const worker of workers) worker.onerror?.({ message: 'no file' });
  expect(session.said).toBe(WORDS.noExact('no file'));
  expect(session.seen).toBe(WORDS.notExact);
  session.said = 'another';
  session.select(['nobody']);
  rested();
  expect(session.said).toBe('another');
});

it('says once that rows are missing, and that they are triangles as long as they are', () => {
  session.setMode('exact');
  vi.advanceTimersByTime(500);
  const begun = () => {
    for (const { onmessage } of workers) onmessage?.({ data: { type: 'begun', id: 0 } });
  };
  // whoever has the only band
  for (let deaths = 0; deaths < 2; deaths++) {
    begun();
    const band = (worker: FakeWorker) => !worker.ended && worker.todo.some(({ type }) => type === 'band');
    workers.find(band)!.onerror?.({ message: 'no room' });
  }
  expect(session.said).toBe(WORDS.rowsLost);
  rested();
  expect(session.seen).toMatch(/^exact · .* · some rows triangles$/);
  session.said = 'another';
  session.setStyle('toon', 'toon');
  session.said = 'another';
  rested();
  expect(session.said).toBe('another');
});

it('picks bodies by rays in exact mode, also where there are no triangles', () => {
  const place = [10, 16] as const;
  session.size = { width: 20, height: 32 };
  expect(session.pick(...place)).toBeNull();
  session.setMode('exact');
  const [ball] = session.document.parts;
  expect(session.pick(...place)).toMatchObject({ id: ball!.id, normal: [0, 0, 1] });
  expect(session.pick(...place, [ball!.id])).toBeNull();
  session.run({ type: 'showParts', ids: [ball!.id], visible: false });
  expect(session.pick(...place)).toBeNull();
});

it('casts nothing again for another style, another selection, triangles and back', () => {
  session.setMode('exact');
  vi.advanceTimersByTime(500);
  // while it is being cast
  session.setStyle('hbed-lines', 'lines');
  rested();
  expect([...casts].length).toBe(1);
  for (const change of [
    () => session.setStyle('toon', 'toon'),
    () => session.setBackground('black'),
    () => session.select(session.document.parts.map(({ id }) => id)),
    () => session.setMode('mesh'),
    () => session.setMode('exact'),
  ]) {
    change();
    rested();
  }
  expect(casts.size).toBe(1);
  expect(refined).toBe(1 + OFFSETS.length);
});
