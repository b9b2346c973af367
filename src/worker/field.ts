/**
 * Makes the bodies of fields beside the page, coarse ones first, each of which stays on the page until the next is whole. The latest
 * wish wins: work is cut into slices, between which messages are heard, and what is no longer wanted is given up. Only the
 * coarsest is finished as long as anything is wanted, so that a slider that is being dragged is followed.
 */
import { bindField } from '../field/bind.ts';
import type { FromWorker, Make, ToWorker } from '../field/fieldWork.ts';
import { type Polygonized, polygonizing } from '../field/polygonize.ts';

/** What this file needs of the scope of a worker, whose types cannot be there beside those of a page. */
interface Scope {
  onmessage: ((event: MessageEvent<ToWorker>) => void) | null;
  postMessage(message: FromWorker, transfer: readonly ArrayBufferLike[]): void;
}

/** ms of work between two looks at the messages */
const SLICE = 12;
/** cells: 20 000 values, some 20 ms for a dozen skels */
const DRAFT = 28;
/** a draft of less than this share of the cells that come after it is worth its time */
const COARSER = 0.6;

const scope = self as unknown as Scope;
let wish: Make | null = null;
/** of what the page said last: other bodies are not wanted */
let latest = 0;
let working = false;

scope.onmessage = ({ data }) => {
  if (data.type === 'values') return;
  wish = data.type === 'make' ? data : null;
  latest = data.id;
  if (wish && !working) void work();
};

async function work(): Promise<void> {
  working = true;
  while (wish) {
    const job: Make = wish;
    wish = null;
    try {
      await make(job);
    } catch (error) {
      say({ type: 'refused', id: job.id, message: error instanceof Error ? error.message : String(error) });
    }
  }
  working = false;
}

async function make({ id, node, resolution }: Make): Promise<void> {
  const field = bindField(node);
  const isLatest = () => id === latest;
  for (const [i, cells] of draftsBefore(resolution).entries()) {
    const wanted = () => isLatest() || (i === 0 && wish !== null);
    const start = performance.now();
    const draft = await sliced(id, polygonizing(field, cells), wanted);
    if (draft) hand(id, true, draft, null, start);
    if (!isLatest()) return;
  }
  const start = performance.now();
  const made = await sliced(id, polygonizing(field, resolution), isLatest);
  if (made) hand(id, false, made, null, start);
}

/** Cells of what is shown on the way: some, then half as many as in the end, a quarter of the work. */
function draftsBefore(resolution: number): readonly number[] {
  const half = Math.round(resolution / 2);
  if (DRAFT < COARSER * half) return [DRAFT, half];
  return DRAFT < COARSER * resolution ? [DRAFT] : [];
}

/** Null when it was given up. */
async function sliced<T>(id: number, work: Generator<number, T>, wanted: () => boolean): Promise<T | null> {
  let until = performance.now() + SLICE;
  for (;;) {
    const { done, value } = work.next();
    if (done) return value;
    if (performance.now() < until) continue;
    say({ type: 'progress', id, share: value });
    await breath();
    if (!wanted()) return null;
    until = performance.now() + SLICE;
  }
}

function hand(
  id: number,
  draft: boolean,
  { mesh, lattice, evaluations }: Polygonized,
  difference: number | null,
  start: number,
): void {
  const milliseconds = performance.now() - start;
  const { positions, normals, uvs, indices, colours } = mesh;
  const arrays = [positions, normals, uvs, indices, colours].map(({ buffer }) => buffer);
  const made = { mesh, lattice, evaluations, difference, milliseconds };
  scope.postMessage({ type: 'made', id, draft, ...made }, arrays);
}

function say(message: FromWorker): void {
  scope.postMessage(message, []);
}

const { port1, port2 } = new MessageChannel();

/** Lets messages in. A timer would take 4 ms. */
function breath(): Promise<void> {
  return new Promise((resolve) => {
    port1.onmessage = () => resolve();
    port2.postMessage(null);
  });
}
