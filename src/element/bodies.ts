/**
 * The bodies of a drawing, made beside the page: all of them coarsely first, so that there is something to look at, then finely.
 * What was made last stays until the next is there. A body that nobody wants any more is given up, one that cannot be made is
 * told of, and the drawing keeps it. Where no worker can start the page itself makes them, and waits.
 */
import { type Body, bodyMade, CELLS, keepBody, makeBody } from '../document/bodies.ts';
import { finerCells } from '../document/cells.ts';
import type { FromWorker, Made, ToWorker } from '../field/fieldWork.ts';
import type { FieldNode } from '../field/node.ts';
import { messageOf } from './events.ts';
import { WORDS } from './words.ts';

/** cells along the longest side, of what is to be seen at once */
export const DRAFT = 28;

/** What of a worker is used. */
export type BodyWorker = Pick<Worker, 'postMessage' | 'terminate' | 'onmessage' | 'onerror'>;

const startWorker = (): BodyWorker =>
  new Worker(new URL('../worker/field.ts', import.meta.url), { type: 'module' });

interface Job {
  readonly id: number;
  readonly node: FieldNode;
  readonly cells: number;
}

/** Something was made or refused; or work went on. */
export type News = 'made' | 'progress';

export class Bodies {
  /** 0–1 of the step under way */
  share = 0;
  readonly #changed: (news: News) => void;
  readonly #start: () => BodyWorker;
  readonly #problems = new WeakMap<FieldNode, string>();
  /** cells that were asked for of what is whole, before its thin places asked for more */
  readonly #asked = new WeakMap<FieldNode, number>();
  #cellsOf: (node: FieldNode) => number = () => CELLS;
  #wanted: readonly FieldNode[] = [];
  #job: Job | null = null;
  #latest = 0;
  #worker: BodyWorker | null = null;
  /** no worker starts here */
  #alone = false;
  /** ms, when the work began that is still going on */
  #since = 0;
  #waiting: (() => void)[] = [];

  constructor(changed: (news: News) => void, start = startWorker) {
    this.#changed = changed;
    this.#start = start;
  }

  /** Those that are seen, in so many cells: what is missing of them is made, and nothing else any more. */
  want(nodes: readonly FieldNode[], cellsOf: (node: FieldNode) => number = () => CELLS): void {
    this.#cellsOf = cellsOf;
    this.#wanted = [...new Set(nodes)];
    this.#go();
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
    return this.#wanted.every((node) => bodyMade(node) !== null || this.problem(node) !== null);
  }

  /** A draft is still all there is of what is thinner than its cells: pieces of it, or nothing, are in the picture. */
  get lacking(): boolean {
    return this.#wanted.some((node) => {
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
    this.#wanted = [];
    this.#rest();
  }

  #go(): void {
    const next = this.#next();
    if (!next) {
      this.#rest();
      return;
    }
    const { node, cells } = next;
    if (this.#job?.node === node && this.#job.cells === cells) return;
    if (!this.#job) this.#since = performance.now();
    this.#job = { id: ++this.#latest, node, cells };
    this.share = 0;
    this.#send(this.#job);
  }

  /** Drafts first. */
  #next(): Omit<Job, 'id'> | null {
    const open = this.#wanted.filter((node) => this.problem(node) === null);
    const unseen = open.find((node) => bodyMade(node) === null);
    if (unseen) return { node: unseen, cells: DRAFT };
    const coarse = open.find((node) => this.#missing(node) !== null);
    return coarse ? { node: coarse, cells: this.#missing(coarse)! } : null;
  }

  /** Cells that are still to come; null: none. As many as the command line takes unasked, so that files are the same. */
  #missing(node: FieldNode): number | null {
    const cells = this.#cellsOf(node);
    const made = bodyMade(node)!;
    if (this.#asked.get(node) !== cells && made.cells !== cells) return cells;
    const finer = finerCells(made);
    return made.cells === cells && finer > cells ? finer : null;
  }

  #send(job: Job): void {
    const { id, node, cells } = job;
    if (!this.#alone) this.#worker ??= this.#begin();
    const make: ToWorker = { type: 'make', id, node, resolution: cells, mesh: 'worker', isEdited: false };
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
    if (!job || said.id !== job.id) return;
    if (said.type === 'progress') {
      this.share = said.share;
      this.#changed('progress');
    } else if (said.type === 'refused') this.#refuse(job, said.message);
    else if (said.type === 'made') this.#take(job, said);
  }

  /** A draft on the way to a fine body is worth showing where it is finer than what is there. */
  #take(job: Job, { draft, mesh, evaluations }: Made): void {
    if (!draft) {
      this.#done(job, { mesh, cells: job.cells, evaluations });
      return;
    }
    const before = bodyMade(job.node);
    if (before && before.mesh.indices.length >= mesh.indices.length) return;
    keepBody(job.node, { mesh, cells: before?.cells ?? DRAFT, evaluations });
    this.#changed('made');
  }

  #done({ node, cells }: Job, body: Body): void {
    keepBody(node, body);
    if (cells === this.#cellsOf(node)) this.#asked.set(node, cells);
    if (cells !== DRAFT && body.mesh.indices.length === 0 && this.#missing(node) === null) {
      this.#problems.set(node, body.mesh.thin ? WORDS.tooThin : WORDS.noSurface);
    }
    this.#go();
    this.#changed('made');
  }

  #refuse({ node }: Job, message: string): void {
    this.#problems.set(node, message);
    this.#go();
    this.#changed('made');
  }

  /** Nothing to do: a worker that waits is memory for nothing. */
  #rest(): void {
    this.#worker?.terminate();
    this.#worker = null;
    this.#job = null;
    for (const resolve of this.#waiting.splice(0)) resolve();
  }
}
