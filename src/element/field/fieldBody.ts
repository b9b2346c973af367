/** The body on the page: made by a worker from the latest tree, the last good one kept while there is none. */
import type { FromWorker, Made, ToWorker, Wanted } from '../../field/fieldWork.ts';
import type { Lattice } from '../../field/lattice.ts';
import type { FieldNode } from '../../field/node.ts';
import { messageOf } from '../events.ts';
import { FieldOnGpu } from './fieldOnGpu.ts';
import { FIELD_WORDS } from './fieldWords.ts';

export class FieldBody {
  /** the last that was made */
  made: Made | null = null;
  /** 0–1 of the step under way; null: nothing is being made */
  progress: number | null = null;
  /** why there is no body for the latest tree, in words */
  problem: string | null = null;
  readonly #changed: () => void;
  #worker: Worker | null = null;
  #gpu: FieldOnGpu | null = null;
  #node: FieldNode | null = null;
  #latest = 0;
  /** the last tree that was refused: nothing from before it is shown any more */
  #refused = 0;

  /** `changed` hears of every change of what is here. */
  constructor(changed: () => void) {
    this.#changed = changed;
  }

  /** The device for values on the GPU; null: there is none. */
  set device(device: GPUDevice | null) {
    this.#gpu?.destroy();
    this.#gpu = device ? new FieldOnGpu(device) : null;
  }

  get canUseGpu(): boolean {
    return this.#gpu !== null;
  }

  /** `tree` may throw a FieldError: the last body stays. */
  make(tree: () => FieldNode, resolution: number, onDevice: boolean): void {
    const id = ++this.#latest;
    try {
      this.#node = tree();
    } catch (error) {
      this.#worker?.postMessage({ type: 'stop', id } satisfies ToWorker);
      this.#refuse(messageOf(error));
      return;
    }
    this.progress = 0;
    const values = onDevice && this.#gpu ? 'page' : 'worker';
    this.#worker ??= this.#start();
    this.#worker.postMessage({ type: 'make', id, node: this.#node, resolution, values } satisfies ToWorker);
    this.#changed();
  }

  stop(): void {
    this.#worker?.terminate();
    this.#worker = null;
    this.progress = null;
    this.device = null;
  }

  #start(): Worker {
    const worker = new Worker(new URL('../../worker/field.ts', import.meta.url), { type: 'module' });
    worker.onmessage = ({ data }: MessageEvent<FromWorker>) => {
      if (data.id === this.#latest) this.#hear(data, worker);
      // under a slider that is being dragged there is no time for more
      else if (data.type === 'made' && data.draft && data.id > this.#refused) this.#show(data);
    };
    worker.onerror = ({ message }) => this.#refuse(message || FIELD_WORDS.noWorker);
    return worker;
  }

  /** Of what was asked for last. */
  #hear(said: FromWorker, worker: Worker): void {
    switch (said.type) {
      case 'wanted':
        void this.#answer(said, worker);
        return;
      case 'refused':
        this.#refuse(said.message);
        return;
      case 'progress':
        this.progress = said.share;
        this.#changed();
        return;
      case 'made':
        if (!said.draft) this.progress = null;
        this.#show(said);
    }
  }

  #show(made: Made): void {
    this.made = made;
    this.problem = null;
    this.#changed();
  }

  /** By the time there are values the element may be gone, or something else be wanted: nobody waits for them then. */
  async #answer({ id, lattice }: Wanted, worker: Worker): Promise<void> {
    const isWaiting = () => worker === this.#worker && id === this.#latest;
    const values = await this.#values(lattice).catch((error: unknown) => {
      if (isWaiting()) console.warn('The values come from the CPU.', error);
      return null;
    });
    if (!isWaiting()) return;
    const answer: ToWorker = { type: 'values', id, values };
    worker.postMessage(answer, values ? [values.buffer] : []);
  }

  /** Null where the device went since the tree was sent. */
  async #values(lattice: Lattice): Promise<Float32Array<ArrayBuffer> | null> {
    return this.#gpu && this.#node ? this.#gpu.values(this.#node, lattice) : null;
  }

  #refuse(message: string): void {
    this.#refused = this.#latest;
    this.problem = message;
    this.progress = null;
    this.#changed();
  }
}
