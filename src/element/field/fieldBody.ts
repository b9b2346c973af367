/**
 * The body on the page: of the latest tree, made by a worker or of the worker's bricks on the graphics device; the last good one is kept
 * while there is none.
 */
import type { FromWorker, Located, Made, ToWorker } from '../../field/fieldWork.ts';
import type { FieldNode } from '../../field/node.ts';
import { livePolygonizer } from '../../gpu/polygonize/livePolygonizer.ts';
import { gpuPolygonizer } from '../../gpu/polygonize/polygonizer.ts';
import { isOnDevice } from '../../scene/deviceMesh.ts';
import { messageOf } from '../events.ts';
import { FieldOnGpu, type MadeOnGpu } from './fieldOnGpu.ts';
import { FIELD_WORDS } from './fieldWords.ts';
import type { Shown } from './shown.ts';

interface Wish {
  readonly node: FieldNode;
  readonly resolution: number;
  readonly onDevice: boolean;
}

/** ms that a device takes for a body when its programs are there, and more */
const PATIENCE = 700;

export class FieldBody {
  /** the last that was made */
  made: Shown | null = null;
  /** 0–1 of the step under way; null: nothing is being made */
  progress: number | null = null;
  /** the graphics device has been at work so long that it must be at its programs, which are compiled for each make of bodies once */
  isPreparing = false;
  /** why there is no body for the latest tree, in words */
  problem: string | null = null;
  readonly #changed: () => void;
  #worker: Worker | null = null;
  #gpu: FieldOnGpu | null = null;
  #wish: Wish | null = null;
  #latest = 0;
  #patience: ReturnType<typeof setTimeout> | undefined;
  /** ms, when the latest body was asked for */
  #since = 0;
  /** the device has what the worker handed over last */
  #isHeld = false;
  /** the last tree that was refused: nothing from before it is shown any more */
  #refused = 0;
  /** why the graphics device did not make the latest body, though it was to; null: it did, or was not to */
  #failure: string | null = null;
  /** gives back what is shown, where it lies on the device */
  #release: () => void = () => {};

  /** `changed` hears of every change of what is here. */
  constructor(changed: () => void) {
    this.#changed = changed;
  }

  /** The device for meshes on the GPU; null: there is none. What lies on the one before goes; without another the worker makes it. */
  set device(device: GPUDevice | null) {
    this.#gpu?.destroy();
    this.#prepared();
    const isLost = this.#isOnDevice;
    if (isLost) this.made = null;
    this.#takeBack(() => {});
    const listener = {
      made: (made: MadeOnGpu) => this.#hearDevice(made),
      failed: (of: Located, error: unknown) => this.#fallBack(of, error),
    };
    const polygonizer = device && gpuPolygonizer(device);
    this.#gpu = polygonizer && new FieldOnGpu(polygonizer, livePolygonizer(device, polygonizer), listener);
    this.#isHeld = false;
    if (!device && this.#wish?.onDevice && (isLost || this.progress !== null)) this.#ask(null);
  }

  get canUseGpu(): boolean {
    return this.#gpu !== null;
  }

  /** `tree` may throw a FieldError: the last body stays. */
  make(tree: () => FieldNode, resolution: number, onDevice: boolean): void {
    try {
      this.#wish = { node: tree(), resolution, onDevice };
    } catch (error) {
      const id = ++this.#latest;
      this.#wish = null;
      this.#worker?.postMessage({ type: 'stop', id } satisfies ToWorker);
      this.#refuse(messageOf(error));
      return;
    }
    this.#ask(null);
  }

  stop(): void {
    this.#worker?.terminate();
    this.#worker = null;
    this.#wish = null;
    this.progress = null;
    this.device = null;
  }

  get #isOnDevice(): boolean {
    return this.made !== null && isOnDevice(this.made.mesh);
  }

  /** For the latest wish; `failure`: why the worker is to make it, though the device was to. */
  #ask(failure: string | null): void {
    if (!this.#wish) return;
    const id = ++this.#latest;
    if (failure === null) this.#since = performance.now();
    const { node, resolution, onDevice } = this.#wish;
    this.#failure = failure ?? (onDevice && !this.#gpu ? FIELD_WORDS.noDevice : null);
    const mesh = onDevice && this.#failure === null ? 'page' : 'worker';
    this.progress = 0;
    this.#worker ??= this.#start();
    const make: ToWorker = { type: 'make', id, node, resolution, mesh, name: 'body', isHeld: this.#isHeld };
    this.#worker.postMessage(make);
    // the device gets all that comes from now on
    if (mesh === 'page') this.#isHeld = true;
    this.#changed();
  }

  #start(): Worker {
    const worker = new Worker(new URL('../../worker/field.ts', import.meta.url), { type: 'module' });
    worker.onmessage = ({ data }: MessageEvent<FromWorker>) => this.#hear(data);
    worker.onerror = ({ message }) => this.#refuse(message || FIELD_WORDS.noWorker);
    return worker;
  }

  #hear(said: FromWorker): void {
    const isLatest = said.id === this.#latest;
    switch (said.type) {
      case 'refused':
        if (isLatest) this.#refuse(said.message);
        return;
      case 'progress':
        if (!isLatest) return;
        this.progress = said.share;
        this.#changed();
        return;
      case 'bricks':
        // edits may follow
        if (said.isKept || this.#isWelcome(said)) this.#handOver(said);
        return;
      case 'made':
        if (this.#isWelcome(said)) this.#show(this.#shown(said), () => {});
    }
  }

  #handOver(bricks: Located): void {
    this.#gpu?.make(bricks);
    this.#patience ??= setTimeout(() => {
      this.isPreparing = true;
      this.#changed();
    }, PATIENCE);
  }

  #prepared(): void {
    clearTimeout(this.#patience);
    this.#patience = undefined;
    this.isPreparing = false;
  }

  /** Under a slider that is being dragged there is time for drafts only. The device and the worker may come in any order. */
  #isWelcome({ id, draft }: Pick<Made, 'id' | 'draft'>): boolean {
    const before = this.made;
    const isLate = before !== null && (id < before.id || (id === before.id && draft && !before.draft));
    return !isLate && (id === this.#latest || (draft && id > this.#refused));
  }

  #shown(made: Made): Shown {
    const { mesh } = made;
    return {
      ...made,
      milliseconds: this.#took(made),
      thin: mesh.thin ?? null,
      vertices: mesh.positions.length / 3,
      triangles: mesh.indices.length / 3,
      maker: FIELD_WORDS.worker(this.#failure),
    };
  }

  /** Of what was asked for before only its own step is known. */
  #took({ id, milliseconds }: Pick<Made, 'id' | 'milliseconds'>): number {
    return id === this.#latest ? performance.now() - this.#since : milliseconds;
  }

  #hearDevice({ of, mesh, vertices, triangles, work, milliseconds, release }: MadeOnGpu): void {
    this.#prepared();
    if (!this.#isWelcome(of)) {
      release();
      return;
    }
    if (triangles === 0 && !of.draft && of.id === this.#latest) {
      // only the CPU tells whether there is nothing, or only what is too thin
      release();
      this.#isHeld = false;
      this.#ask(FIELD_WORDS.nothingOnDevice);
      return;
    }
    const { id, draft, lattice, workAVertex } = of;
    const evaluations = of.evaluations + work + workAVertex * vertices;
    const facts = {
      lattice,
      evaluations,
      milliseconds: this.#took({ id, milliseconds: of.milliseconds + milliseconds }),
    };
    this.#show({ id, draft, mesh, vertices, triangles, ...facts, maker: FIELD_WORDS.device }, release);
  }

  #fallBack({ id }: Located, error: unknown): void {
    this.#prepared();
    this.#isHeld = false;
    if (id !== this.#latest) return;
    console.warn('The body comes from the CPU.', error);
    this.#ask(FIELD_WORDS.deviceFailed);
  }

  /** What was shown before stays until the scene has this. */
  #show(made: Shown, release: () => void): void {
    this.made = made;
    this.problem = null;
    if (!made.draft && made.id === this.#latest) this.progress = null;
    this.#changed();
    this.#takeBack(release);
  }

  #takeBack(next: () => void): void {
    this.#release();
    this.#release = next;
  }

  #refuse(message: string): void {
    this.#refused = this.#latest;
    this.problem = message;
    this.progress = null;
    this.#changed();
  }
}
