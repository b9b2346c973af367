/**
 * Makes the bodies of fields beside the page, or the bricks from which its graphics device makes them; coarse ones first, each of which
 * stays on the page until the next is whole. The latest
 * wish wins: work is cut into slices, between which messages are heard, and what is no longer wanted is given up. Only the
 * coarsest is finished as long as anything is wanted, so that a slider that is being dragged is followed.
 */
import { bindField } from '../field/bind.ts';
import { brickBox } from '../field/bricks.ts';
import { DRAFT, type FromWorker, type Made, type Make, type ToWorker } from '../field/fieldWork.ts';
import { LiveField, type LiveStep } from '../field/liveField.ts';
import {
  type Fitted,
  type Located,
  latticed,
  locating,
  type Polygonized,
  polygonizing,
} from '../field/polygonize.ts';
import { cullsOnDevice } from '../gpu/bricks/cullsOnDevice.ts';
import { packBricks } from '../gpu/polygonize/lists.ts';
import { packEdit } from '../gpu/polygonize/packEdit.ts';
import { gpuWork } from '../gpu/polygonize/work.ts';
import { LiveMeshes } from './liveMeshes.ts';
import { sliced } from './sliced.ts';

/** What this file needs of the scope of a worker, whose types cannot be there beside those of a page. */
interface Scope {
  onmessage: ((event: MessageEvent<ToWorker>) => void) | null;
  postMessage(message: FromWorker, transfer: readonly ArrayBufferLike[]): void;
}

/** a draft of less than this share of the cells that come after it is worth its time */
const COARSER = 0.6;

const scope = self as unknown as Scope;
let wish: Make | null = null;
/** of what the page said last: other bodies are not wanted */
let latest = 0;
let working = false;
const kept = new LiveMeshes();
/** what the page has of a body whose mesh it makes itself */
let onPage: { readonly name: string; readonly cells: number; readonly field: LiveField } | null = null;

scope.onmessage = ({ data }) => {
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
      // the page has not got what was on its way
      onPage = null;
      say({ type: 'refused', id: job.id, message: error instanceof Error ? error.message : String(error) });
    }
  }
  working = false;
}

async function make(job: Make): Promise<void> {
  const { id, resolution } = job;
  const isLatest = () => id === latest;
  // what is edited needs no drafts: it is there as soon as they would be
  const isEdit = isEditOfKept(job);
  const levels = isEdit ? [resolution] : [...draftsBefore(resolution), resolution];
  for (const [i, cells] of levels.entries()) {
    const draft = i < levels.length - 1;
    // an edit is soon done, and given up it would have to be begun anew
    const wanted = () => isLatest() || ((draft || isEdit) && i === 0 && wish !== null);
    const start = performance.now();
    const step = await sliced(stepping(job, cells, draft), wanted, (share) =>
      say({ type: 'progress', id, share }),
    );
    const rest = () => ({ id, draft: draft || !isLatest(), milliseconds: performance.now() - start });
    if (step) hand('mesh' in step ? handed(step, rest) : handedBricks(step, job, rest));
    if (!isLatest()) return;
  }
}

function isEditOfKept({ name, resolution, mesh, node, isHeld }: Make): boolean {
  if (name === null) return false;
  if (mesh === 'worker') return kept.known(name, resolution)?.isEdit(node) ?? false;
  if (onPage?.name !== name || onPage.cells !== resolution || isHeld !== true) onPage = null;
  return onPage?.field.isEdit(node) ?? false;
}

/**
 * A mesh; or, where the page makes it, the bricks of it, or the lattice alone where devices find the bricks. Of what
 * is edited the page keeps them.
 */
function* stepping(
  { mesh, node, name }: Make,
  cells: number,
  isDraft: boolean,
): Generator<number, Meshed | Located | LiveStep | Fitted> {
  if (name !== null && !isDraft) {
    if (mesh === 'page') {
      onPage ??= { name, cells, field: new LiveField(cells, true) };
      return yield* onPage.field.locating(node);
    }
    const made = yield* kept.at(name, cells).making(node);
    kept.trim();
    return made;
  }
  const field = bindField(node);
  if (mesh === 'worker') return yield* polygonizing(field, cells);
  if (cullsOnDevice(node)) return yield* latticed(field, cells);
  return yield* locating(field, cells);
}

/** Cells of what is shown on the way: some, then half as many as in the end, a quarter of the work. */
function draftsBefore(resolution: number): readonly number[] {
  const half = Math.round(resolution / 2);
  if (DRAFT < COARSER * half) return [DRAFT, half];
  return DRAFT < COARSER * resolution ? [DRAFT] : [];
}

type Meshed = Pick<Polygonized, 'mesh' | 'bricks' | 'evaluations'> & { readonly isEdit?: boolean };
type Rest = () => Pick<Made, 'id' | 'draft' | 'milliseconds'>;
type Handed = readonly [message: FromWorker, transfer: readonly ArrayBufferLike[]];

function hand([message, transfer]: Handed): void {
  scope.postMessage(message, transfer);
}

function handed({ mesh, bricks, evaluations, isEdit = false }: Meshed, rest: Rest): Handed {
  const { positions, normals, uvs, indices, colours } = mesh;
  const arrays = [positions, normals, uvs, indices, colours].map(({ buffer }) => buffer);
  const facts = { lattice: bricks.lattice, evaluations, isEdit };
  return [{ type: 'made', mesh, ...facts, ...rest() }, arrays];
}

/** Edits of what the page has are no more than what they made anew. */
function handedBricks(step: Located | LiveStep | Fitted, { node }: Make, rest: Rest): Handed {
  if (!('bricks' in step)) {
    const { box, lattice, tally } = step;
    const facts = { box, lattice, isKept: false, evaluations: tally.work, workAVertex: 0 };
    return [{ type: 'bricks', node, bricks: null, ...facts, ...rest() }, []];
  }
  const { bricks, tally } = step;
  const isKept = 'renewed' in step;
  const isEdit = isKept && step.isEdit && !step.isGrown;
  const packed = isEdit ? packEdit(node, step) : packBricks(node, bricks);
  const asked = isEdit
    ? bricks.active.filter((_, place) => step.renewed.has(step.numbers[place]!))
    : bricks.active;
  const { nodes } = gpuWork({ ...bricks, active: asked });
  const box = isKept ? brickBox(bricks) : step.box;
  const { aVertex } = gpuWork(bricks);
  const facts = {
    lattice: bricks.lattice,
    box,
    isKept,
    evaluations: tally.work + nodes,
    workAVertex: aVertex,
  };
  return [
    { type: 'bricks', node, bricks: packed, ...facts, ...rest() },
    [packed.grid.buffer, packed.lists.buffer],
  ];
}

function say(message: FromWorker): void {
  scope.postMessage(message, []);
}
