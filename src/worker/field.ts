/**
 * Makes the bodies of fields beside the page, or the bricks from which its graphics device makes them; coarse ones first, each of which
 * stays on the page until the next is whole. The latest
 * wish wins: work is cut into slices, between which messages are heard, and what is no longer wanted is given up. Only the
 * coarsest is finished as long as anything is wanted, so that a slider that is being dragged is followed.
 */
import { bindField } from '../field/bind.ts';
import { hasCreases, isSmooth } from '../field/bricks.ts';
import type { FromWorker, Made, Make, ToWorker } from '../field/fieldWork.ts';
import { LiveMesh } from '../field/liveMesh.ts';
import {
  type Fitted,
  type Located,
  latticed,
  locating,
  type Polygonized,
  polygonizing,
} from '../field/polygonize.ts';
import type { TreeField } from '../field/treeField.ts';
import { cullsOnDevice } from '../gpu/bricks/cullsOnDevice.ts';
import { packBricks } from '../gpu/polygonize/lists.ts';
import { gpuWork } from '../gpu/polygonize/work.ts';

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
/** nothing is kept */
const NOTHING = { cells: 0, mesh: new LiveMesh(0) };
let live = NOTHING;

scope.onmessage = ({ data }) => {
  wish = data.type === 'make' ? data : null;
  if (!wish?.isEdited) live = NOTHING;
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

async function make(job: Make): Promise<void> {
  const { id, node, resolution } = job;
  const field = bindField(node);
  const isLatest = () => id === latest;
  // what is edited needs no drafts: it is there as soon as they would be
  const isEdit = job.isEdited && live.cells === resolution && job.mesh === 'worker' && live.mesh.isEdit(node);
  const levels = isEdit ? [resolution] : [...draftsBefore(resolution), resolution];
  for (const [i, cells] of levels.entries()) {
    const draft = i < levels.length - 1;
    // an edit is soon done, and given up it would have to be begun anew
    const wanted = () => isLatest() || ((draft || isEdit) && i === 0 && wish !== null);
    const start = performance.now();
    const step = await sliced(id, stepping(job, field, cells, draft), wanted);
    const rest = () => ({ id, draft: draft || !isLatest(), milliseconds: performance.now() - start });
    if (step) hand('mesh' in step ? handed(step, rest) : handedBricks(step, job, rest));
    if (!isLatest()) return;
  }
}

/**
 * A mesh; or, where the page makes it and it has no creases, which graphics devices would cut off, the bricks of it, or the lattice alone
 * where devices find the bricks.
 */
function* stepping(
  { mesh, node, isEdited }: Make,
  field: TreeField,
  cells: number,
  isDraft: boolean,
): Generator<number, Meshed | Located | Fitted> {
  if (mesh === 'worker') {
    return yield* isDraft || !isEdited ? polygonizing(field, cells) : liveOf(cells).making(node);
  }
  // what may have creases is known by its bricks alone
  if (isSmooth(field) && cullsOnDevice(node)) return yield* latticed(field, cells);
  const located = yield* locating(field, cells);
  return hasCreases(located.bricks) ? yield* polygonizing(field, cells, field.box, located) : located;
}

/** The body of the last wish at so many cells: what a next one leaves of it is kept. */
function liveOf(cells: number): LiveMesh {
  if (live.cells !== cells) live = { cells, mesh: new LiveMesh(cells) };
  return live.mesh;
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

type Meshed = Pick<Polygonized, 'mesh' | 'bricks' | 'evaluations'>;
type Rest = () => Pick<Made, 'id' | 'draft' | 'milliseconds'>;
type Handed = readonly [message: FromWorker, transfer: readonly ArrayBufferLike[]];

function hand([message, transfer]: Handed): void {
  scope.postMessage(message, transfer);
}

function handed({ mesh, bricks, evaluations }: Meshed, rest: Rest): Handed {
  const { positions, normals, uvs, indices, colours } = mesh;
  const arrays = [positions, normals, uvs, indices, colours].map(({ buffer }) => buffer);
  const facts = { lattice: bricks.lattice, evaluations, hasCreases: hasCreases(bricks) };
  return [{ type: 'made', mesh, ...facts, ...rest() }, arrays];
}

function handedBricks(found: Located | Fitted, { node }: Make, rest: Rest): Handed {
  const { box, tally } = found;
  if ('lattice' in found) {
    const facts = { box, lattice: found.lattice, evaluations: tally.work, workAVertex: 0 };
    return [{ type: 'bricks', node, bricks: null, ...facts, ...rest() }, []];
  }
  const packed = packBricks(node, found.bricks);
  const { nodes, aVertex } = gpuWork(found.bricks);
  const facts = { box, lattice: packed.lattice, evaluations: tally.work + nodes, workAVertex: aVertex };
  return [
    { type: 'bricks', node, bricks: packed, ...facts, ...rest() },
    [packed.grid.buffer, packed.lists.buffer],
  ];
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
