/**
 * The bodies of a drawing, made beside the page: all of them coarsely first, so that there is something to look at, then finely.
 * What was made last stays until the next is there; of a body that is edited the worker makes only what the change reaches. A body that nobody
 * wants any more is given up, one that cannot be made is told of, and the drawing keeps it. Where no worker can start the page itself makes
 * them, and waits. Files are of bodies that are made at once, whatever is shown.
 */
import { type Body, bodyMade, CELLS, dropBody, keepBody, makeBody } from '../document/bodies.ts';
import { finerCells, measureBody } from '../document/cells.ts';
import { DRAFT, type FromWorker, type Made, type ToWorker } from '../field/fieldWork.ts';
import type { FieldNode } from '../field/node.ts';
import { areAlike } from '../field/treeChanges.ts';
import { messageOf } from './events.ts';
import { Needs, type Waiting } from './needs.ts';
import { WORDS } from './words.ts';

/** What of a worker is used. */
export type BodyWorker = Pick<Worker, 'postMessage' | 'terminate' | 'onmessage' | 'onerror'>;

const startWorker = (): BodyWorker =>
  new Worker(new URL('../worker/field.ts', import.meta.url), { type: 'module' });

/** A body that is seen; its name stays when its tree is another one. */
export interface Named {
  readonly id: string;
  readonly node: FieldNode;
}

interface Job {
  readonly id: number;
  readonly node: FieldNode;
  readonly cells: number;
  /** under which the worker keeps it for edits; null: it does not */
  readonly name: string | null;
}

/** Something was made or refused; or work went on. */
export type News = 'made' | 'progress';

export class Bodies {
  /** 0–1 of the step under way */
  share = 0;
  /** Edits are likely: what they leave of a body is kept. */
  expectsEdits = true;
  readonly #changed: (news: News) => void;
  readonly #start: () => BodyWorker;
  readonly #problems = new WeakMap<FieldNode, string>();
  /** cells that were asked for of what is whole, before its thin places asked for more */
  readonly #asked = new WeakMap<FieldNode, number>();
  /** names of those whose making was begun */
  readonly #sent = new WeakMap<FieldNode, string>();
  #cellsOf: (node: FieldNode) => number = () => CELLS;
  /** each tree once */
  #wanted: readonly Named[] = [];
  /** by name */
  #seen: ReadonlyMap<string, FieldNode> = new Map();
  readonly #needs = new Needs();
  #job: Job | null = null;
  /** jobs that were given up, which the worker may still come to an end with */
  #givenUp: readonly Job[] = [];
  #latest = 0;
  #worker: BodyWorker | null = null;
  /** no worker starts here */
  #alone = false;
  #isAtWork = false;
  /** all moves: drafts will do */
  #isRough = false;
  /** ms, when the work began that is still going on */
  #since = 0;
  #waiting: (() => void)[] = [];

  constructor(changed: (news: News) => void, start = startWorker) {
    this.#changed = changed;
    this.#start = start;
  }

  /**
   * Those that are seen, in so many cells: what is missing of them is made, and nothing else any more but for files. `isRough`: they are others
   * again soon. Drafts will do, and one that is under way is finished before the next, or there would never be anything to see.
   */
  want(
    bodies: readonly Named[],
    cellsOf: (node: FieldNode) => number = () => CELLS,
    { isRough = false } = {},
  ): void {
    this.#cellsOf = cellsOf;
    for (const { id, node } of bodies) standIn(this.#seen.get(id), node);
    this.#seen = new Map(bodies.map(({ id, node }) => [id, node]));
    const names = new Map(bodies.map(({ id, node }) => [node, id]));
    this.#wanted = [...names].map(([node, id]) => ({ id, node }));
    this.#isRough = isRough;
    if (!isRough || this.#job?.cells !== DRAFT) this.#go();
  }

  /** What is wanted next is of another drawing, whatever the names. */
  forget(): void {
    this.#seen = new Map();
  }

  /** Resolves when each of them is made as files have to be, or cannot be made; also when nobody sees them any more. */
  exactly(nodes: readonly FieldNode[], waiting: Waiting = {}): Promise<void> {
    return this.#needs.wait(nodes, waiting, () => this.#go());
  }

  /** What is being made; null: nothing. */
  get making(): FieldNode | null {
    return this.#job?.node ?? null;
  }

  /** ms that work has gone on for */
  get elapsed(): number {
    return this.#job ? performance.now() - this.#since : 0;
  }

  /** There is something to see of each, or will never be. */
  get drafted(): boolean {
    return this.#wanted.every(({ node }) => bodyMade(node) !== null || this.problem(node) !== null);
  }

  /** A draft is still all there is of what is thinner than its cells: pieces of it, or nothing, are in the picture. */
  get lacking(): boolean {
    return this.#wanted.some(({ node }) => {
      const made = bodyMade(node);
      const isDraft = made?.cells === DRAFT && this.problem(node) === null;
      return isDraft && (made.mesh.indices.length === 0 || Boolean(made.mesh.thin));
    });
  }

  /** Why there is no such body, in words. */
  problem(node: FieldNode): string | null {
    return this.#problems.get(node) ?? null;
  }

  /** Resolves when all of them are made, or cannot be. */
  async settled(): Promise<void> {
    if (this.#job) await new Promise<void>((resolve) => this.#waiting.push(resolve));
  }

  /** Nobody is there to see them. */
  stop(): void {
    this.want([]);
  }

  #go(): void {
    this.#tell();
    const next = this.#next();
    if (!next) {
      this.#rest();
      return;
    }
    const { node, cells, name } = next;
    const job = this.#job;
    if (job?.node === node && job.cells === cells && job.name === name) return;
    if (!this.#isAtWork) this.#since = performance.now();
    this.#isAtWork = true;
    if (job) this.#givenUp = [...this.#givenUp, job];
    this.#job = { id: ++this.#latest, node, cells, name };
    this.share = 0;
    this.#send(this.#job);
  }

  /** Drafts first, then what a file waits for; nothing finer while all moves. */
  #next(): Omit<Job, 'id'> | null {
    const isOpen = (node: FieldNode) => this.problem(node) === null;
    // while all moves, the mesh of what was there before is soon far off
    const isUnseen = (body: Body | null) => body === null || (this.#isRough && body.cells === 0);
    const unseen = this.#wanted.find(({ node }) => isOpen(node) && isUnseen(bodyMade(node)));
    if (unseen) return { node: unseen.node, cells: DRAFT, name: null };
    const needed = this.#needs.nodes.find((node) => !this.#isDone(node));
    const job = this.#job;
    // what is under way may turn out to be what the file wants
    if (job && job.cells !== DRAFT && this.#needs.nodes.includes(job.node) && !this.#isDone(job.node))
      return job;
    if (needed) return { node: needed, cells: this.#missing(needed, true)!, name: null };
    if (this.#isRough) return null;
    const coarse = this.#wanted.find(({ node }) => isOpen(node) && this.#missing(node) !== null);
    if (!coarse) return null;
    return {
      node: coarse.node,
      cells: this.#missing(coarse.node)!,
      name: this.expectsEdits ? coarse.id : null,
    };
  }

  /** Cells that are still to come; null: none. As many as the command line takes unasked, so that files are the same. */
  #missing(node: FieldNode, isForFile = false): number | null {
    const cells = this.#cellsOf(node);
    const made = bodyMade(node);
    if (!made || (isForFile && made.isEdit)) return cells;
    if (this.#asked.get(node) !== cells && made.cells !== cells) return cells;
    const finer = finerCells(made);
    return made.cells === cells && finer > cells ? finer : null;
  }

  /** As files have to be, or never will be. */
  #isDone(node: FieldNode): boolean {
    return this.problem(node) !== null || this.#missing(node, true) === null;
  }

  /** Whoever waits for bodies for a file, how much of them is there. */
  #tell(): void {
    const { share } = this;
    const underWay = this.#job && this.#job.cells !== DRAFT ? this.#job.node : null;
    this.#needs.tell((node) => (this.#isDone(node) ? 1 : node === underWay ? Math.min(share, 0.99) : 0));
  }

  #send(job: Job): void {
    const { id, node, cells, name } = job;
    const of = this.#wanted.find((wanted) => wanted.node === node);
    if (of) this.#sent.set(node, of.id);
    if (!this.#alone) this.#worker ??= this.#begin();
    const make: ToWorker = { type: 'make', id, node, resolution: cells, mesh: 'worker', name };
    if (this.#worker) this.#worker.postMessage(make);
    // not at once: whoever wants a body is not to be told of it while asking
    else setTimeout(() => this.#makeHere(job));
  }

  #begin(): BodyWorker | null {
    try {
      const worker = this.#start();
      worker.onmessage = ({ data }: MessageEvent<FromWorker>) => this.#hear(data);
      worker.onerror = () => this.#lose();
      return worker;
    } catch {
      this.#alone = true;
      return null;
    }
  }

  /** The file of the worker could not be fetched, or may not be run. */
  #lose(): void {
    this.#alone = true;
    this.#worker?.terminate();
    this.#worker = null;
    if (this.#job) this.#send(this.#job);
  }

  #makeHere(job: Job): void {
    if (this.#job !== job) return;
    try {
      this.#done(job, makeBody(job.node, job.cells));
    } catch (error) {
      this.#refuse(job, messageOf(error));
    }
  }

  #hear(said: FromWorker): void {
    const job = this.#job;
    const late = this.#givenUp.find(({ id }) => id === said.id);
    if (said.type === 'made' && late) this.#takeLate(late, said);
    this.#givenUp = this.#givenUp.filter(({ id }) => id > said.id);
    if (!job || said.id !== job.id) return;
    if (said.type === 'progress') {
      this.share = said.share;
      this.#tell();
      this.#changed('progress');
    } else if (said.type === 'refused') this.#refuse(job, said.message);
    else if (said.type === 'made') this.#take(job, said);
  }

  /** A draft on the way to a fine body is worth showing where it is finer than what is there, or what is there is of another tree. */
  #take(job: Job, { draft, mesh, evaluations, isEdit }: Made): void {
    if (!draft) {
      this.#done(job, { mesh, cells: job.cells, evaluations, isEdit });
      return;
    }
    const before = bodyMade(job.node);
    const isOwn = before !== null && before.cells > 0;
    if (isOwn && before.mesh.indices.length >= mesh.indices.length) return;
    keepBody(job.node, { mesh, cells: isOwn ? before.cells : DRAFT, evaluations });
    this.#changed('made');
  }

  /** An edit that another one followed: while that is under way it is nearer to it than what is shown. */
  #takeLate({ node, cells, name }: Job, { mesh, evaluations, isEdit }: Made): void {
    if (!isEdit) return;
    keepBody(node, { mesh, cells, evaluations, isEdit });
    const next = this.#wanted.find(({ id }) => id === name);
    if (!next || bodyMade(next.node)?.cells !== 0) return;
    keepBody(next.node, { mesh, cells: 0, evaluations });
    this.#changed('made');
  }

  #done({ node, cells }: Job, body: Body): void {
    keepBody(node, body);
    this.#follow(node, body);
    // cells of one depend on the boxes of all: one at a time, or a hundred would block the page
    if (cells === DRAFT && this.#wanted.length > 1 && !this.#isRough) measureBody(node);
    else if (cells === this.#cellsOf(node)) this.#asked.set(node, cells);
    this.#job = null;
    if (cells !== DRAFT && body.mesh.indices.length === 0 && this.#missing(node) === null) {
      this.#problems.set(node, body.mesh.thin ? WORDS.tooThin : WORDS.noSurface);
    }
    this.#go();
    this.#changed('made');
  }

  /** What moved on while its draft was made is nearer to that than to what is shown. */
  #follow(node: FieldNode, body: Body): void {
    const id = this.#sent.get(node);
    const next = this.#wanted.find((wanted) => wanted.id === id && wanted.node !== node);
    if (!next || (bodyMade(next.node)?.cells ?? 0) > 0 || !areAlike(node, next.node)) return;
    keepBody(next.node, { ...body, cells: 0 });
  }

  #refuse({ node }: Job, message: string): void {
    this.#problems.set(node, message);
    this.#job = null;
    if (bodyMade(node)?.cells === 0) dropBody(node);
    this.#go();
    this.#changed('made');
  }

  /** Nothing to do: a worker that waits is memory for nothing, where no edits are awaited. */
  #rest(): void {
    if (this.#job) this.#worker?.postMessage({ type: 'stop', id: ++this.#latest });
    this.#givenUp = [];
    if (!this.expectsEdits || this.#wanted.length === 0) {
      this.#worker?.terminate();
      this.#worker = null;
    }
    this.#job = null;
    this.#isAtWork = false;
    for (const resolve of this.#waiting.splice(0)) resolve();
  }
}

/** The mesh of the tree before an edit is to be seen until there is one of the tree after it. */
function standIn(before: FieldNode | undefined, after: FieldNode): void {
  const body = before ? bodyMade(before) : null;
  if (!body || bodyMade(after) !== null) return;
  if (areAlike(before!, after)) keepBody(after, { ...body, cells: 0 });
}
