/** The body on the page: made by a worker from the latest tree, the last good one kept while there is none. */
import type { FromWorker, Made, ToWorker, Wanted } from '../../field/fieldWork.ts';
import type { FieldNode } from '../../field/node.ts';
import { messageOf } from '../events.ts';
import { FieldOnGpu } from './fieldOnGpu.ts';

export class FieldBody {
  /** the last that was made */
  made: Made | null = null;
  /** largest difference of the GPU's values; null where the CPU took them */
  difference: number | null = null;
  /** 0–1 of the step under way; null: nothing is being made */
  progress: number | null = null;
  /** why there is no body for the latest tree, in words */
  problem: string | null = null;
  readonly #changed: () => void;
  #worker: Worker | null = null;
  #gpu: FieldOnGpu | null = null;
  #node: FieldNode | null = null;
  #latest = 0;

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
    this.#latest++;
    try {
      this.#node = tree();
    } catch (error) {
      this.#refuse(messageOf(error));
      return;
    }
    this.progress = 0;
    const values = onDevice && this.#gpu ? 'page' : 'worker';
    if (values === 'worker') this.difference = null;
    this.#post({ type: 'make', id: this.#latest, node: this.#node, resolution, values });
    this.#changed();
  }

  stop(): void {
    this.#worker?.terminate();
    this.#worker = null;
    this.device = null;
  }

  #post(message: ToWorker): void {
    this.#worker ??= this.#start();
    this.#worker.postMessage(message);
  }

  #start(): Worker {
    const worker = new Worker(new URL('../../worker/field.ts', import.meta.url), { type: 'module' });
    worker.onmessage = ({ data }: MessageEvent<FromWorker>) => {
      // what was asked for before the latest is of no use any more
      if (data.id === this.#latest) this.#hear(data);
    };
    worker.onerror = ({ message }) => this.#refuse(message || 'the worker could not start');
    return worker;
  }

  #hear(said: FromWorker): void {
    if (said.type === 'wanted') {
      void this.#answer(said);
      return;
    }
    if (said.type === 'refused') {
      this.#refuse(said.message);
      return;
    }
    if (said.type === 'progress') this.progress = said.share;
    if (said.type === 'made') {
      this.problem = null;
      this.made = said;
      if (!said.draft) this.progress = null;
    }
    this.#changed();
  }

  async #answer({ id, lattice }: Wanted): Promise<void> {
    try {
      const { values, difference } = await this.#gpu!.values(this.#node!, lattice);
      this.difference = difference;
      this.#post({ type: 'values', id, values });
    } catch (error) {
      this.difference = null;
      this.#post({ type: 'values', id, values: null });
      console.warn('rotund-field: the values come from the CPU.', error);
    }
  }

  #refuse(message: string): void {
    this.problem = message;
    this.progress = null;
    this.#changed();
  }
}
